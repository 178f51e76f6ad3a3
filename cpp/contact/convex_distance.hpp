// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where two convex polygons are nearest to each other.
#pragma once

#include "contact.hpp"
#include "convex_relation.hpp"

namespace gcv {

struct NearestOfConvex {
  // These features are the nearest alone, or beside others of two edges that face each other; or
  // all are further than the distance that was asked about.
  enum class Kind { unknown, alone, facing, further };
  Kind kind;
  ContactName name;
  Index edge_of_a = 0;  // that face each other
  Index edge_of_b = 0;
};

// Of two that are apart, by a walk round both at once in doubles, from a separating edge to the
// direction along which the gap is largest. What it finds is proven exactly; unknown where it went
// astray, as in slivers. Further where the first edge tells it. O(n + m).
NearestOfConvex nearest_of_convex(const PlacedPair& placed, const ConvexPair& pair,
                                  const ConvexSeparation& separation, double distance,
                                  Tally& tally);

}  // namespace gcv
