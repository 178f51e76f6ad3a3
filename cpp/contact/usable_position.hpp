// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A translation in doubles, near an exact one, at which B does not overlap A.
#pragma once

#include "exact_point.hpp"
#include "polygon_pair.hpp"
#include "relation.hpp"

namespace gcv {

// A translation in doubles and how the polygons lie there.
struct UsablePosition {
  Point position;
  Relation relation;
};

// Of the translations in doubles within 2 ulps of the exact one in each coordinate, the nearest one
// at which B does not overlap A. The nearest of all, if there is none. The coordinates are infinite
// if they are beyond the largest double.
UsablePosition usable_position(const PolygonPair& pair, const ExactPoint& exact, Tally& tally);

}  // namespace gcv
