// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A translation in doubles, near an exact one, at which a polygon overlaps nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
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

  // There are so many others, those that are fewer doubles away first: in x and in y, squared and
  // added. Nothing, where one is further than 2 ulps in a coordinate, or beyond the largest double.
  static constexpr std::size_t other_count = 24;
  [[nodiscard]] std::optional<Point> other(std::size_t k);
  // How far they are from the nearest one along an axis, at most.
  static double furthest_from(const Point& nearest) {
    return 0x1p-50 * std::max(std::abs(nearest.x), std::abs(nearest.y)) +
           std::numeric_limits<double>::min();
  }

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

// Of the translations in doubles within 2 ulps of the exact one in each coordinate, the first one
// in the order of NearbyPositions at which relations.at(translation) is no overlap. The nearest of
// all, if there is none, which relations.overlaps_around(translation, distance) may know at once.
// The coordinates are infinite if they are beyond the largest double.
template <class Relations>
UsablePosition usable_position(const ExactPoint& exact, const Point& shift, Tally& tally,
                               Relations&& relations) {
  NearbyPositions nearby(exact, shift, tally);
  const Point& nearest = nearby.nearest();
  if (!std::isfinite(nearest.x) || !std::isfinite(nearest.y)) {
    return {nearest, Relation::overlapping};
  }
  const Relation there = relations.at(nearest);
  if (there != Relation::overlapping) {
    return {nearest, there};
  }
  if (relations.overlaps_around(nearest, NearbyPositions::furthest_from(nearest))) {
    return {nearest, Relation::overlapping};
  }
  for (std::size_t k = 0; k < NearbyPositions::other_count; ++k) {
    if (const std::optional<Point> position = nearby.other(k)) {
      const Relation relation_there = relations.at(*position);
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
