// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Doubles to attack predicates with, and exact rationals to check them by.
#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <limits>

#include "exact_numbers.hpp"
#include "generators.hpp"

namespace gcv::test {

using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

inline Rational rational(double x) { return Rational(x); }

// A point or a vector.
struct RationalPoint {
  Rational x;
  Rational y;
};
inline RationalPoint rational(const Point& p) { return {rational(p.x), rational(p.y)}; }
inline RationalPoint rational(const SumPoint& p) {
  return {rational(p.a.x) + rational(p.b.x) + rational(p.c.x),
          rational(p.a.y) + rational(p.b.y) + rational(p.c.y)};
}
inline RationalPoint between(const RationalPoint& p, const RationalPoint& q) {
  return {q.x - p.x, q.y - p.y};
}
inline Rational cross(const RationalPoint& v, const RationalPoint& w) {
  return v.x * w.y - v.y * w.x;
}
inline Rational dot(const RationalPoint& v, const RationalPoint& w) {
  return v.x * w.x + v.y * w.y;
}

// Halfway from a double, not below 0, to the next one.
inline Rational halfway_up(double x) {
  const double next = std::nextafter(x, std::numeric_limits<double>::infinity());
  return std::isfinite(next) ? Rational((rational(x) + rational(next)) / 2)
                             : Rational(rational(x) + rational(0x1p970));
}

// Is x the double nearest to the root of a number? Of two that are as near, either will do.
inline bool is_nearest_root(double x, const Rational& square) {
  const bool is_finite = std::isfinite(x);
  const Rational above = is_finite ? halfway_up(x) : Rational(0);
  const Rational below = x > 0 ? halfway_up(std::nextafter(x, 0.0)) : Rational(0);
  return x >= 0 && below * below <= square && (!is_finite || square <= above * above);
}

// A double of one of many kinds: small integers, grids, neighbours of each other, any
// exponent, subnormal numbers, the largest ones.
inline double attacking_double(Random& random) {
  const double sign = uniform(random, 0, 1) == 0 ? 1 : -1;
  const double mantissa = 1 + std::ldexp(static_cast<double>(random() >> 12), -52);
  switch (uniform(random, 0, 10)) {
    case 0:
    case 1:
      return sign * uniform(random, 0, 4);
    case 2:
      return sign * uniform(random, 0, 1000000) / 64;
    case 3:
      return sign * (1 + uniform(random, 0, 3) * std::numeric_limits<double>::epsilon());
    case 4:
      return sign * (std::ldexp(1.0, 52) + uniform(random, -3, 3) / 2.0);
    case 5:
      return sign * mantissa;
    case 6:
      return sign * std::ldexp(mantissa, uniform(random, -40, 40));
    case 7:
      return sign * std::ldexp(mantissa, uniform(random, -1022, 1023));
    case 9:
      return sign * (std::numeric_limits<double>::max() - uniform(random, 0, 1) * 0x1p971);
    case 8:
      return sign * uniform(random, 0, 5) * std::numeric_limits<double>::denorm_min();
    default:
      return sign * std::ldexp(mantissa, uniform(random, 1020, 1023));
  }
}

// Operands of one attack: all of one kind of magnitude, or wildly mixed; and often with
// values repeated, which makes ties.
class Attack {
 public:
  explicit Attack(Random& random) : random_(random), mixed_(uniform(random, 0, 3) == 0) {
    for (double& value : pool_) {
      value = attacking_double(random);
    }
    scale_ = uniform(random, -30, 30);
  }

  double number() {
    if (mixed_) {
      return uniform(random_, 0, 2) == 0 ? attacking_double(random_) : pool_[pick()];
    }
    return std::ldexp(uniform(random_, -6, 6), scale_) +
           (uniform(random_, 0, 9) == 0 ? std::ldexp(uniform(random_, -2, 2), scale_ - 50) : 0);
  }
  Point point() {
    const double x = number();
    return {x, number()};
  }
  SumPoint sum_point() {
    const Point a = point();
    return {a, point()};
  }
  SumEdge edge() {
    SumEdge e{sum_point(), point(), point(), 0, 0};
    if (uniform(random_, 0, 1) == 0) {
      e.from = e.origin.a;
    }
    e.dx = e.to.x - e.from.x;
    e.dy = e.to.y - e.from.y;
    return e;
  }

 private:
  std::size_t pick() { return static_cast<std::size_t>(uniform(random_, 0, 3)); }

  Random& random_;
  bool mixed_;
  int scale_;
  double pool_[4];
};

}  // namespace gcv::test
