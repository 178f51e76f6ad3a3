// SPDX-License-Identifier: LGPL-3.0-or-later
#include "far_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vector.hpp"

namespace gcv {

namespace {

constexpr double least_ratio = 0x1p42;

double extents_of(const PlacedPair& placed) {
  return gcv::extents_of(placed.a.boundary.bounds) + gcv::extents_of(placed.b.boundary.bounds);
}

// The vertices that lie furthest along a unit vector, or not as far by up to the margin.
std::vector<Index> furthest_vertices(const Boundary& polygon, const Point& unit, double margin) {
  const auto along = [&](Index i) {
    const Point p = polygon.relative(i);
    return unit.x * p.x + unit.y * p.y;
  };
  double furthest = -infinity;
  for (Index i = 0; i < polygon.size(); ++i) {
    furthest = std::max(furthest, along(i));
  }
  std::vector<Index> vertices;
  for (Index i = 0; i < polygon.size(); ++i) {
    if (along(i) >= furthest - margin) {
      vertices.push_back(i);
    }
  }
  return vertices;
}

}  // namespace

bool are_far_apart(const PlacedPair& placed) {
  const Point offset = placed.offset();
  const double size = std::max(std::abs(offset.x), std::abs(offset.y));
  return size < infinity && size > least_ratio * extents_of(placed);
}

// The offset and the unit vector are off by a few u of themselves, relative coordinates by a few u
// of the extents. So of the margin, 2^-40 of these, |v|^2 / |D| takes a quarter at most, and
// roundings much less.
std::vector<ContactName> nearest_of_far_pair(const PlacedPair& placed) {
  const Boundary& a = placed.a.boundary;
  const Boundary& b = placed.b.boundary;
  const Point unit = unit_vector(placed.offset());
  const double margin = 0x1p-40 * extents_of(placed) + std::numeric_limits<double>::min();
  const std::vector<Index> of_a = furthest_vertices(a, unit, margin);
  const std::vector<Index> of_b = furthest_vertices(b, {-unit.x, -unit.y}, margin);
  std::vector<ContactName> pairs;
  for (const Index i : of_a) {
    for (const Index j : of_b) {
      pairs.push_back({ContactKind::edge_vertex, i, j});
      pairs.push_back({ContactKind::edge_vertex, a.previous(i), j});
      pairs.push_back({ContactKind::vertex_edge, i, j});
      pairs.push_back({ContactKind::vertex_edge, i, b.previous(j)});
    }
  }
  return pairs;
}

}  // namespace gcv
