// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Correct rounding of a fraction of integers to a double.
// Heavy headers: include this in source files only.
#pragma once

#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <utility>

#include "double_double_rounding.hpp"
#include "exact_numbers.hpp"

namespace gcv {

inline int bit_length(Int128 value) {
  const auto high = static_cast<std::uint64_t>(value >> 64);
  return high != 0 ? 64 + static_cast<int>(std::bit_width(high))
                   : static_cast<int>(std::bit_width(static_cast<std::uint64_t>(value)));
}
template <class Integer>
int bit_length(const Integer& value) {
  return static_cast<int>(msb(value)) + 1;
}

inline std::pair<Int128, Int128> divide(Int128 n, Int128 d) {
  return {n / d, n % d};  // NOLINT(clang-analyzer-core.DivideZero): denominators are positive
}

template <class Integer>
std::pair<Integer, Integer> divide(const Integer& n, const Integer& d) {
  std::pair<Integer, Integer> result;
  divide_qr(n, d, result.first, result.second);
  return result;
}

// The bits that integers need to round n / w, where n and w are below 2^bits.
constexpr int rounding_bits(int bits) { return bits + 58; }
// The same for the root of n / w.
constexpr int root_bits(int bits) { return bits + 116; }

// The double nearest to digits 2^unit, ties to even, with the sign given. There are 55 to 57 digits
// that count; `sticky` tells whether there are more behind them.
inline RoundedNumber rounded_digits(std::uint64_t digits, int unit, bool sticky, bool negative) {
  const int last = std::max(unit + static_cast<int>(std::bit_width(digits)) - 53, -1074);
  const int dropped = last - unit;  // at least 2
  if (dropped > 57) {
    return {negative ? -0.0 : 0.0, false};  // below half the smallest double
  }
  const std::uint64_t rest = digits & ((std::uint64_t{1} << dropped) - 1);
  const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
  std::uint64_t mantissa = digits >> dropped;
  if (rest > half || (rest == half && (sticky || (mantissa & 1) != 0))) {
    ++mantissa;
  }
  const double magnitude = std::ldexp(static_cast<double>(mantissa), last);
  return {negative ? -magnitude : magnitude, rest == 0 && !sticky};
}

// The first bits of n / w, for n and w above 0: at least digits 2^unit, and less than (digits + 1)
// 2^unit. There are 55 or 56 digits. Exact unless `sticky`.
struct Quotient {
  std::uint64_t digits;
  int unit;
  bool sticky;
};

template <class Integer>
Quotient quotient(Integer n, Integer w) {
  const int shift = 55 - (bit_length(n) - bit_length(w));
  if (shift >= 0) {
    n <<= shift;
  } else {
    w <<= -shift;
  }
  const auto [digits, remainder] = divide(n, w);
  return {static_cast<std::uint64_t>(digits), -shift, sign(remainder) != 0};
}

// The double nearest to n / w * 2^exponent, ties to even. w must be positive.
//
// A power of two scales the fraction to a quotient of 55 or 56 bits. Its bits below the last bit of
// the double, and the remainder, tell which way to round.
template <class Integer>
RoundedNumber nearest_double(const Integer& n, const Integer& w, int exponent) {
  assert(sign(w) > 0);
  const int sign_of_n = sign(n);
  if (sign_of_n == 0) {
    return {0.0, true};
  }
  const Quotient scaled = quotient(sign_of_n < 0 ? Integer(-n) : n, w);
  return rounded_digits(scaled.digits, exponent + scaled.unit, scaled.sticky, sign_of_n < 0);
}

// The largest double that is at most n / w, for n from 0 on and w above 0.
template <class Integer>
double double_below(const Integer& n, const Integer& w) {
  assert(sign(n) >= 0 && sign(w) > 0);
  if (sign(n) == 0) {
    return 0;
  }
  const Quotient scaled = quotient(n, w);
  const int last =
      std::max(scaled.unit + static_cast<int>(std::bit_width(scaled.digits)) - 53, -1074);
  const int dropped = last - scaled.unit;
  return dropped > 63 ? 0 : std::ldexp(static_cast<double>(scaled.digits >> dropped), last);
}

// The double nearest to sqrt(n / w) * 2^exponent, ties to even. n must not be negative, and w must
// be positive.
//
// A power of four scales the fraction to a quotient of 110 to 112 bits. Its root has 55 or 56 bits.
template <class Integer>
RoundedNumber nearest_root(Integer n, Integer w, int exponent) {
  assert(sign(n) >= 0 && sign(w) > 0);
  if (sign(n) == 0) {
    return {0.0, true};
  }
  const int excess = 110 - (bit_length(n) - bit_length(w));
  const int shift = excess + (excess & 1);
  if (shift >= 0) {
    n <<= shift;
  } else {
    w <<= -shift;
  }
  const auto [quotient, remainder] = divide(n, w);
  const Integer root = sqrt(quotient);
  const bool sticky = sign(remainder) != 0 || root * root != quotient;
  return rounded_digits(static_cast<std::uint64_t>(root), exponent - shift / 2, sticky, false);
}

}  // namespace gcv
