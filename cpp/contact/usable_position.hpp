// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A translation in doubles, near an exact one, at which a polygon overlaps nothing.
#pragma once

#include <cmath>
#include <optional>

#include "exact_point.hpp"
#include "polygon_pair.hpp"
#include "relation.hpp"

namespace gcv {

// A translation in doubles and how the polygons lie there.
struct UsablePosition {
  Point position;
  Relation relation;
};

// The doubles around an exact translation, which is a point + shift.
class NearbyPositions {
 public:
  NearbyPositions(const ExactPoint& exact, const Point& shift, Tally& tally)
      : exact_(exact), shift_(shift), tally_(tally), nearest_(nearest_point(exact, shift, tally)) {}

  // The double nearest to it. The coordinates are infinite if they are beyond the largest double.
  [[nodiscard]] const Point& nearest() const { return nearest_; }

  // There are so many others, from the nearest on. Nothing, where one is further than 2 ulps in a
  // coordinate, or beyond the largest double.
  static constexpr std::size_t other_count = 24;
  [[nodiscard]] std::optional<Point> other(std::size_t k);

 private:
  const ExactPoint& exact_;
  const Point& shift_;
  Tally& tally_;
  Point nearest_;
  struct Sides {
    int x;
    int y;
  };
  std::optional<Sides> sides_;  // the signs of the exact translation minus the nearest one
};

// Of the translations in doubles within 2 ulps of the exact one in each coordinate, the nearest one
// at which relation_at(translation) is no overlap. The nearest of all, if there is none. The
// coordinates are infinite if they are beyond the largest double.
template <class RelationAt>
UsablePosition usable_position(const ExactPoint& exact, const Point& shift, Tally& tally,
                               RelationAt relation_at) {
  NearbyPositions nearby(exact, shift, tally);
  const Point& nearest = nearby.nearest();
  if (!std::isfinite(nearest.x) || !std::isfinite(nearest.y)) {
    return {nearest, Relation::overlapping};
  }
  const Relation there = relation_at(nearest);
  if (there != Relation::overlapping) {
    return {nearest, there};
  }
  for (std::size_t k = 0; k < NearbyPositions::other_count; ++k) {
    if (const std::optional<Point> position = nearby.other(k)) {
      const Relation relation_there = relation_at(*position);
      if (relation_there != Relation::overlapping) {
        return {*position, relation_there};
      }
    }
  }
  return {nearest, Relation::overlapping};
}

// The same for translations of B, next to a contact of `edges`, if that is known.
UsablePosition usable_position(const PolygonPair& pair, const ExactPoint& exact,
                               const std::optional<EdgePair>& edges, Tally& tally);

}  // namespace gcv
