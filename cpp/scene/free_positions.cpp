// SPDX-License-Identifier: LGPL-3.0-or-later
#include "free_positions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "directions.hpp"
#include "joined_solids.hpp"
#include "placed_box.hpp"
#include "units.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

bool holds(const Box& box, const Box& other) {
  return box.x0 <= other.x0 && box.y0 <= other.y0 && box.x1 >= other.x1 && box.y1 >= other.y1;
}

}  // namespace

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

// Within a distance, only solids that are no further from the polygon matter. The first distance is
// about half the size of the polygon. It grows, more and more, until it holds a free position.
SceneEscape FreePositions::escape(const Point& position, Task& task, Tally& tally) const {
  const ExactPoint start = ExactPoint::of_sum({position, {0, 0}});
  if (questions_.relation(position, tally) != Relation::overlapping) {
    return {0, {0, {0, 0}, usable(start, tally), {}}};
  }
  const Box box = moved_outwards(moving_.bounds, position);
  const std::optional<Solid> container =
      query_.admits_container() ? scene_.container() : std::nullopt;
  double distance =
      ((box.x1 - box.x0) + (box.y1 - box.y0)) / 4 + std::numeric_limits<double>::min();
  double factor = 2;
  while (true) {
    const Box near = widened_outwards(box, distance);
    // All that is free lies in the container. Without one, all is free far away.
    const bool is_all =
        (container && holds(near, container->boundary.bounds)) || !(distance < infinity);
    if (is_all) {
      distance = infinity;
    }
    const JoinedSolids solids = join_solids_near(scene_, query_, near);
    Operands operands{*solids.boundary, reflected_,
                      merge_directions(*solids.boundary, reflected_, tally)};
    if (!is_all) {  // places that are further do not matter
      const Point place = operands.relative_place(position);
      operands.focus = widened(box_of(place, place), distance + slack_of(operands));
    }
    FreePlaceSearch search(operands, wanted_, tally);
    const std::optional<FreePlace> place = search.nearest(position, distance, {}, task, 1);
    if (place && (is_all || place->distance.hi <= distance)) {
      const OwnedContact touched = contact_in(operands, search, *place, solids.owners, tally);
      return {touched.owner,
              {depth_of(operands, *place, position, tally), way_to(*place, position, tally),
               usable(place->point, tally), touched.contact}};
    }
    if (is_all) {
      return {0, {infinity, {0, 0}, {position, Relation::overlapping}, {}}};
    }
    factor *= factor;
    distance *= factor;
  }
}

std::optional<UsablePosition> FreePositions::furthest(const Point& direction, Task& task,
                                                      Tally& tally) const {
  const JoinedSolids solids = join_solids(scene_, query_, reflected_, std::nullopt);
  const Operands operands{*solids.boundary, reflected_,
                          merge_directions(*solids.boundary, reflected_, tally)};
  FreePlaceSearch search(operands, wanted_, tally);
  const std::optional<FreePlace> place = search.furthest(direction, task, 1);
  return place ? std::optional(usable_along(place->point, search.ways_off(*place), tally))
               : std::nullopt;
}

}  // namespace gcv
