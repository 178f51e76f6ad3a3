// SPDX-License-Identifier: LGPL-3.0-or-later
#include "exact_ring.hpp"

#include "exact_coordinates.hpp"

namespace gcv {

namespace {

// n / w * 2^exponent in lowest terms.
std::string fraction(BigInteger n, BigInteger w, int exponent) {
  if (exponent >= 0) {
    n <<= exponent;
  } else {
    w <<= -exponent;
  }
  const BigInteger divisor = gcd(n, w);
  return BigInteger(n / divisor).str() + "/" + BigInteger(w / divisor).str();
}

}  // namespace

std::string exact_vertex(const ExactRing& ring, std::size_t k) {
  const ExactVertex vertex(ring, k);
  const auto p = vertex.homogeneous<BigInteger>();
  const int exponent = vertex.grid().exponent();
  return fraction(p.x, p.w, exponent) + " " + fraction(p.y, p.w, exponent);
}

}  // namespace gcv
