// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Points and edges of the two polygons and of their sum. Coordinates of the sum are
// never added up: a point of the sum is kept as the pair (a, b).
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "buffer.hpp"
#include "lanes.hpp"

namespace gcv {

struct Point {
  double x;
  double y;

  friend bool operator==(const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; }
};

using PointVector = Buffer<Point>;

// Lexicographic order, first by x, then by y.
inline bool lexicographically_less(const Point& p, const Point& q) {
  return p.x < q.x || (p.x == q.x && p.y < q.y);
}

// Is the angle of the direction from p to q in [0, pi)?
inline bool points_up(const Point& p, const Point& q) {
  return p.y < q.y || (p.y == q.y && p.x < q.x);
}

// The number of the point that comes before all others; of equal ones, the first. At least one.
template <class IsBefore>
std::size_t first_of(std::span<const Point> points, IsBefore is_before) {
  std::size_t first = 0;
  Point p = points[0];
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (is_before(points[i], p)) {
      first = i;
      p = points[i];
    }
  }
  return first;
}
inline std::size_t lexicographic_min(std::span<const Point> points) {
  return first_of(points, lexicographically_less);
}

struct Box {
  double x0, y0, x1, y1;
};

// The box of no point.
inline constexpr Box empty_box{
    std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

// The box of the segment pq.
inline Box box_of(const Point& p, const Point& q) {
  return {std::min(p.x, q.x), std::min(p.y, q.y), std::max(p.x, q.x), std::max(p.y, q.y)};
}

// That of two boxes.
inline Box hull_of(const Box& p, const Box& q) {
  return {std::min(p.x0, q.x0), std::min(p.y0, q.y0), std::max(p.x1, q.x1), std::max(p.y1, q.y1)};
}

// The box with that much more on each side.
inline Box widened(const Box& box, double more) {
  return {box.x0 - more, box.y0 - more, box.x1 + more, box.y1 + more};
}

// False where numbers have overflowed.
inline bool are_apart(const Box& p, const Box& q) {
  return p.x0 > q.x1 || p.x1 < q.x0 || p.y0 > q.y1 || p.y1 < q.y0;
}

// That of some points, at least one.
inline Box box_of(std::span<const Point> points) {
  PairOfDoubles low{points.front().x, points.front().y};
  PairOfDoubles high = low;
  for (const Point& point : points) {
    const PairOfDoubles p{point.x, point.y};
    low = p < low ? p : low;
    high = p > high ? p : high;
  }
  return {low[0], low[1], high[0], high[1]};
}

// The point a + b of the sum.
struct SumPoint {
  Point a;
  Point b;
};

// An edge of the superset: from `origin` in the direction to - from, as long as it.
// `dx` and `dy` are that direction rounded to doubles.
struct SumEdge {
  SumPoint origin;
  Point from;
  Point to;
  double dx;
  double dy;
};

// The direction from p to q: q - p, rounded, or a quarter of it where that overflows.
inline Point direction(const Point& p, const Point& q) {
  const Point d{q.x - p.x, q.y - p.y};
  return std::isfinite(std::abs(d.x) + std::abs(d.y)) ? d
                                                      : Point{q.x / 4 - p.x / 4, q.y / 4 - p.y / 4};
}

// About the unit vector of that direction, by 5 u at most longer or shorter; of (0, 0) it is NaN.
inline Point unit_vector(const Point& direction) {
  const double size = std::max(std::abs(direction.x), std::abs(direction.y));
  const Point scaled{direction.x / size, direction.y / size};
  const double length = std::sqrt(scaled.x * scaled.x + scaled.y * scaled.y);
  return {scaled.x / length, scaled.y / length};
}

// The next larger double, for x from 0 on.
inline double next_up(double x) {
  return x < std::numeric_limits<double>::infinity()
             ? std::bit_cast<double>(std::bit_cast<std::uint64_t>(x + 0.0) + 1)
             : x;
}

// At least sqrt(x^2 + y^2). Five roundings, each below u, are made good. Where the smaller
// number is lost beside the larger, so is its share of the result.
inline double length_bound(double x, double y) {
  const double longer = std::max(std::abs(x), std::abs(y));
  const double shorter = std::min(std::abs(x), std::abs(y));
  if (shorter == 0) {
    return longer;
  }
  const double ratio = shorter / longer;
  const double length = longer * std::sqrt(1 + ratio * ratio);
  return next_up(length * (1 + 4 * std::numeric_limits<double>::epsilon()));
}

}  // namespace gcv
