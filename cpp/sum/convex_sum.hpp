// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The outer face of the sum of two convex polygons, without a search.
#pragma once

#include "boundary.hpp"
#include "tally.hpp"
#include "walk.hpp"

namespace gcv {

// The edges of both polygons, in the order of their directions; parallel ones together.
// Both polygons must be convex. O(n + m) exact comparisons.
Walk merge_convex(const Boundary& a, const Boundary& b, Tally& tally);

}  // namespace gcv
