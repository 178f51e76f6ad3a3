// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Small fractions, and doubles that are their correctly rounded roots.
#pragma once

#include <compare>
#include <string>

#include "plane.hpp"

namespace worlds {

// In lowest terms; the denominator is positive, or 0 for infinity.
struct Fraction {
  Int numerator;
  Int denominator;
  bool operator==(const Fraction&) const = default;
};

inline std::strong_ordering operator<=>(Fraction a, Fraction b) {
  return Wide{a.numerator} * b.denominator <=> Wide{b.numerator} * a.denominator;
}

Fraction reduced(Int numerator, Int denominator);

// "p/q".
std::string text(Fraction fraction);

// The nearest double. Numerator and denominator are doubles.
double nearest_double(Fraction fraction);

// Is a double the one nearest to the root of a fraction? The fraction is below 2^20, with a
// denominator below 2^14, and not between 0 and 2^-20.
bool is_nearest_root(double root, Fraction square);

}  // namespace worlds
