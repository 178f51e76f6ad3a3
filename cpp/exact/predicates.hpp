// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The geometric predicates. They are exact for all finite doubles. Each has three tiers: a filter
// in doubles with a proven error bound (see predicates.cpp), double-double, and integers.
//
// Axioms. orientation(p, q, r) = orientation(q, r, p) = -orientation(q, p, r). side and
// compare_crossings do not change when the polygons are translated, if the translated vertices are
// doubles.
#pragma once

#include <optional>

#include "double_double.hpp"
#include "point.hpp"
#include "tally.hpp"

namespace gcv {

// The sign of (q - p) x (r - p): 1 if p, q, r turn left, -1 if they turn right, 0 if they are
// collinear.
int orientation(const Point& p, const Point& q, const Point& r, Tally& tally);

// The sign of (p1 - p0) x (q1 - q0). It is 1 if the second direction is to the left of the first,
// by less than half a turn.
int turn(const Point& p0, const Point& p1, const Point& q0, const Point& q1, Tally& tally);

// The side of the line of s on which the point lies: 1 left, -1 right, 0 on the line.
int side(const SumEdge& s, const SumPoint& point, Tally& tally);

// The sign of (a + b) - (c + d).
int compare_sums(double a, double b, double c, double d, Tally& tally);
// The sign of (a + b + c) - (d + e + f).
int compare_sums(double a, double b, double c, double d, double e, double f, Tally& tally);
// The sign of the difference of a coordinate of p and of q.
inline int compare_x(const SumPoint& p, const SumPoint& q, Tally& tally) {
  return compare_sums(p.a.x, p.b.x, p.c.x, q.a.x, q.b.x, q.c.x, tally);
}
inline int compare_y(const SumPoint& p, const SumPoint& q, Tally& tally) {
  return compare_sums(p.a.y, p.b.y, p.c.y, q.a.y, q.b.y, q.c.y, tally);
}
// Are they the same point?
inline bool are_equal(const SumPoint& p, const SumPoint& q, Tally& tally) {
  return compare_x(p, q, tally) == 0 && compare_y(p, q, tally) == 0;
}

// The sign of lambda_t - lambda_r. The line of t crosses the line of s in o_s + lambda_t d_s, and
// the line of r crosses that of q in o_q + lambda_r d_q. Neither may be parallel to the other.
int compare_crossings(const SumEdge& s, const SumEdge& t, const SumEdge& q, const SumEdge& r,
                      Tally& tally);
// The same where both cross the line of s.
inline int compare_crossings(const SumEdge& s, const SumEdge& t, const SumEdge& r, Tally& tally) {
  return compare_crossings(s, t, s, r, tally);
}

// Doubles that enclose lambda_t, maybe -inf and inf. Disjoint intervals decide compare_crossings.
struct Interval {
  double lo;
  double hi;
};
// -1 if all of p is below all of q, 1 if it is above, 0 if they meet.
inline int order_of(const Interval& p, const Interval& q) {
  return p.hi < q.lo ? -1 : p.lo > q.hi ? 1 : 0;
}
Interval crossing_parameter(const SumEdge& s, const SumEdge& t);
// The same in fewer steps. Nothing if the lines are nearly parallel.
std::optional<Interval> rough_crossing_parameter(const SumEdge& s, const SumEdge& t);

// The crossing of the line of s with that of t, to be compared with many others on the line of s.
class Crossing {
 public:
  Crossing(const SumEdge& s, const SumEdge& t)
      : s_(s), t_(t), parameter_(double_double_parameter(s, t)) {}

  // compare_crossings(s, t, r) for lines t and r that are not parallel.
  [[nodiscard]] int compare(const SumEdge& r, Tally& tally) const;

 private:
  SumEdge s_;
  SumEdge t_;
  DoubleDoubleParameter parameter_;
};

}  // namespace gcv
