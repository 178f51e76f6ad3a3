// SPDX-License-Identifier: LGPL-3.0-or-later
#include "double_double_rounding.hpp"

#include <cmath>

#include "ball.hpp"
#include "double_double.hpp"
#include "fma.hpp"

namespace gcv {

namespace {

// The double nearest to an exact number that is within `error` of hi + lo. hi must be the double
// nearest to hi + lo. Nothing if the result is not certain.
std::optional<RoundedNumber> certain(double hi, double lo, double error) {
  if (error == 0 && std::isfinite(hi)) {
    return RoundedNumber{hi + 0.0, lo == 0};
  }
  // Rounding is monotonic. So if both ends of an interval round to the same double, all of it does.
  // The radius and the ends are rounded themselves; 4u |lo| is more than these errors.
  const double radius = error + 4 * unit_roundoff * std::abs(lo);
  if (std::abs(lo) > error && hi + (lo - radius) == hi && hi + (lo + radius) == hi) {
    return RoundedNumber{hi + 0.0, false};
  }
  return std::nullopt;
}

// The number a + b + c: within `error` of hi + lo.
struct Origin {
  double hi;
  double lo;
  double error;

  Origin(double a, double b, double c) {
    const double sum = a + b;
    hi = sum + c;
    const double sum_error = rounding_error(a, b, sum);
    const double hi_error = rounding_error(sum, c, hi);
    lo = sum_error + hi_error;
    error = std::abs(rounding_error(sum_error, hi_error, lo));
  }

  [[nodiscard]] std::optional<RoundedNumber> rounded() const {
    const double nearest = hi + lo;
    return certain(nearest, rounding_error(hi, lo, nearest), error);
  }
};

// Is a shifted point the sum of three, or less?
bool has_three_summands(const SumPoint& point, const Point& shift) {
  return (point.c.x == 0 || shift.x == 0) && (point.c.y == 0 || shift.y == 0);
}
// One coordinate of that.
Origin origin_x(const SumPoint& point, const Point& shift) {
  return {point.a.x, point.b.x, point.c.x + shift.x};
}
Origin origin_y(const SumPoint& point, const Point& shift) {
  return {point.a.y, point.b.y, point.c.y + shift.y};
}

// The quotient n d / D. Nothing unless the product and the quotient are doubles exactly.
std::optional<double> exact_way(const DoubleDoubleParameter& lambda, const DoubleDouble& d) {
  if (!lambda.is_fraction || !d.is_double()) {
    return std::nullopt;
  }
  const double product = lambda.n * d.hi;
  const double quotient = product / lambda.d;
  if (is_exact_product(lambda.n, d.hi, product, gcv::fma(lambda.n, d.hi, -product)) &&
      is_exact_product(quotient, lambda.d, product, gcv::fma(quotient, lambda.d, -product))) {
    return quotient;
  }
  return std::nullopt;
}

// Rounds origin + way + way_lo, which is known within `error`.
std::optional<RoundedNumber> rounded_way(const Origin& origin, double way, double way_lo,
                                         double error) {
  const double hi = origin.hi + way;
  const double hi_error = rounding_error(origin.hi, way, hi);
  const double lo_parts = way_lo + origin.lo;
  const double lo = hi_error + lo_parts;
  const double nearest = hi + lo;
  return certain(nearest, rounding_error(hi, lo, nearest),
                 error + (std::abs(rounding_error(way_lo, origin.lo, lo_parts)) +
                          std::abs(rounding_error(hi_error, lo_parts, lo))));
}

// One coordinate of o_s + lambda d_s.
//
// Error bound. The way is lambda d_s. Its error is that of lambda times d_s, plus less than 16u^2
// of the way. This covers the roundings in its lo part and the product of two lo parts, which is
// left out. The factor 2 covers the roundings of the bound itself. `underflow` covers underflow for
// coordinates up to `largest`.
std::optional<RoundedNumber> rounded_coordinate(const Origin& origin,
                                                const DoubleDoubleParameter& lambda,
                                                const DoubleDouble& d) {
  constexpr double largest = 0x1p300;
  constexpr double underflow = 0x1p-700;
  if (const auto way = exact_way(lambda, d)) {
    return rounded_way(origin, *way, 0, origin.error);
  }
  const double way = lambda.hi * d.hi;
  const double lo = gcv::fma(lambda.hi, d.hi, -way) + (lambda.hi * d.lo + lambda.lo * d.hi);
  const double error = 2 * (std::abs(d.hi) * lambda.error + origin.error +
                            16 * unit_roundoff * unit_roundoff * std::abs(way)) +
                       underflow;
  return std::abs(way) <= largest && std::abs(origin.hi) <= largest && d.size <= largest
             ? rounded_way(origin, way, lo, error)
             : std::nullopt;
}

}  // namespace

std::optional<RoundedNumber> rounded(const Ball& ball) {
  return certain(ball.hi, ball.lo, ball.error);
}

std::optional<RoundedVertex> rounded_sum(const SumPoint& point, const Point& shift) {
  if (!has_three_summands(point, shift)) {
    return std::nullopt;
  }
  const auto x = origin_x(point, shift).rounded();
  const auto y = origin_y(point, shift).rounded();
  return x && y ? std::optional(RoundedVertex{*x, *y}) : std::nullopt;
}

// If one of the edges is parallel to an axis, one coordinate is a sum.
std::optional<RoundedVertex> rounded_crossing(const SumEdge& s, const SumEdge& t,
                                              const Point& shift) {
  if (!has_three_summands(s.origin, shift) || !has_three_summands(t.origin, shift)) {
    return std::nullopt;
  }
  const DoubleDoubleParameter lambda = double_double_parameter(s, t);
  const Origin sx = origin_x(s.origin, shift);
  const Origin sy = origin_y(s.origin, shift);
  const auto x = t.from.x == t.to.x   ? origin_x(t.origin, shift).rounded()
                 : s.from.x == s.to.x ? sx.rounded()
                                      : rounded_coordinate(sx, lambda, two_sum(s.to.x, -s.from.x));
  const auto y = t.from.y == t.to.y   ? origin_y(t.origin, shift).rounded()
                 : s.from.y == s.to.y ? sy.rounded()
                                      : rounded_coordinate(sy, lambda, two_sum(s.to.y, -s.from.y));
  return x && y ? std::optional(RoundedVertex{*x, *y}) : std::nullopt;
}

// If neither product is next to underflow, fused multiply-add gives the errors of the products
// exactly.
std::optional<RoundedNumber> rounded_affine(double xx, double xy, double x0, const Point& p) {
  const auto is_in_range = [](double factor, double x) {
    return factor == 0 || x == 0 || std::abs(factor * x) >= 0x1p-900;
  };
  if (!is_in_range(xx, p.x) || !is_in_range(xy, p.y)) {
    return std::nullopt;
  }
  const double first = xx * p.x;
  const double second = xy * p.y;
  const double first_error = gcv::fma(xx, p.x, -first);
  const double second_error = gcv::fma(xy, p.y, -second);
  const Origin sum(first, second, x0);
  const double errors = first_error + second_error;
  const double lo = sum.lo + errors;
  const double nearest = sum.hi + lo;
  return certain(nearest, rounding_error(sum.hi, lo, nearest),
                 2 * (sum.error + std::abs(rounding_error(first_error, second_error, errors)) +
                      std::abs(rounding_error(sum.lo, errors, lo))));
}

}  // namespace gcv
