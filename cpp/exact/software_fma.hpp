// SPDX-License-Identifier: LGPL-3.0-or-later
//
// fma(x, y, z) where there is no instruction for it.
// Heavy headers: include this in source files only.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "exact_numbers.hpp"
#include "to_double.hpp"

namespace gcv {

// Slow.
inline double fma_by_integers(double x, double y, double z) {
  if (!std::isfinite(x) || !std::isfinite(y) || x == 0 || y == 0) {
    return x * y + z;
  }
  if (!std::isfinite(z)) {
    return z;
  }
  const Decomposed a = decompose(x);
  const Decomposed b = decompose(y);
  const Decomposed c = decompose(z);
  const int exponent = std::min(a.exponent + b.exponent, c.exponent);
  BigInteger product = BigInteger(a.mantissa) * b.mantissa;
  product <<= a.exponent + b.exponent - exponent;
  BigInteger addend(c.mantissa);
  addend <<= c.exponent - exponent;
  return nearest_double(BigInteger(product + addend), BigInteger(1), exponent).value;
}

// Two numbers of 26 bits whose sum is x (Veltkamp, 1968).
inline std::pair<double, double> halves(double x) {
  const double wide = 0x8000001p0 * x;
  const double high = wide - (wide - x);
  return {high, x - high};
}

// Where z cancels most of the product, which is what fma() is called for here, z plus the rounded
// product is exact. What rounding took from the product (Dekker, 1971) is then all that is missing.
inline double software_fma(double x, double y, double z) {
  const double product = x * y;
  const double size = std::abs(product);
  if (std::abs(x) < 0x1p990 && std::abs(y) < 0x1p990 && size > 0x1p-960 && size < 0x1p1000) {
    const double sum = product + z;
    const double z_in_sum = sum - product;
    if (product == sum - z_in_sum && z == z_in_sum) {
      const auto [x_high, x_low] = halves(x);
      const auto [y_high, y_low] = halves(y);
      return sum +
             (x_low * y_low - (((product - x_high * y_high) - x_low * y_high) - x_high * y_low));
    }
  }
  return fma_by_integers(x, y, z);
}

}  // namespace gcv
