// SPDX-License-Identifier: LGPL-3.0-or-later
#include "ring_predicates.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <type_traits>

#include "double_double.hpp"
#include "exact_coordinates.hpp"
#include "fma.hpp"
#include "predicates.hpp"

namespace gcv {

namespace {

// n / w * 2^exponent, in lowest terms.
template <class Integer>
std::string fraction(Integer n, Integer w, int exponent) {
  if (exponent >= 0) {
    n <<= exponent;
  } else {
    w <<= -exponent;
  }
  const Integer divisor = gcd(n, w);
  return Integer(n / divisor).str() + "/" + Integer(w / divisor).str();
}

// The side of the line on which the crossing of s and t lies. Nothing if it is too close to the
// line.
//
// The side is the sign of d x (o_s - o) + lambda (d x d_s), where d and o are those of the line.
// Error bound. Each lo part is below 4u of its hi part; all lo parts are below 8u of both terms.
// Their roundings and the product of two lo parts, which is left out, are below 64u^2 of both
// terms. The smallest normal double covers underflow.
std::optional<int> side_in_doubles(const SumEdge& line, const SumEdge& s, const SumEdge& t) {
  const DoubleDoubleVector direction = double_double_vector(line.from, line.to);
  const DoubleDoubleCross offset =
      double_double_cross(direction, double_double_vector(line.origin, s.origin));
  const DoubleDoubleCross along =
      double_double_cross(direction, double_double_vector(s.from, s.to));
  const DoubleDoubleParameter lambda = double_double_parameter(s, t);
  const double way = lambda.hi * along.hi;
  const double way_lo =
      gcv::fma(lambda.hi, along.hi, -way) + (lambda.hi * along.lo + lambda.lo * along.hi);
  const double hi = offset.hi + way;
  const double value = hi + (rounding_error(offset.hi, way, hi) + (offset.lo + way_lo));
  const double error = offset.error + (2 * std::abs(lambda.hi) + lambda.error) * along.error +
                       2 * lambda.error * std::abs(along.hi) +
                       64 * unit_roundoff * unit_roundoff * (std::abs(offset.hi) + std::abs(way)) +
                       std::numeric_limits<double>::min();
  return std::abs(value) > 2 * error ? std::optional(value > 0 ? 1 : -1) : std::nullopt;
}

}  // namespace

// For a crossing (x / w, y / w) the side is the sign of d x ((x, y) - w o). Let b be the bits of
// the grid. The second factor is below 2^(3b+7), so the result is below 2^(4b+9).
int side_of_vertex(const Boundary& a, const Boundary& b, const SumEdge& line, const RingVertex& v,
                   Tally& tally) {
  if (v.is_sum()) {
    return side(line, point_of(a, b, {v.i(), v.j()}), tally);
  }
  const SumEdge s = coordinates(a, b, v.arriving());
  const SumEdge t = coordinates(a, b, v.leaving());
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
    const Vector<Integer> origin = sum_of<Integer>(grid, line.origin, {0, 0});
    const Vector<Integer> offset{p.x - p.w * origin.x, p.y - p.w * origin.y};
    return sign(cross(vector_between<Integer>(grid, line.from, line.to), offset));
  });
}

int exact_side(const ExactRing& ring, std::size_t edge, std::size_t vertex, Tally& tally) {
  const Boundary& a = *ring.a.ring;
  const Boundary& b = *ring.b.ring;
  const int side = side_of_vertex(a, b, coordinates(a, b, ring.vertices[edge].leaving()),
                                  ring.vertices[vertex], tally);
  return ring.against_edges ? -side : side;
}

std::string exact_vertex(const ExactRing& ring, std::size_t k) {
  return exact_vertex(*ring.a.ring, *ring.b.ring, ring.vertices[k], ring.shift);
}

std::string exact_vertex(const Boundary& a, const Boundary& b, const RingVertex& v,
                         const Point& shift) {
  const ExactVertex vertex(a, b, v, shift);
  const int exponent = vertex.grid().exponent();
  // At least 128 bits, because Int128 has no conversion to text.
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
