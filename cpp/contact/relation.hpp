// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Are two polygons apart, do they touch, or do they overlap?
#pragma once

#include "polygon_pair.hpp"

namespace gcv {

// Exact. The boundaries are compared where they come near each other. An overlap ends the search.
//
// Let the boundaries meet, and no solid cones overlap where they do. Then the polygons touch:
// neither lies inside the other, because both are connected. Where the boundaries do not meet, one
// vertex of each outer ring tells whether one polygon lies inside the other. A may be a complement.
// Its solid is one for each ring, and each of these is asked alone.
Relation relation(const PlacedPair& placed, Tally& tally);

}  // namespace gcv
