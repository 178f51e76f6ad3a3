// SPDX-License-Identifier: LGPL-3.0-or-later
#include "exact_ring.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <type_traits>

#include "doubled.hpp"
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

// The side of the line on which the crossing of s and t lies; nothing where it is too close.
//
// It is the sign of d x (o_s - o) + lambda (d x d_s), d and o those of the line. The tails are
// below 4u of what they belong to, together below 8u of both terms, and their roundings and what is
// left out, tail times tail, below 64u^2 of those. The smallest normal double covers underflow.
std::optional<int> side_in_doubles(const SumEdge& line, const SumEdge& s, const SumEdge& t) {
  const DoubledVector direction = doubled_vector(line.from, line.to);
  const DoubledCross offset = doubled_cross(direction, doubled_vector(line.origin, s.origin));
  const DoubledCross along = doubled_cross(direction, doubled_vector(s.from, s.to));
  const DoubledParameter lambda = doubled_parameter(s, t);
  const double way = lambda.head * along.head;
  const double way_tail = std::fma(lambda.head, along.head, -way) +
                          (lambda.head * along.tail + lambda.tail * along.head);
  const double head = offset.head + way;
  const double value = head + (rounding_error(offset.head, way, head) + (offset.tail + way_tail));
  const double error =
      offset.error + (2 * std::abs(lambda.head) + lambda.error) * along.error +
      2 * lambda.error * std::abs(along.head) +
      64 * unit_roundoff * unit_roundoff * (std::abs(offset.head) + std::abs(way)) +
      std::numeric_limits<double>::min();
  return std::abs(value) > 2 * error ? std::optional(value > 0 ? 1 : -1) : std::nullopt;
}

}  // namespace

// For a crossing (x / w, y / w), the sign of d x ((x, y) - w o). With b the grid's bits the
// second factor is below 2^(3b+7), so the result is below 2^(4b+9).
int exact_side(const ExactRing& ring, std::size_t edge, std::size_t vertex, Tally& tally) {
  const SumEdge line = coordinates(*ring.a.polygon, *ring.b.polygon, ring.vertices[edge].leaving());
  const RingVertex& v = ring.vertices[vertex];
  if (v.is_sum()) {
    return side(line, {ring.a.polygon->vertices[v.i()], ring.b.polygon->vertices[v.j()]}, tally);
  }
  const SumEdge s = coordinates(*ring.a.polygon, *ring.b.polygon, v.arriving());
  const SumEdge t = coordinates(*ring.a.polygon, *ring.b.polygon, v.leaving());
  if (const std::optional<int> side = side_in_doubles(line, s, t)) {
    ++tally.fixed_width;
    return *side;
  }
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
