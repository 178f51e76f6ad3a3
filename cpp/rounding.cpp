// SPDX-License-Identifier: LGPL-3.0-or-later
#include "rounding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "error.hpp"
#include "exact_coordinates.hpp"
#include "simplicity.hpp"
#include "to_double.hpp"

namespace gcv {

namespace {

struct RoundedVertex {
  RoundedNumber x;
  RoundedNumber y;
};

// A sum of two doubles is correctly rounded by adding them; TwoSum tells the error.
RoundedNumber rounded_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  const double error = (a - (sum - b_part)) + (b - b_part);
  return {sum + 0.0, error == 0};
}

RoundedVertex rounded_vertex(const ExactRing& ring, std::size_t k, Tally& tally) {
  const ExactVertex vertex(ring, k);
  if (vertex.is_sum() && ring.shift == Point{0, 0}) {
    ++tally.filtered;
    return {rounded_sum(vertex.sum().a.x, vertex.sum().b.x),
            rounded_sum(vertex.sum().a.y, vertex.sum().b.y)};
  }
  const int exponent = vertex.grid().exponent();
  return with_integers(rounding_bits(vertex.bits()), tally, [&]<class Integer>() {
    const auto p = vertex.homogeneous<Integer>();
    return RoundedVertex{nearest_double(p.x, p.w, exponent), nearest_double(p.y, p.w, exponent)};
  });
}

// At least the distance of a number from the double that it was rounded to.
double rounding_error(const RoundedNumber& number) {
  if (number.exact) {
    return 0;
  }
  const double size = std::abs(number.value);
  const double unit = size == std::numeric_limits<double>::max()
                          ? size - std::nextafter(size, 0.0)
                          : std::nextafter(size, HUGE_VAL) - size;
  return std::max(unit / 2, std::numeric_limits<double>::denorm_min());
}

// At least sqrt(x^2 + y^2): five roundings, each below u, are made good. Where the
// smaller one is lost beside the larger, so is its share of the result.
double length_bound(double x, double y) {
  const double longer = std::max(x, y);
  const double shorter = std::min(x, y);
  if (shorter == 0) {
    return longer;
  }
  const double ratio = shorter / longer;
  const double length = longer * std::sqrt(1 + ratio * ratio);
  return std::nextafter(length * (1 + 4 * std::numeric_limits<double>::epsilon()), HUGE_VAL);
}

void check_finite(const ExactRing& ring, std::size_t k, const RoundedVertex& vertex) {
  const bool x_is_finite = std::isfinite(vertex.x.value);
  if (x_is_finite && std::isfinite(vertex.y.value)) {
    return;
  }
  // A crossing is named by the edge that it lies on.
  const bool is_sum = ring.vertices[k].is_sum;
  const Index i = is_sum ? ring.vertices[k].i : ring.leaving[k].i;
  const Index j = is_sum ? ring.vertices[k].j : ring.leaving[k].j;
  throw Error(
      Status::range,
      "the %s coordinate of vertex %zu of the outer face, %s vertex %u of %s + vertex %u of "
      "%s, is beyond the largest double",
      x_is_finite ? "y" : "x", k, is_sum ? "the sum" : "on an edge from the sum",
      ring.a.polygon->vertex_number[i], ring.a.name, ring.b.polygon->vertex_number[j], ring.b.name);
}

}  // namespace

// Moving the vertices of a ring by at most d moves each point of it by at most d, so the
// rings are within the largest error of a vertex of each other.
RoundedRing round_to_nearest(const ExactRing& ring, Tally& tally) {
  RoundedRing rounded;
  rounded.vertices.reserve(ring.size());
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const RoundedVertex vertex = rounded_vertex(ring, k, tally);
    check_finite(ring, k, vertex);
    rounded.vertices.push_back({vertex.x.value, vertex.y.value});
    rounded.error_bound = std::max(
        rounded.error_bound, length_bound(rounding_error(vertex.x), rounding_error(vertex.y)));
  }
  if (const auto conflict = find_conflict(rounded.vertices)) {
    throw Error(Status::range,
                "the doubles nearest to the vertices of the outer face do not form a simple ring: "
                "edges %zu and %zu meet near (%.17g, %.17g)",
                conflict->first, conflict->second, rounded.vertices[conflict->first].x,
                rounded.vertices[conflict->first].y);
  }
  return rounded;
}

}  // namespace gcv
