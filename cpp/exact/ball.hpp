// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Double-double numbers that know how far off they are, for roots and quotients. u = 2^-53. All
// bounds hold for numbers that are 0 or in range (is_in_range): then no product is near underflow
// or overflow.
#pragma once

#include <cmath>

#include "double_double.hpp"
#include "fma.hpp"

namespace gcv {

// A number within `error` of hi + lo. hi is the double nearest to hi + lo.
struct Ball {
  double hi;
  double lo;
  double error;

  static Ball of(const DoubleDouble& x) {
    return normal(x.hi, x.lo, x.is_exact ? 0 : 5 * unit_roundoff * unit_roundoff * x.size);
  }
  static Ball of(const DoubleDoubleCross& x) { return {x.hi, x.lo, x.error}; }

  // hi + lo with that error, where |lo| may be up to a few ulps of hi.
  static Ball normal(double hi, double lo, double error) {
    const double sum = hi + lo;
    return {sum, rounding_error(hi, lo, sum), error};
  }

  Ball operator-() const { return {-hi, -lo, error}; }
};

// What is left out of sums, products, quotients and roots is below this times the result.
inline constexpr double ball_roundoff = 32 * unit_roundoff * unit_roundoff;

// The lo parts are below 2u of the larger summand, so their roundings are below 8u^2 of it.
inline Ball operator+(const Ball& p, const Ball& q) {
  const double hi = p.hi + q.hi;
  const double lo = rounding_error(p.hi, q.hi, hi) + (p.lo + q.lo);
  return Ball::normal(hi, lo,
                      2 * (p.error + q.error) + ball_roundoff * (std::abs(p.hi) + std::abs(q.hi)));
}

// Leaves out lo times lo.
inline Ball operator*(const Ball& p, const Ball& q) {
  const double hi = p.hi * q.hi;
  const double lo = gcv::fma(p.hi, q.hi, -hi) + (p.hi * q.lo + p.lo * q.hi);
  const double error = 2 * (std::abs(p.hi) * q.error + std::abs(q.hi) * p.error) +
                       2 * p.error * q.error + ball_roundoff * std::abs(hi);
  return Ball::normal(hi, lo, error);
}

// Infinite error where d may be 0.
inline Ball operator/(const Ball& p, const Ball& d) {
  const double hi = p.hi / d.hi;
  const double lo = ((gcv::fma(-hi, d.hi, p.hi) + p.lo) - hi * d.lo) / d.hi;
  const double size = std::abs(d.hi);
  const double error = 4 * (p.error + std::abs(hi) * d.error) / size + ball_roundoff * std::abs(hi);
  return Ball::normal(hi, lo, size > 4 * d.error ? error : infinity);
}

// Of a number above 0; infinite error where it may be less. The root of x (1 + e) is within |e| of
// that of x, relatively, for |e| below 1/4.
inline Ball square_root(const Ball& x) {
  const double hi = std::sqrt(x.hi);
  const double lo = (gcv::fma(-hi, hi, x.hi) + x.lo) / (2 * hi);
  const double error = 2 * x.error / hi + ball_roundoff * hi;
  return Ball::normal(hi, lo, x.hi > 4 * x.error ? error : infinity);
}

inline bool is_in_range(double x) {
  const double size = std::abs(x);
  return size == 0 || (size >= 0x1p-200 && size <= 0x1p200);
}

}  // namespace gcv
