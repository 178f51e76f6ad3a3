// SPDX-License-Identifier: LGPL-3.0-or-later
#include "fractions.hpp"

#include <cmath>
#include <numeric>

namespace worlds {

Fraction reduced(Int numerator, Int denominator) {
  const Int g = std::gcd(numerator, denominator);
  return {numerator / g, denominator / g};
}

std::string text(Fraction fraction) {
  return std::to_string(fraction.numerator) + "/" + std::to_string(fraction.denominator);
}

double nearest_double(Fraction fraction) {
  return static_cast<double>(fraction.numerator) / static_cast<double>(fraction.denominator);
}

bool is_nearest_root(double root, Fraction square) {
  if (square.numerator == 0 || square.denominator == 0) {
    return root == nearest_double(square);
  }
  if (!(std::abs(root - std::sqrt(nearest_double(square))) < 1e-9)) {
    return false;
  }
  // The root is m 2^e. What is rounded to it lies between the two means of it and its neighbours.
  // No fraction of so small numbers is the square of such a mean.
  int e = 0;
  const Int m = static_cast<Int>(std::ldexp(std::frexp(root, &e), 53));
  e -= 53;
  const Wide low = Wide{4} * m - (m == Int{1} << 52 ? 1 : 2);
  const Wide high = Wide{4} * m + 2;
  const Wide scaled = Wide{square.numerator} << (-2 * (e - 2));
  return low * low * square.denominator < scaled && scaled < high * high * square.denominator;
}

}  // namespace worlds
