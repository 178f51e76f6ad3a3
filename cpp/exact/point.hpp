// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Points and edges of two polygons and of their sum. The coordinates of the sum are never added up.
// A point of the sum is the pair (a, b), or the triple (a, b, c).
#pragma once

#include <cassert>
#include <cstddef>
#include <limits>
#include <span>

#include "buffer.hpp"

namespace gcv {

struct Point {
  double x;
  double y;

  friend bool operator==(const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; }
};

using PointVector = Buffer<Point>;

inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline Point negated(const Point& p) { return {-p.x, -p.y}; }

// Rounded.
inline Point difference(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }
inline double dot(const Point& p, const Point& q) { return p.x * q.x + p.y * q.y; }
inline double cross(const Point& p, const Point& q) { return p.x * q.y - p.y * q.x; }

// Lexicographic order, first by x, then by y.
inline bool lexicographically_less(const Point& p, const Point& q) {
  return p.x < q.x || (p.x == q.x && p.y < q.y);
}

// Is the angle of the direction from p to q in [0, pi)?
inline bool points_up(const Point& p, const Point& q) {
  return p.y < q.y || (p.y == q.y && p.x < q.x);
}

// The index of the point that comes before all others. If several are equal, that of the first.
// There must be at least one point.
template <class IsBefore>
std::size_t first_of(std::span<const Point> points, IsBefore is_before) {
  assert(!points.empty());
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

// The point a + b + c of the sum. c is not 0 only where a is a vertex of a member of a scene: it is
// the position of that.
struct SumPoint {
  Point a;
  Point b;
  Point c{0, 0};

  friend bool operator==(const SumPoint& p, const SumPoint& q) {
    return p.a == q.a && p.b == q.b && p.c == q.c;
  }
};

// An edge of the superset. It starts at `origin` and has the direction and length of to - from. dx
// and dy are to - from, rounded to doubles.
struct SumEdge {
  SumPoint origin;
  Point from;
  Point to;
  double dx;
  double dy;

  friend bool operator==(const SumEdge& s, const SumEdge& t) {
    return s.origin == t.origin && s.from == t.from && s.to == t.to;
  }
};

}  // namespace gcv
