// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Boxes of what is at exact positions.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "box.hpp"
#include "double_double.hpp"

namespace gcv {

// Doubles that enclose x + y; the lower one is finite, or -infinity, the upper one likewise.
inline double sum_below(double x, double y) {
  const double sum = x + y;
  const double error = rounding_error(x, y, sum);
  const double below = error >= 0 ? sum : std::nextafter(sum, -infinity);
  return std::min(below, std::numeric_limits<double>::max());
}
inline double sum_above(double x, double y) { return -sum_below(-x, -y); }

// Holds the box, moved by a vector.
inline Box moved_outwards(const Box& box, const Point& by) {
  return {sum_below(box.x0, by.x), sum_below(box.y0, by.y), sum_above(box.x1, by.x),
          sum_above(box.y1, by.y)};
}

// Holds all sums of a point of one box and one of the other.
inline Box sum_outwards(const Box& p, const Box& q) {
  return {sum_below(p.x0, q.x0), sum_below(p.y0, q.y0), sum_above(p.x1, q.x1),
          sum_above(p.y1, q.y1)};
}

// Of its coordinates, the largest magnitude.
inline double size_of(const Box& box) {
  return std::max(std::max(std::abs(box.x0), std::abs(box.x1)),
                  std::max(std::abs(box.y0), std::abs(box.y1)));
}

// Holds all points that are no further than a distance from the box.
inline Box widened_outwards(const Box& box, double distance) {
  return {sum_below(box.x0, -distance), sum_below(box.y0, -distance), sum_above(box.x1, distance),
          sum_above(box.y1, distance)};
}

}  // namespace gcv
