// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Points and edges of the two polygons and of their sum. Coordinates of the sum are
// never added up: a point of the sum is kept as the pair (a, b).
#pragma once

namespace gcv {

struct Point {
  double x;
  double y;

  friend bool operator==(const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; }
};

// Lexicographic order, first by x, then by y.
inline bool lexicographically_less(const Point& p, const Point& q) {
  return p.x < q.x || (p.x == q.x && p.y < q.y);
}

struct Box {
  double x0, y0, x1, y1;
};

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

}  // namespace gcv
