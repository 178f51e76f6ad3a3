// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Rings and polygons with fewer vertices, within a tolerance of the given ones.
#pragma once

#include <cstddef>
#include <memory>

#include "boundary.hpp"
#include "polygon.hpp"
#include "rounding_direction.hpp"

namespace gcv {

struct Simplified {
  std::shared_ptr<const Boundary> ring;
  // No point of either boundary is further than this from the other boundary.
  double error_bound = 0;
};

// A simple ring within `tolerance` of the given one.
//
// Nearest: its vertices are some of the given ones. Outward: its solid contains the given one, and
// it has new vertices where edges are lengthened until they meet.
//
// Keeps the caller's numbers of vertices and edges. A vertex or edge that replaces several has the
// number of the first of them.
//
// Returns the given ring if more than `most_vertices` would be left. O(n log n), except for shapes
// most of whose boundary is within the tolerance of other parts of it.
Simplified simplify(const std::shared_ptr<const Boundary>& ring, double tolerance,
                    Rounding rounding, std::size_t most_vertices);

struct SimplifiedPolygon {
  std::shared_ptr<const Polygon> polygon;
  double error_bound = 0;  // of all rings
};

// The same for all rings of a polygon. Keeps the given outer ring if more vertices would be left of
// it. Cuts the tolerance if rings would cross. Returns the given polygon if that does not help.
SimplifiedPolygon simplify(const std::shared_ptr<const Polygon>& polygon, double tolerance,
                           Rounding rounding, std::size_t most_outer_vertices);

}  // namespace gcv
