// SPDX-License-Identifier: LGPL-3.0-or-later
#include "doubled_rounding.hpp"

#include <cmath>
#include <limits>

#include "doubled.hpp"

namespace gcv {

namespace {

// The double nearest to the exact number, which is within `error` of head + tail, the head being
// the nearest to that sum; nothing where that is not certain.
std::optional<RoundedNumber> certain(double head, double tail, double error) {
  if (error == 0 && std::isfinite(head)) {
    return RoundedNumber{head + 0.0, tail == 0};
  }
  // Rounding is monotonic: where the ends of an interval round to the same double, all of it does.
  // Those of the radius and of its ends, below 4u |tail|, are made good.
  const double radius = error + 4 * unit_roundoff * std::abs(tail);
  if (std::abs(tail) > error && head + (tail - radius) == head && head + (tail + radius) == head) {
    return RoundedNumber{head + 0.0, false};
  }
  return std::nullopt;
}

// a + b + shift.
struct Origin {
  double head;
  double tail;
  double error;

  Origin(double a, double b, double shift) {
    const double sum = a + b;
    head = sum + shift;
    const double sum_error = rounding_error(a, b, sum);
    const double head_error = rounding_error(sum, shift, head);
    tail = sum_error + head_error;
    error = std::abs(rounding_error(sum_error, head_error, tail));
  }

  [[nodiscard]] std::optional<RoundedNumber> rounded() const {
    const double nearest = head + tail;
    return certain(nearest, rounding_error(head, tail, nearest), error);
  }
};

// The quotient n d / D, where all of it is a double.
std::optional<double> exact_way(const DoubledParameter& lambda, const DoubledNumber& d) {
  if (!lambda.is_fraction || !d.is_double()) {
    return std::nullopt;
  }
  const double product = lambda.n * d.head;
  const double quotient = product / lambda.d;
  if (is_exact_product(lambda.n, d.head, product, std::fma(lambda.n, d.head, -product)) &&
      is_exact_product(quotient, lambda.d, product, std::fma(quotient, lambda.d, -product))) {
    return quotient;
  }
  return std::nullopt;
}

// The origin + way + way_tail, within `error`.
std::optional<RoundedNumber> rounded_way(const Origin& origin, double way, double way_tail,
                                         double error) {
  const double head = origin.head + way;
  const double head_error = rounding_error(origin.head, way, head);
  const double tails = way_tail + origin.tail;
  const double tail = head_error + tails;
  const double nearest = head + tail;
  return certain(nearest, rounding_error(head, tail, nearest),
                 error + (std::abs(rounding_error(way_tail, origin.tail, tails)) +
                          std::abs(rounding_error(head_error, tails, tail))));
}

// One coordinate of o_s + lambda d_s.
//
// Beside the error of lambda, the roundings in the tail of the way and what is left out, the
// product of two tails, are below 16u^2 of the way. The factor 2 is for the roundings of this
// bound; its last part for underflow, where coordinates are below the largest allowed.
std::optional<RoundedNumber> rounded_coordinate(const Origin& origin,
                                                const DoubledParameter& lambda,
                                                const DoubledNumber& d) {
  constexpr double largest = 0x1p300;
  constexpr double underflow = 0x1p-700;
  if (const auto way = exact_way(lambda, d)) {
    return rounded_way(origin, *way, 0, origin.error);
  }
  const double way = lambda.head * d.head;
  const double tail =
      std::fma(lambda.head, d.head, -way) + (lambda.head * d.tail + lambda.tail * d.head);
  const double error = 2 * (std::abs(d.head) * lambda.error + origin.error +
                            16 * unit_roundoff * unit_roundoff * std::abs(way)) +
                       underflow;
  return std::abs(way) <= largest && std::abs(origin.head) <= largest && d.size <= largest
             ? rounded_way(origin, way, tail, error)
             : std::nullopt;
}

}  // namespace

std::optional<RoundedVertex> rounded_sum(const SumPoint& point, const Point& shift) {
  const auto x = Origin(point.a.x, point.b.x, shift.x).rounded();
  const auto y = Origin(point.a.y, point.b.y, shift.y).rounded();
  return x && y ? std::optional(RoundedVertex{*x, *y}) : std::nullopt;
}

// Where one of the edges is parallel to an axis, a coordinate is a sum.
std::optional<RoundedVertex> rounded_crossing(const SumEdge& s, const SumEdge& t,
                                              const Point& shift) {
  const DoubledParameter lambda = doubled_parameter(s, t);
  const Origin sx(s.origin.a.x, s.origin.b.x, shift.x);
  const Origin sy(s.origin.a.y, s.origin.b.y, shift.y);
  const auto x = t.from.x == t.to.x ? Origin(t.origin.a.x, t.origin.b.x, shift.x).rounded()
                 : s.from.x == s.to.x
                     ? sx.rounded()
                     : rounded_coordinate(sx, lambda, doubled_sum(s.to.x, -s.from.x));
  const auto y = t.from.y == t.to.y ? Origin(t.origin.a.y, t.origin.b.y, shift.y).rounded()
                 : s.from.y == s.to.y
                     ? sy.rounded()
                     : rounded_coordinate(sy, lambda, doubled_sum(s.to.y, -s.from.y));
  return x && y ? std::optional(RoundedVertex{*x, *y}) : std::nullopt;
}

}  // namespace gcv
