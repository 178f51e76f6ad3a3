// SPDX-License-Identifier: LGPL-3.0-or-later
#include "free_positions.hpp"

#include <algorithm>
#include <cmath>

#include "directions.hpp"
#include "free_place.hpp"
#include "joined_solids.hpp"
#include "units.hpp"
#include "vector.hpp"

namespace gcv {

UsablePosition FreePositions::usable(const ExactPoint& place, Tally& tally) const {
  return usable_position(place, {0, 0}, tally, NearbySceneRelations(questions_, tally));
}

// By distances that double, up to 2^20 units in the last place.
std::optional<UsablePosition> FreePositions::free_along(const Point& position,
                                                        const std::vector<Point>& ways,
                                                        Tally& tally) const {
  const double unit = std::max(unit_in_last_place(position.x), unit_in_last_place(position.y));
  constexpr int furthest_step = 20;
  for (int step = 1; step <= furthest_step; ++step) {
    const double distance = std::ldexp(unit, step);
    for (const Point& way : ways) {
      const Point along = unit_vector(way);
      const Point other{position.x + along.x * distance, position.y + along.y * distance};
      if (std::isfinite(other.x) && std::isfinite(other.y)) {
        const Relation there = questions_.relation(other, tally);
        if (there != Relation::overlapping) {
          return UsablePosition{other, there};
        }
      }
    }
  }
  return std::nullopt;
}

// Goes into the middles of what is free around the place. Where this begins with an edge that is
// shorter than the gaps between doubles, these may lead out of it soon.
UsablePosition FreePositions::usable_along(const ExactPoint& place, const std::vector<Point>& ways,
                                           const Point& back, Tally& tally) const {
  const UsablePosition nearest = usable(place, tally);
  if (nearest.relation != Relation::overlapping || ways.empty()) {
    return nearest;
  }
  std::optional<UsablePosition> free = free_along(nearest.position, ways, tally);
  if (!free) {
    free = free_along(nearest.position, {back}, tally);
  }
  return free.value_or(nearest);
}

std::optional<UsablePosition> FreePositions::furthest(const Point& direction, Task& task,
                                                      Tally& tally) const {
  const JoinedSolids solids = join_solids(scene_, query_, reflected_, std::nullopt);
  const Operands operands{*solids.boundary, reflected_,
                          merge_directions(*solids.boundary, reflected_, tally)};
  const auto position_of = [&](FreePlaceSearch& search, const FreePlace& place) {
    return usable_along(place.point, search.ways_off(place), {-direction.x, -direction.y}, tally);
  };
  // Fits that no doubles show are passed over.
  bool are_all_shown = true;
  FreePlaceSearch search(operands, wanted_, tally);
  const auto is_shown_fit = [&](const FreePlace& fit) {
    const bool is_shown = usable(fit.point, tally).relation != Relation::overlapping;
    are_all_shown = are_all_shown && is_shown;
    return is_shown;
  };
  if (const auto place = search.furthest(direction, {is_shown_fit, false}, task, 1)) {
    const UsablePosition position = position_of(search, *place);
    if (position.relation != Relation::overlapping) {
      return position;
    }
    // So are corners, where that of what is free is narrower than the gaps between doubles.
    FreePlaceSearch near(operands, wanted_, tally);
    const auto is_shown = [&](const FreePlace& other) {
      return position_of(near, other).relation != Relation::overlapping;
    };
    const auto shown = search.furthest(direction, {is_shown, true}, task, 1);
    return shown ? position_of(near, *shown) : position;
  }
  if (are_all_shown) {
    return std::nullopt;
  }
  // Where nothing else is free, fits count.
  const auto is_any = [](const FreePlace& /*fit*/) { return true; };
  const auto place = search.furthest(direction, {is_any, false}, task, 1);
  return place ? std::optional(usable(place->point, tally)) : std::nullopt;
}

}  // namespace gcv
