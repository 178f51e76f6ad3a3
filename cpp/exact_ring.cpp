// SPDX-License-Identifier: LGPL-3.0-or-later
#include "exact_ring.hpp"

#include <algorithm>
#include <cstdlib>
#include <type_traits>

#include "exact_coordinates.hpp"

namespace gcv {

namespace {

template <class Integer>
std::string to_text(const Integer& value) {
  return value.str();
}

// Boost's own way leaks GMP's text where there is no memory for a copy of it.
std::string to_text(const BigInteger& value) {
  std::string text(mpz_sizeinbase(value.backend().data(), 10) + 2, '\0');
  mpz_get_str(text.data(), 10, value.backend().data());
  text.resize(text.find('\0'));
  return text;
}

// n / w * 2^exponent in lowest terms.
template <class Integer>
std::string fraction(Integer n, Integer w, int exponent) {
  if (exponent >= 0) {
    n <<= exponent;
  } else {
    w <<= -exponent;
  }
  const Integer divisor = gcd(n, w);
  return to_text(Integer(n / divisor)) + "/" + to_text(Integer(w / divisor));
}

}  // namespace

// For a crossing (x / w, y / w), the sign of d x ((x, y) - w o). With b the grid's bits the
// second factor is below 2^(3b+7), so the result is below 2^(4b+9).
int exact_side(const ExactRing& ring, std::size_t edge, std::size_t vertex, Tally& tally) {
  const SumEdge line = coordinates(*ring.a.polygon, *ring.b.polygon, ring.vertices[edge].leaving);
  const RingVertex& v = ring.vertices[vertex];
  if (v.is_sum) {
    return side(line, {ring.a.polygon->vertices[v.i], ring.b.polygon->vertices[v.j]}, tally);
  }
  const SumEdge s = coordinates(*ring.a.polygon, *ring.b.polygon, v.arriving);
  const SumEdge t = coordinates(*ring.a.polygon, *ring.b.polygon, v.leaving);
  Grid grid;
  grid.include(line);
  grid.include(s);
  grid.include(t);
  return with_integers(4 * grid.bits() + 9, tally, [&]<class Integer>() {
    const auto p = crossing<Integer>(grid, s, t, {0, 0});
    const auto sum = [&](double x, double y) {
      return Integer(grid.integer<Integer>(x) + grid.integer<Integer>(y));
    };
    const Vector<Integer> offset{p.x - p.w * sum(line.origin.a.x, line.origin.b.x),
                                 p.y - p.w * sum(line.origin.a.y, line.origin.b.y)};
    return sign(cross(vector_between<Integer>(grid, line.from, line.to), offset));
  });
}

std::string exact_vertex(const ExactRing& ring, std::size_t k) {
  const ExactVertex vertex(ring, k);
  const int exponent = vertex.grid().exponent();
  // At least 128 bits: the narrowest integers have no text form.
  const int bits = std::max(128, vertex.bits() + std::abs(exponent));
  Tally tally;
  return with_integers(bits, tally, [&]<class Integer>() -> std::string {
    if constexpr (std::is_same_v<Integer, Int128>) {
      return {};
    } else {
      const auto p = vertex.homogeneous<Integer>();
      return fraction(p.x, p.w, exponent) + " " + fraction(p.y, p.w, exponent);
    }
  });
}

}  // namespace gcv
