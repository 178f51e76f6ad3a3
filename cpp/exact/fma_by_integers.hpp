// SPDX-License-Identifier: LGPL-3.0-or-later
//
// fma(x, y, z) where there is no instruction for it: slow, but exact.
// Heavy headers: include this in source files only.
#pragma once

#include <algorithm>
#include <cmath>

#include "exact_numbers.hpp"
#include "to_double.hpp"

namespace gcv {

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

}  // namespace gcv
