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

// Holds all points that are no further than a distance from the box.
inline Box widened_outwards(const Box& box, double distance) {
  return {sum_below(box.x0, -distance), sum_below(box.y0, -distance), sum_above(box.x1, distance),
          sum_above(box.y1, distance)};
}

}  // namespace gcv
