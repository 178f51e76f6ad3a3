// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A translation in doubles, near an exact one, at which B does not overlap A.
#pragma once

#include "polygon_pair.hpp"
#include "relation.hpp"

namespace gcv {

// An exact translation: a sum of two points, or the crossing of the lines of two edges.
struct ExactTranslation {
  bool is_sum;
  SumPoint sum;
  SumEdge s;
  SumEdge t;

  static ExactTranslation of_sum(const SumPoint& sum) { return {true, sum, {}, {}}; }
  static ExactTranslation of_crossing(const SumEdge& s, const SumEdge& t) {
    return {false, {}, s, t};
  }
};

// A translation in doubles and how the polygons lie there.
struct UsablePosition {
  Point position;
  Relation relation;
};

// Of the translations in doubles within 2 ulps of the exact one in each coordinate, the nearest one
// at which B does not overlap A. The nearest of all, if there is none. The coordinates are infinite
// if they are beyond the largest double.
UsablePosition usable_position(const PolygonPair& pair, const ExactTranslation& exact,
                               Tally& tally);

}  // namespace gcv
