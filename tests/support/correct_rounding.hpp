// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Is a double the right one for an exact number? Shown in fractions: the number lies between the
// middles of the double and its neighbours. No square root is taken.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "exact_geometry.hpp"

namespace gcv::invariants {

// The next double above, or what it would be without a largest one.
inline Rational exactly_above(double x) {
  const double next = std::nextafter(x, HUGE_VAL);
  return std::isfinite(next) ? Rational(next) : Rational(std::ldexp(1.0, 1023)) * 2;
}

inline Rational middle_above(double x) { return (Rational(x) + exactly_above(x)) / 2; }
inline Rational middle_below(double x) { return -middle_above(-x); }
inline bool is_even(double x) { return std::bit_cast<std::uint64_t>(x) % 2 == 0; }

// Has the exact number no nearest double?
inline bool overflows(const Rational& exact) {
  return abs(exact) >= middle_above(std::numeric_limits<double>::max());
}
inline bool root_overflows(const Rational& square) {
  const Rational middle = middle_above(std::numeric_limits<double>::max());
  return square >= middle * middle;
}

// Is x the double nearest to the exact number, ties to even? 0 is never -0.
inline bool is_nearest(double x, const Rational& exact) {
  if (!std::isfinite(x) || (x == 0 && std::signbit(x))) {
    return false;
  }
  const Rational low = middle_below(x);
  const Rational high = middle_above(x);
  return is_even(x) ? low <= exact && exact <= high : low < exact && exact < high;
}

// Is x the double nearest to the root of the square, ties to even?
inline bool is_nearest_root(double x, const Rational& square) {
  if (!std::isfinite(x) || std::signbit(x)) {
    return false;
  }
  const Rational low = x == 0 ? Rational(0) : middle_below(x);
  const Rational high = middle_above(x);
  return is_even(x) ? low * low <= square && square <= high * high
                    : low * low < square && square < high * high;
}

// Is x the largest double that is not above the exact number?
inline bool is_rounded_down(double x, const Rational& exact) {
  return std::isfinite(x) && Rational(x) <= exact && exact < exactly_above(x);
}

// Is x within one unit in the last place of part / root(square)?
inline bool is_near_quotient(double x, const Rational& part, const Rational& square) {
  if (!std::isfinite(x) || part == 0) {
    return x == 0;
  }
  if (x != 0 && (x > 0) != (part > 0)) {
    return false;
  }
  // part^2 / square lies between the squares of the neighbours of x, both of its sign.
  const double size = std::abs(x);
  const Rational low = size == 0 ? Rational(0) : -exactly_above(-size);
  const Rational high = exactly_above(size);
  return low * low * square <= part * part && part * part <= high * high * square;
}

}  // namespace gcv::invariants
