// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Error bounds. Let u = 2^-53 and eta = 2^-1074, the smallest double. Rounding to
// nearest gives fl(x + y) = (x + y)(1 + e), |e| <= u, always (sums do not underflow),
// and fl(x y) = x y (1 + e) + h, |h| <= eta / 2. An overflow makes a bound infinite
// or NaN, and then "|value| > bound" is false: the next tier decides. So every bound
// below holds for every finite input.
//
// Contraction to fused multiply-add would not break the bounds, but would let results
// of the filters, and with them the statistics, differ between compilers: the build
// turns it off.
#include "predicates.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "doubled.hpp"
#include "exact_predicates.hpp"

namespace gcv {

namespace {

constexpr double cross_error = 8 * unit_roundoff;
constexpr double underflow_error = 8 * std::numeric_limits<double>::denorm_min();
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Approximation {
  double value;
  double error;
};

// d x w for a direction d, each coordinate rounded once from a difference, and an
// offset w = p + q, each of p and q rounded once from a difference; m = fl(|p| + |q|).
//
// |w - W| <= 2u(1 + 4u) m and |w| <= (1 + 3u) m (W: the exact offset); |d - D| <= u |d|.
// So |dx wy - Dx Wy| <= 3u(1 + 8u) |dx| my, the rounding of the product adds at most
// u(1 + 4u) |dx| my + eta / 2, and the subtraction u(1 + 8u) (|dx| my + |dy| mx). All
// told less than 6u (|dx| my + |dy| mx) + eta; the error computed here, 8u (...) + 8 eta
// with three roundings and underflows of its own, is larger.
Approximation cross_of_offset(double dx, double dy, const SumPoint& from, const SumPoint& to) {
  const double px = to.a.x - from.a.x;
  const double py = to.a.y - from.a.y;
  const double qx = to.b.x - from.b.x;
  const double qy = to.b.y - from.b.y;
  const double value = dx * (py + qy) - dy * (px + qx);
  const double size =
      std::abs(dx) * (std::abs(py) + std::abs(qy)) + std::abs(dy) * (std::abs(px) + std::abs(qx));
  return {value, cross_error * size + underflow_error};
}

// v x w where each coordinate was rounded once: the same with W = p, q = 0.
Approximation cross_of_directions(double vx, double vy, double wx, double wy) {
  const double left = vx * wy;
  const double right = vy * wx;
  return {left - right, cross_error * (std::abs(left) + std::abs(right)) + underflow_error};
}

bool certain(const Approximation& a) { return std::abs(a.value) > a.error; }

int sign_of(double x) { return (x > 0) - (x < 0); }

bool are_equal(const DoubledNumber& p, const DoubledNumber& q) {
  return p.is_exact && q.is_exact && p.head == q.head && p.tail == q.tail;
}

// The sign of a b - c d; nothing where it is out of range. Of two products that round differently,
// or else of their errors, the larger decides: rounding is monotonic.
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
  return sign_of(std::fma(a, b, -left) - std::fma(c, d, -right));
}

// The sign of v x w, as doubled_cross; nothing where it is too close, or out of range.
//
// On grids of few bits, where most ties are, all are doubles. Most other ties are those of a
// polygon with itself.
std::optional<int> doubled_sign(const DoubledVector& v, const DoubledVector& w) {
  if (v.x.is_double() && v.y.is_double() && w.x.is_double() && w.y.is_double()) {
    return compare_products(v.x.head, w.y.head, v.y.head, w.x.head);
  }
  if (are_equal(v.x, w.x) && are_equal(v.y, w.y)) {
    return 0;
  }
  const DoubledCross cross = doubled_cross(v, w);
  return std::abs(cross.head) > cross.error ? std::optional(sign_of(cross.head)) : std::nullopt;
}

// The further tiers stand apart: what they keep in registers would cost the first one as much as
// its own work.
[[gnu::noinline]] int undecided_turn(const Point& p0, const Point& p1, const Point& q0,
                                     const Point& q1, Tally& tally) {
  if ((p0.x == p1.x && q0.x == q1.x) || (p0.y == p1.y && q0.y == q1.y)) {  // along one axis
    ++tally.filtered;
    return 0;
  }
  if (const auto sign = doubled_sign(doubled_vector(p0, p1), doubled_vector(q0, q1))) {
    ++tally.fixed_width;
    return *sign;
  }
  return exact::turn(p0, p1, q0, q1, tally);
}

[[gnu::noinline]] int undecided_side(const SumEdge& s, const SumPoint& point, Tally& tally) {
  if (const auto sign =
          doubled_sign(doubled_vector(s.from, s.to), doubled_vector(s.origin, point))) {
    ++tally.fixed_width;
    return *sign;
  }
  return exact::side(s, point, tally);
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

// Rounding is monotonic: sums that round differently compare as their roundings do.
// Where they round to the same double, the errors decide.
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

// lambda_t = N / D, as in crossing(). With |N - N'| <= eN, |D - D'| <= eD (primes: exact)
// and |D| > 2 eD, |D'| >= |D| / 2, so
//   |N' / D' - N / D| = |(N' - N) D - N (D' - D)| / |D D'| <= 2 (eN + |N / D| eD) / |D|.
// The roundings of the quotient, of this bound and of lo and hi are below 4u |N / D| and
// 16u of the bound; the smallest normal double covers underflow.
Interval crossing_parameter(const SumEdge& s, const SumEdge& t) {
  const Approximation n = cross_of_offset(-t.dx, -t.dy, s.origin, t.origin);
  const Approximation d = cross_of_directions(s.dx, s.dy, t.dx, t.dy);
  const double size = std::abs(d.value);
  if (!(size > 2 * d.error)) {
    return {-infinity, infinity};
  }
  const double quotient = n.value / d.value;
  const double error =
      (1 + 16 * unit_roundoff) * (2 * (n.error + std::abs(quotient) * d.error) / size +
                                  4 * unit_roundoff * std::abs(quotient)) +
      std::numeric_limits<double>::min();
  if (!std::isfinite(quotient) || !std::isfinite(error)) {
    return {-infinity, infinity};
  }
  return {quotient - error, quotient + error};
}

// The tails are below 4u of the heads, and the roundings of their sum below 16u^2. The rounding of
// the last sum keeps its sign. The smallest normal double covers quotients that underflow; other
// underflows are far below the errors of numbers that are in range.
int compare_crossings(const SumEdge& s, const SumEdge& t, const SumEdge& r, Tally& tally) {
  const DoubledParameter p = doubled_parameter(s, t);
  const DoubledParameter q = doubled_parameter(s, r);
  const double head = p.head - q.head;
  const double difference = head + (rounding_error(p.head, -q.head, head) + (p.tail - q.tail));
  const double error = p.error + q.error +
                       32 * unit_roundoff * unit_roundoff * (std::abs(p.head) + std::abs(q.head)) +
                       std::numeric_limits<double>::min();
  if (std::abs(difference) > 2 * error) {
    ++tally.fixed_width;
    return sign_of(difference);
  }
  if (p.is_fraction && q.is_fraction) {
    if (const std::optional<int> order = compare_products(p.n, q.d, q.n, p.d)) {
      ++tally.fixed_width;
      return *order * sign_of(p.d) * sign_of(q.d);
    }
  }
  return exact::compare_crossings(s, t, r, tally);
}

}  // namespace gcv
