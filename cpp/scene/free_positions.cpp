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

// Goes into the middles of what is free around the place, by distances that double, up to 2^20
// units in the last place.
UsablePosition FreePositions::usable_along(const ExactPoint& place, const std::vector<Point>& ways,
                                           Tally& tally) const {
  const UsablePosition nearest = usable(place, tally);
  const auto& [position, relation] = nearest;
  if (relation != Relation::overlapping) {
    return nearest;
  }
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
          return {other, there};
        }
      }
    }
  }
  return nearest;
}

std::optional<UsablePosition> FreePositions::furthest(const Point& direction, Task& task,
                                                      Tally& tally) const {
  const JoinedSolids solids = join_solids(scene_, query_, reflected_, std::nullopt);
  const Operands operands{*solids.boundary, reflected_,
                          merge_directions(*solids.boundary, reflected_, tally)};
  const auto furthest_of = [&](const FreePlaceSearch::IsWanted& is_fit_wanted) {
    FreePlaceSearch search(operands, wanted_, tally);
    const std::optional<FreePlace> place = search.furthest(direction, is_fit_wanted, task, 1);
    return place ? std::optional(usable_along(place->point, search.ways_off(*place), tally))
                 : std::nullopt;
  };
  // Fits that no doubles show are passed over. Where nothing else is free, they count.
  bool are_all_shown = true;
  const std::optional<UsablePosition> shown = furthest_of([&](const ExactPoint& fit) {
    const bool is_shown = usable(fit, tally).relation != Relation::overlapping;
    are_all_shown = are_all_shown && is_shown;
    return is_shown;
  });
  return shown || are_all_shown ? shown : furthest_of([](const ExactPoint&) { return true; });
}

}  // namespace gcv
