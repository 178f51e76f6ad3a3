// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Are two polygons apart, do they touch, or do they overlap?
#pragma once

#include <optional>

#include "polygon_pair.hpp"

namespace gcv {

// An edge of A and one of B.
struct EdgePair {
  Index i;
  Index j;
};

// Exact. The boundaries are compared where they come near each other. An overlap ends the search.
//
// Let the boundaries meet, and no solid cones overlap where they do. Then the polygons touch:
// neither lies inside the other, because both are connected. Where the boundaries do not meet, one
// vertex of each outer ring tells whether one polygon lies inside the other. A may be a complement.
// Its solid is one for each ring, and each of these is asked alone.
Relation relation(const PlacedPair& placed, Tally& tally);

// The same at one translation of B after another. Edges that have shown an overlap are asked first:
// they do so again at translations nearby. So may `edges` at the first one, if there are some.
class NearbyRelations {
 public:
  NearbyRelations(const PolygonPair& pair, const Point& translation_a,
                  const std::optional<EdgePair>& edges, Tally& tally)
      : pair_(pair), translation_a_(translation_a), edges_(edges), tally_(tally) {}

  Relation at(const Point& translation);
  // Is there an overlap wherever B is moved to by at most that much along each axis, from a
  // translation at which there is one? False if edges that cross do not tell, in doubles.
  [[nodiscard]] bool overlaps_around(const Point& translation, double moved_by) const;

 private:
  PolygonPair pair_;
  Point translation_a_;
  std::optional<EdgePair> edges_;
  Tally& tally_;
};

}  // namespace gcv
