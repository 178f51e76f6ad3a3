// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The method. The boundary is cut into chains, each as long as a segment between its ends can
// replace it. Rounding outward, three more things happen. A chain is replaced by the part of its
// convex hull on the outer side. A dent between two hulls gets a segment over it. A run of convex
// vertices is replaced by the point where the edges before and behind it meet.
//
// Distances. Let a chain be within e of the segment between its ends. The chain passes every
// perpendicular of the segment, so no point of the segment is further than e from the chain. The
// chain can be moved to the segment, each point in a straight line and by e at most. So every point
// that is inside only one of the boundaries is within e of both.
//
// Containment. Outward, every part of the new boundary goes round the chain that it replaces on the
// outer side of the chain. So no winding number falls. Where the new boundary is simple, its inside
// contains the polygon.
//
// Simplicity. Where edges of the new boundary meet, the tolerance is cut along the chains that they
// replace, at last to 0. With tolerance 0 the given boundary stays.
#include "simplification.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "dents_and_caps.hpp"
#include "error.hpp"
#include "ring_nesting.hpp"
#include "shortcuts.hpp"
#include "simplicity.hpp"

namespace gcv {

namespace {

PointVector points_of(const NewBoundary& boundary) {
  PointVector points;
  points.reserve(boundary.size());
  for (const NewVertex& v : boundary) {
    points.push_back(v.point);
  }
  return points;
}

// The edges that keep the boundary from being a simple ring of that kind.
std::vector<Index> wrong_edges(const NewBoundary& boundary, Boundary::Kind kind) {
  std::vector<Index> wrong;
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    if (boundary[k].point == at(boundary, k + 1).point) {
      wrong.push_back(static_cast<Index>(k));
    }
  }
  if (!wrong.empty()) {
    return wrong;
  }
  const PointVector points = points_of(boundary);
  const bool has_area = points.size() > 2;
  if (has_area) {
    for (const std::size_t edge : find_conflicting_edges(points)) {
      wrong.push_back(static_cast<Index>(edge));
    }
  }
  if (wrong.empty() &&
      (!has_area || is_counter_clockwise(points) != (kind == Boundary::Kind::outer))) {
    wrong.resize(boundary.size());
    std::iota(wrong.begin(), wrong.end(), Index{0});
  }
  return wrong;
}

// The new ring, with the numbers of the given one.
Simplified as_ring(const NewBoundary& boundary, const Shortcuts& shortcuts) {
  const Boundary& given = shortcuts.ring();
  double error = 0;
  for (const NewVertex& v : boundary) {
    error = std::max(error, v.error);
  }
  Boundary ring = make_ring(points_of(boundary), "simplified polygon", given.kind);
  for (Boundary::Corner& corner : ring.corners) {
    corner.vertex_number = given.corners[boundary[corner.vertex_number].first].vertex_number;
    corner.edge_number = given.corners[boundary[corner.edge_number].last].edge_number;
  }
  return {std::make_shared<const Boundary>(std::move(ring)),
          shortcuts.scaled().unscaled_bound(error)};
}

// Nothing where more than `most_vertices` would be left, or where no round gives a simple ring.
std::optional<Simplified> simplified_ring(const Boundary& ring, double tolerance, Rounding rounding,
                                          std::size_t most_vertices) {
  constexpr int most_rounds = 16;
  Shortcuts shortcuts(ring, tolerance, rounding);
  for (int round = 0; round < most_rounds; ++round) {
    NewBoundary boundary = shortcuts.boundary();
    if (rounding == Rounding::outward) {
      boundary = with_caps(shortcuts.scaled(), without_dents(shortcuts, boundary));
    }
    if (boundary.size() > most_vertices) {
      return std::nullopt;
    }
    const std::vector<Index> wrong = wrong_edges(boundary, ring.kind);
    if (wrong.empty()) {
      return as_ring(boundary, shortcuts);
    }
    shortcuts.cut_tolerance(boundary, wrong, round >= most_rounds / 2);
  }
  return std::nullopt;
}

// Do the holes lie inside the outer ring and apart from each other, as those of a polygon must?
bool are_nested(const Polygon& polygon) {
  try {
    check_nesting(rings_of(polygon), "simplified polygon");
    return true;
  } catch (const Error& error) {
    if (error.status() != Status::not_simple) {
      throw;
    }
    return false;
  }
}

}  // namespace

Simplified simplify(const std::shared_ptr<const Boundary>& ring, double tolerance,
                    Rounding rounding, std::size_t most_vertices) {
  if (tolerance > 0 && most_vertices < ring->size()) {
    if (std::optional<Simplified> near =
            simplified_ring(*ring, tolerance, rounding, most_vertices)) {
      return *std::move(near);
    }
  }
  return {ring, 0};
}

SimplifiedPolygon simplify(const std::shared_ptr<const Polygon>& polygon, double tolerance,
                           Rounding rounding, std::size_t most_outer_vertices) {
  constexpr int most_rounds = 8;
  for (int round = 0; round < most_rounds && tolerance > 0; ++round) {
    SimplifiedPolygon result;
    const auto simplified = [&](std::size_t k) {
      const std::shared_ptr<const Boundary> ring(polygon, &polygon->ring(k));
      const Simplified near =
          simplify(ring, tolerance, rounding, k == 0 ? most_outer_vertices : ring->size() - 1);
      result.error_bound = std::max(result.error_bound, near.error_bound);
      return *near.ring;
    };
    auto near = std::make_shared<Polygon>(simplified(0));
    near->holes.reserve(polygon->holes.size());
    for (std::size_t k = 1; k < polygon->ring_count(); ++k) {
      near->holes.push_back(simplified(k));
    }
    if (are_nested(*near)) {
      result.polygon = std::move(near);
      return result;
    }
    tolerance /= 4;
  }
  return {polygon, 0};
}

}  // namespace gcv
