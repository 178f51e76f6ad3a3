// SPDX-License-Identifier: LGPL-3.0-or-later
//
// cpp/exact/predicates.hpp in plain doubles: no error bounds and no exact tier. What a walk
// would cost, and where it would end, if nobody cared about rounding.
#include "predicates.hpp"

namespace gcv {

namespace {

int sign_of(double x) { return (x > 0) - (x < 0); }

double cross(double vx, double vy, double wx, double wy) { return vx * wy - vy * wx; }

double cross_of_offset(double dx, double dy, const SumPoint& from, const SumPoint& to) {
  return cross(dx, dy, (to.a.x - from.a.x) + (to.b.x - from.b.x) + (to.c.x - from.c.x),
               (to.a.y - from.a.y) + (to.b.y - from.b.y) + (to.c.y - from.c.y));
}

double parameter(const SumEdge& s, const SumEdge& t) {
  return cross_of_offset(-t.dx, -t.dy, s.origin, t.origin) / cross(s.dx, s.dy, t.dx, t.dy);
}

}  // namespace

int turn(const Point& p0, const Point& p1, const Point& q0, const Point& q1, Tally& tally) {
  ++tally.filtered;
  return sign_of(cross(p1.x - p0.x, p1.y - p0.y, q1.x - q0.x, q1.y - q0.y));
}

int orientation(const Point& p, const Point& q, const Point& r, Tally& tally) {
  return turn(p, q, p, r, tally);
}

int side(const SumEdge& s, const SumPoint& point, Tally& tally) {
  ++tally.filtered;
  return sign_of(cross_of_offset(s.dx, s.dy, s.origin, point));
}

int compare_sums(double a, double b, double c, double d, Tally& tally) {
  ++tally.filtered;
  return sign_of((a + b) - (c + d));
}

int compare_sums(double a, double b, double c, double d, double e, double f, Tally& tally) {
  ++tally.filtered;
  return sign_of((a + b + c) - (d + e + f));
}

int compare_crossings(const SumEdge& s, const SumEdge& t, const SumEdge& q, const SumEdge& r,
                      Tally& tally) {
  ++tally.filtered;
  return sign_of(parameter(s, t) - parameter(q, r));
}

Interval crossing_parameter(const SumEdge& s, const SumEdge& t) {
  const double quotient = parameter(s, t);
  return {quotient, quotient};
}

}  // namespace gcv
