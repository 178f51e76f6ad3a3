// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Error bounds. Let u = 2^-53, and eta = 2^-1074 the smallest double. Rounding to nearest gives
// fl(x + y) = (x + y)(1 + e) with |e| <= u, always, because sums do not underflow. It gives
// fl(x y) = x y (1 + e) + h with |h| <= eta / 2. An overflow makes a bound infinite or NaN. Then
// "|value| > bound" is false, and the next tier decides. So every bound below holds for every
// finite input.
//
// The build turns fused multiply-add off. The bounds would hold with it. But filters would decide
// otherwise from compiler to compiler, and so would the statistics.
#include "predicates.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "double_double.hpp"
#include "exact_predicates.hpp"
#include "fma.hpp"

namespace gcv {

namespace {

constexpr double cross_error = 8 * unit_roundoff;
// A few eta would do. But subnormal operands and results raise flags of the processor that few
// callers have up already, and to take them down at the end takes a fifth of a tiny sum.
constexpr double underflow_error = 0x1p-900;

struct Approximation {
  double value;
  double error;
};

// d x w for a direction d and an offset w = (p + q) + r. Each coordinate of d, p, q and r is a
// difference that was rounded once. Let m = fl((|p| + |q|) + |r|), and let capitals be the exact
// numbers.
//
// It is |w - W| <= 3u(1 + 8u) m, |w| <= (1 + 4u) m and |d - D| <= u |d|.
// So |dx wy - Dx Wy| <= 4u(1 + 8u) |dx| my.
// The rounding of the product adds at most u(1 + 8u) |dx| my + eta / 2.
// The rounding of the subtraction adds at most u(1 + 8u) (|dx| my + |dy| mx).
// All together is less than 6u(1 + 8u) (|dx| my + |dy| mx) + eta.
// The error computed here is 8u (...) + 2^-900. It has three roundings and underflows of its own,
// and is larger all the same.
Approximation cross_of_offset(double dx, double dy, const SumPoint& from, const SumPoint& to) {
  const double px = to.a.x - from.a.x;
  const double py = to.a.y - from.a.y;
  const double qx = to.b.x - from.b.x;
  const double qy = to.b.y - from.b.y;
  const double rx = to.c.x - from.c.x;
  const double ry = to.c.y - from.c.y;
  const double value = dx * ((py + qy) + ry) - dy * ((px + qx) + rx);
  const double size = std::abs(dx) * ((std::abs(py) + std::abs(qy)) + std::abs(ry)) +
                      std::abs(dy) * ((std::abs(px) + std::abs(qx)) + std::abs(rx));
  return {value, cross_error * size + underflow_error};
}

// v x w with each coordinate rounded once. The bound is the same, with W = p, and q and r 0.
Approximation cross_of_directions(double vx, double vy, double wx, double wy) {
  const double left = vx * wy;
  const double right = vy * wx;
  return {left - right, cross_error * (std::abs(left) + std::abs(right)) + underflow_error};
}

bool certain(const Approximation& a) { return std::abs(a.value) > a.error; }

int sign_of(double x) { return (x > 0) - (x < 0); }

bool are_equal(const DoubleDouble& p, const DoubleDouble& q) {
  return p.is_exact && q.is_exact && p.hi == q.hi && p.lo == q.lo;
}

// The sign of a b - c d. Nothing if it is out of range. If the products round to different doubles,
// these decide, because rounding is monotonic. Else the rounding errors decide.
std::optional<int> compare_products(double a, double b, double c, double d) {
  const double left = a * b;
  const double right = c * d;
  if (left != right) {
    return sign_of(left - right);
  }
  if ((a == 0 || b == 0) && (c == 0 || d == 0)) {
    return 0;
  }
  if (!(std::abs(left) >= 0x1p-900 && std::abs(left) <= 0x1p1000)) {
    return std::nullopt;
  }
  return sign_of(gcv::fma(a, b, -left) - gcv::fma(c, d, -right));
}

// The sign of v x w (see double_double_cross). Nothing if it is too close to 0 or out of range.
//
// Most ties are on grids of few bits. There all coordinates are doubles. Most other ties come from
// the sum of a polygon with itself.
std::optional<int> double_double_sign(const DoubleDoubleVector& v, const DoubleDoubleVector& w) {
  if (are_equal(v.x, w.x) && are_equal(v.y, w.y)) {
    return 0;
  }
  if (v.x.is_double() && v.y.is_double() && w.x.is_double() && w.y.is_double()) {
    return compare_products(v.x.hi, w.y.hi, v.y.hi, w.x.hi);
  }
  const DoubleDoubleCross cross = double_double_cross(v, w);
  return std::abs(cross.hi) > cross.error ? std::optional(sign_of(cross.hi)) : std::nullopt;
}

// The further tiers are functions of their own. The registers that they need would double the time
// of the first tier.
[[gnu::noinline]] int undecided_turn(const Point& p0, const Point& p1, const Point& q0,
                                     const Point& q1, Tally& tally) {
  if ((p0.x == p1.x && q0.x == q1.x) || (p0.y == p1.y && q0.y == q1.y)) {  // along one axis
    ++tally.filtered;
    return 0;
  }
  if (const auto sign =
          double_double_sign(double_double_vector(p0, p1), double_double_vector(q0, q1))) {
    ++tally.fixed_width;
    return *sign;
  }
  return exact::turn(p0, p1, q0, q1, tally);
}

// Is it the end of an edge of the first polygon, by its coordinates?
bool is_end(const SumEdge& s, const SumPoint& point) {
  return s.origin.a == s.from && SumPoint{s.to, s.origin.b, s.origin.c} == point;
}

[[gnu::noinline]] int undecided_side(const SumEdge& s, const SumPoint& point, Tally& tally) {
  if (s.origin == point || is_end(s, point)) {
    ++tally.fixed_width;
    return 0;
  }
  if (s.from.x == s.to.x) {  // along an axis, one coordinate tells
    return compare_x(s.origin, point, tally) * sign_of(s.dy);
  }
  if (s.from.y == s.to.y) {
    return compare_y(point, s.origin, tally) * sign_of(s.dx);
  }
  if (const auto sign = double_double_sign(double_double_vector(s.from, s.to),
                                           double_double_vector(s.origin, point))) {
    ++tally.fixed_width;
    return *sign;
  }
  return exact::side(s, point, tally);
}

// Of lines that are nearly parallel. lambda is within lo and the error of hi. The last terms cover
// the roundings here.
[[gnu::cold, gnu::noinline]] Interval precise_crossing_parameter(const SumEdge& s,
                                                                 const SumEdge& t) {
  const DoubleDoubleParameter lambda = double_double_parameter(s, t);
  const double room = (1 + 8 * unit_roundoff) * (std::abs(lambda.lo) + lambda.error) +
                      4 * unit_roundoff * std::abs(lambda.hi) + std::numeric_limits<double>::min();
  return std::isfinite(room) ? Interval{lambda.hi - room, lambda.hi + room}
                             : Interval{-infinity, infinity};
}

// The order of two parameters. Nothing if that is not certain.
//
// The lo parts are below 4u of the hi parts. The roundings of the sum of the lo parts are below
// 16u^2. The rounding of the last sum keeps the sign. The smallest normal double covers quotients
// that underflow. Other underflows are far below the errors of numbers that are in range.
std::optional<int> compare_parameters(const DoubleDoubleParameter& x,
                                      const DoubleDoubleParameter& y, Tally& tally) {
  const double hi = x.hi - y.hi;
  const double difference = hi + (rounding_error(x.hi, -y.hi, hi) + (x.lo - y.lo));
  const double error = x.error + y.error +
                       32 * unit_roundoff * unit_roundoff * (std::abs(x.hi) + std::abs(y.hi)) +
                       std::numeric_limits<double>::min();
  if (std::abs(difference) > 2 * error) {
    ++tally.fixed_width;
    return sign_of(difference);
  }
  if (x.is_fraction && y.is_fraction) {
    if (const std::optional<int> order = compare_products(x.n, y.d, y.n, x.d)) {
      ++tally.fixed_width;
      return *order * sign_of(x.d) * sign_of(y.d);
    }
  }
  return std::nullopt;
}

}  // namespace

int turn(const Point& p0, const Point& p1, const Point& q0, const Point& q1, Tally& tally) {
  const Approximation approximation =
      cross_of_directions(p1.x - p0.x, p1.y - p0.y, q1.x - q0.x, q1.y - q0.y);
  if (!certain(approximation)) {
    return undecided_turn(p0, p1, q0, q1, tally);
  }
  ++tally.filtered;
  return sign_of(approximation.value);
}

int orientation(const Point& p, const Point& q, const Point& r, Tally& tally) {
  return turn(p, q, p, r, tally);
}

int side(const SumEdge& s, const SumPoint& point, Tally& tally) {
  const Approximation approximation = cross_of_offset(s.dx, s.dy, s.origin, point);
  if (!certain(approximation)) {
    return undecided_side(s, point, tally);
  }
  ++tally.filtered;
  return sign_of(approximation.value);
}

// Rounding is monotonic. So sums that round to different doubles compare as these do. Sums that
// round to the same double compare as their rounding errors do.
int compare_sums(double a, double b, double c, double d, Tally& tally) {
  const double first = a + b;
  const double second = c + d;
  const double difference =
      first != second ? first - second : rounding_error(a, b, first) - rounding_error(c, d, second);
  if (std::isfinite(first) && std::isfinite(second) && !std::isnan(difference)) {
    ++tally.filtered;
    return sign_of(difference);
  }
  return exact::compare_sums(a, b, c, d, tally);
}

// (a - d) + (b - e) + (c - f): each difference is rounded once, and their sums twice. So the result
// is off by at most 3u(1 + 3u) (|a - d| + |b - e| + |c - f|).
int compare_sums(double a, double b, double c, double d, double e, double f, Tally& tally) {
  if (c == f) {
    return compare_sums(a, b, d, e, tally);
  }
  const double x = a - d;
  const double y = b - e;
  const double z = c - f;
  const double difference = (x + y) + z;
  if (std::abs(difference) > 4 * unit_roundoff * ((std::abs(x) + std::abs(y)) + std::abs(z))) {
    ++tally.filtered;
    return sign_of(difference);
  }
  return exact::compare_sums(a, b, c, d, e, f, tally);
}

// lambda_t = N / D as in crossing(). Let N' and D' be exact, |N - N'| <= eN, |D - D'| <= eD and
// |D| > 2 eD. Then |D'| >= |D| / 2, so
//   |N' / D' - N / D| = |(N' - N) D - N (D' - D)| / |D D'| <= 2 (eN + |N / D| eD) / |D|.
// The roundings of the quotient, lo and hi are below 4u |N / D|. Those of the bound are below 16u
// of the bound. The smallest normal double covers underflow.
std::optional<Interval> rough_crossing_parameter(const SumEdge& s, const SumEdge& t) {
  const Approximation n = cross_of_offset(-t.dx, -t.dy, s.origin, t.origin);
  const Approximation d = cross_of_directions(s.dx, s.dy, t.dx, t.dy);
  const double size = std::abs(d.value);
  if (!(size > 0x1p8 * d.error)) {
    return std::nullopt;
  }
  const double quotient = n.value / d.value;
  const double error =
      (1 + 16 * unit_roundoff) * (2 * (n.error + std::abs(quotient) * d.error) / size +
                                  4 * unit_roundoff * std::abs(quotient)) +
      std::numeric_limits<double>::min();
  if (!std::isfinite(quotient) || !std::isfinite(error)) {
    return Interval{-infinity, infinity};
  }
  return Interval{quotient - error, quotient + error};
}

Interval crossing_parameter(const SumEdge& s, const SumEdge& t) {
  const std::optional<Interval> rough = rough_crossing_parameter(s, t);
  return rough ? *rough : precise_crossing_parameter(s, t);
}

int compare_crossings(const SumEdge& s, const SumEdge& t, const SumEdge& q, const SumEdge& r,
                      Tally& tally) {
  // A line meets parallel ones one after the other.
  if (s == q && turn(t.from, t.to, r.from, r.to, tally) == 0) {
    return side(r, t.origin, tally) * turn(r.from, r.to, s.from, s.to, tally);
  }
  const std::optional<int> order =
      compare_parameters(double_double_parameter(s, t), double_double_parameter(q, r), tally);
  return order ? *order : exact::compare_crossings(s, t, q, r, tally);
}

int Crossing::compare(const SumEdge& r, Tally& tally) const {
  const std::optional<int> order =
      compare_parameters(parameter_, double_double_parameter(s_, r), tally);
  return order ? *order : exact::compare_crossings(s_, t_, s_, r, tally);
}

}  // namespace gcv
