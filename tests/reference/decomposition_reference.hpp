// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The inside of regions by unions of convex sums, to compare the cover walk with. By CGAL (GPL: in
// tests only): its decomposition into convex polygons, its sums of them, its Boolean operations. It
// shares nothing with the library, nor with the other references. As all that is closed and
// regularised, nothing is known of segments and points.
#pragma once

#include <string>
#include <vector>

#include "point.hpp"

namespace gcv::reference {

// The rings of a polygon, the outer one first, each either way round.
using Rings = std::vector<PointVector>;

// The rings of all polygons of a region, sorted as text. Outer rings counter-clockwise, holes
// clockwise, from their lexicographically smallest vertex, without collinear vertices, none with a
// vertex twice. Each vertex is "p/q r/s".
using RegionRings = std::vector<std::vector<std::string>>;

// Of the sum a + b + shift.
RegionRings rings_of_sum(const Rings& a, const Rings& b, const Point& shift);

// Of the positions of the reference point, fixed to `moving`, with `moving` inside the container.
RegionRings rings_of_inner_fit(const Rings& container, const Rings& moving, const Point& reference);

}  // namespace gcv::reference
