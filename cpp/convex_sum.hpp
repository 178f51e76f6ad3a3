// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The outer face of the sum of two convex polygons: no search, no arithmetic.
#pragma once

#include "contributing_vertices.hpp"
#include "outer_face.hpp"

namespace gcv {

// The edges of both polygons, in the order of their directions; parallel ones together.
// Both polygons must be convex. O(n + m).
Walk merge_convex(const Operands& operands);

}  // namespace gcv
