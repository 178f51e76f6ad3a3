// SPDX-License-Identifier: LGPL-3.0-or-later
#include "free_positions.hpp"

#include <algorithm>
#include <limits>

#include "directions.hpp"
#include "joined_solids.hpp"
#include "placed_box.hpp"

namespace gcv {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool holds(const Box& box, const Box& other) {
  return box.x0 <= other.x0 && box.y0 <= other.y0 && box.x1 >= other.x1 && box.y1 >= other.y1;
}

}  // namespace

UsablePosition FreePositions::usable(const ExactPoint& place, Tally& tally) const {
  return usable_position(place, {0, 0}, tally,
                         [&](const Point& p) { return questions_.relation(p, tally); });
}

// Within a distance, only solids that are no further from the polygon matter. The first distance is
// about half the size of the polygon. It is doubled until it holds a free position.
SceneEscape FreePositions::escape(const Point& position, Task& task, Tally& tally) const {
  const ExactPoint start = ExactPoint::of_sum({position, {0, 0}});
  if (questions_.relation(position, tally) != Relation::overlapping) {
    return {0, {0, {0, 0}, usable(start, tally), {}}};
  }
  const Box box = moved_outwards(moving_.bounds, position);
  const std::optional<Solid> container =
      query_.admits_container() ? scene_.container() : std::nullopt;
  for (double distance = ((box.x1 - box.x0) + (box.y1 - box.y0)) / 4;; distance *= 2) {
    const Box near = widened_outwards(box, distance);
    // All that is free lies in the container. Without one, all is free far away.
    const bool is_all =
        (container && holds(near, container->boundary.bounds)) || !(distance < infinity);
    const JoinedSolids solids = join_solids_near(scene_, query_, near);
    const Operands operands{*solids.boundary, reflected_,
                            merge_directions(*solids.boundary, reflected_, tally)};
    FreePlaceSearch search(operands, wanted_, tally);
    const std::optional<FreePlace> place =
        search.nearest(position, is_all ? infinity : distance, {}, task);
    if (place && (is_all || place->distance.hi <= distance)) {
      const OwnedContact touched = contact_in(operands, search, *place, solids.owners, tally);
      return {touched.owner,
              {nearest_distance(place->point, position, tally), way_to(*place, position, tally),
               usable(place->point, tally), touched.contact}};
    }
    if (is_all) {
      return {0, {infinity, {0, 0}, {position, Relation::overlapping}, {}}};
    }
  }
}

std::optional<UsablePosition> FreePositions::furthest(const Point& direction, Task& task,
                                                      Tally& tally) const {
  const JoinedSolids solids = join_solids(scene_, query_, reflected_, std::nullopt);
  const Operands operands{*solids.boundary, reflected_,
                          merge_directions(*solids.boundary, reflected_, tally)};
  FreePlaceSearch search(operands, wanted_, tally);
  const std::optional<FreePlace> place = search.furthest(direction, task);
  return place ? std::optional(usable(place->point, tally)) : std::nullopt;
}

}  // namespace gcv
