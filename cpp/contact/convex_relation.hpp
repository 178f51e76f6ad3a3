// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The relation of two convex polygons, by a line that separates them.
#pragma once

#include "polygon_pair.hpp"

namespace gcv {

// So few vertices of both that all of them are looked at.
[[nodiscard]] bool are_small_and_convex(const PlacedPair& placed);

// Exact. Two convex polygons do not overlap just when all of one lies on the line of an edge of the
// other, or to the right of it: an edge of their sum with one reflected says so. They touch where
// both meet that line. O(n m) at most; mostly O(n + m), for neighbouring edges have the same vertex
// on their left.
Relation convex_relation(const PlacedPair& placed, Tally& tally);

}  // namespace gcv
