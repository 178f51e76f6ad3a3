// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Boxes with sides parallel to the axes.
#pragma once

#include <algorithm>
#include <cassert>
#include <span>

#include "point.hpp"
#include "simd.hpp"

namespace gcv {

struct Box {
  double x0, y0, x1, y1;
};

// The bounding box of no point.
inline constexpr Box empty_box{infinity, infinity, -infinity, -infinity};

// The bounding box of the segment pq.
inline Box box_of(const Point& p, const Point& q) {
  return {std::min(p.x, q.x), std::min(p.y, q.y), std::max(p.x, q.x), std::max(p.y, q.y)};
}

// The bounding box of two boxes.
inline Box hull_of(const Box& p, const Box& q) {
  return {std::min(p.x0, q.x0), std::min(p.y0, q.y0), std::max(p.x1, q.x1), std::max(p.y1, q.y1)};
}

// The box of the sums of points of two boxes.
inline Box sum_of(const Box& p, const Box& q) {
  return {p.x0 + q.x0, p.y0 + q.y0, p.x1 + q.x1, p.y1 + q.y1};
}

// Its width and its height together.
inline double extents_of(const Box& box) { return (box.x1 - box.x0) + (box.y1 - box.y0); }

inline Box scaled(const Box& box, double scale) {
  return {scale * box.x0, scale * box.y0, scale * box.x1, scale * box.y1};
}

// The box, moved outwards by `more` on each side.
inline Box widened(const Box& box, double more) {
  return {box.x0 - more, box.y0 - more, box.x1 + more, box.y1 + more};
}

// Have the boxes no point in common? False if their numbers have overflowed.
inline bool are_apart(const Box& p, const Box& q) {
  return p.x0 > q.x1 || p.x1 < q.x0 || p.y0 > q.y1 || p.y1 < q.y0;
}

// Does the box hold the other? False for what is not a number.
inline bool holds(const Box& box, const Box& other) {
  return box.x0 <= other.x0 && box.y0 <= other.y0 && box.x1 >= other.x1 && box.y1 >= other.y1;
}

// The bounding box of points. There must be at least one.
inline Box box_of(std::span<const Point> points) {
  assert(!points.empty());
  PairOfDoubles low{points.front().x, points.front().y};
  PairOfDoubles high = low;
  for (const Point& point : points) {
    const PairOfDoubles p{point.x, point.y};
    low = select(p < low, p, low);
    high = select(p > high, p, high);
  }
  return {low[0], low[1], high[0], high[1]};
}

}  // namespace gcv
