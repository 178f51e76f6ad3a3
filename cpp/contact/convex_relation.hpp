// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The relation of two convex polygons, by a line that separates them.
#pragma once

#include "convex_pair.hpp"

namespace gcv {

struct ConvexSeparation {
  Relation relation;
  // Unless they overlap: all of the other polygon lies on the line of this edge of that one, or to
  // the right of it.
  const SeenPolygon* polygon;
  Index edge;
};

// Exact. Two convex polygons do not overlap just when all of one lies on the line of an edge of the
// other, or to the right of it: an edge of their sum with one reflected says so. They touch where
// both meet that line. O(n m) at most; mostly O(n + m), for neighbouring edges have the same vertex
// on their left.
ConvexSeparation convex_separation(const ConvexPair& pair, Tally& tally);

}  // namespace gcv
