// SPDX-License-Identifier: LGPL-3.0-or-later
#include "free_positions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "directions.hpp"
#include "joined_solids.hpp"
#include "placed_box.hpp"
#include "units.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Holds the positions at which a box lies in another one.
Box positions_in(const Box& container, const Box& moving) {
  return {sum_below(container.x0, -moving.x0), sum_below(container.y0, -moving.y0),
          sum_above(container.x1, -moving.x1), sum_above(container.y1, -moving.y1)};
}

// Parts of a box of positions, from the furthest one in a direction on.
class Slabs {
 public:
  Slabs(const Box& positions, const Box& moving, const Point& direction)
      : positions_(positions),
        by_x_(std::abs(direction.x) >= std::abs(direction.y)),
        is_upwards_((by_x_ ? direction.x : direction.y) > 0) {
    const double length = by_x_ ? positions.x1 - positions.x0 : positions.y1 - positions.y0;
    const double size = (moving.x1 - moving.x0) + (moving.y1 - moving.y0);
    const double count = length / size * slabs_a_size;
    if (positions.x0 <= positions.x1 && positions.y0 <= positions.y1) {
      count_ = count >= 2 ? static_cast<std::size_t>(std::min(count, most)) : 1;
    }
  }

  // 0 if the box is empty.
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] Box box(std::size_t k) const {
    Box box = positions_;
    double& low = by_x_ ? box.x0 : box.y0;
    double& high = by_x_ ? box.x1 : box.y1;
    const double from = low;
    const double step = (high - low) / static_cast<double>(count_);
    const auto border = [&](std::size_t number) {
      return number == 0        ? from
             : number == count_ ? high
                                : from + static_cast<double>(number) * step;
    };
    const std::size_t number = is_upwards_ ? count_ - 1 - k : k;
    const double end = border(number + 1);
    low = border(number);
    high = end;
    return box;
  }

 private:
  static constexpr double slabs_a_size = 0.125;
  static constexpr double most = 1000;

  Box positions_;
  bool by_x_;
  bool is_upwards_;
  std::size_t count_ = 0;
};

// Are there doubles for solids around windows in the box?
bool has_room_around(const Box& box) {
  const double size = std::max({-box.x0, -box.y0, box.x1, box.y1});
  return std::isfinite(16 * size);
}

// Is nothing in the box as far in a direction as the point?
bool is_beyond(const ExactPoint& point, const Point& direction, const Box& box, Tally& tally) {
  const Point corner{direction.x < 0 ? box.x0 : box.x1, direction.y < 0 ? box.y0 : box.y1};
  return compare_along(direction, point, ExactPoint::of_sum({corner, {0, 0}}), tally) > 0;
}

bool holds(const Box& box, const Box& other) {
  return box.x0 <= other.x0 && box.y0 <= other.y0 && box.x1 >= other.x1 && box.y1 >= other.y1;
}

}  // namespace

UsablePosition FreePositions::usable(const ExactPoint& place, Tally& tally) const {
  return usable_position(place, {0, 0}, tally,
                         [&](const Point& p) { return questions_.relation(p, tally); });
}

// Goes into the middles of what is free around the place, by distances that double, up to 2^20
// units in the last place.
UsablePosition FreePositions::usable_along(const Furthest& furthest, Tally& tally) const {
  const UsablePosition nearest = usable(furthest.place, tally);
  const auto& [position, relation] = nearest;
  if (relation != Relation::overlapping) {
    return nearest;
  }
  const double unit = std::max(unit_in_last_place(position.x), unit_in_last_place(position.y));
  constexpr int furthest_step = 20;
  for (int step = 1; step <= furthest_step; ++step) {
    const double distance = std::ldexp(unit, step);
    for (const Point& way : furthest.ways) {
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
    const Operands operands{*solids.boundary, reflected_,
                            merge_directions(*solids.boundary, reflected_, tally)};
    FreePlaceSearch search(operands, wanted_, tally);
    const std::optional<FreePlace> place = search.nearest(position, distance, {}, task, 1);
    if (place && (is_all || place->distance.hi <= distance)) {
      const OwnedContact touched = contact_in(operands, search, *place, solids.owners, tally);
      return {touched.owner,
              {nearest_distance(place->point, position, tally), way_to(*place, position, tally),
               usable(place->point, tally), touched.contact}};
    }
    if (is_all) {
      return {0, {infinity, {0, 0}, {position, Relation::overlapping}, {}}};
    }
    factor *= factor;
    distance *= factor;
  }
}

std::optional<FreePositions::Furthest> FreePositions::furthest_in(const std::optional<Box>& window,
                                                                  const Point& direction,
                                                                  Task& task, Tally& tally) const {
  const JoinedSolids solids = join_solids(scene_, query_, reflected_, window);
  Operands operands{*solids.boundary, reflected_,
                    merge_directions(*solids.boundary, reflected_, tally)};
  if (solids.border) {
    operands.focus = solids.border->focus(operands);
  }
  FreePlaceSearch search(operands, wanted_, tally);
  const std::optional<FreePlace> place = search.furthest(direction, task, 1);
  return place ? std::optional(Furthest{place->point, search.ways_off(*place)}) : std::nullopt;
}

// Goes through slabs of the positions, across the axis that the direction is closest to, from the
// furthest one on. Each is searched by itself: there are few members near one, so that grids over
// them are fine.
std::optional<UsablePosition> FreePositions::furthest(const Point& direction, Task& task,
                                                      Tally& tally) const {
  const Box& container = scene_.container()->boundary.bounds;
  std::optional<Furthest> best;
  if (!has_room_around(container)) {
    best = furthest_in(std::nullopt, direction, task, tally);
    return best ? std::optional(usable_along(*best, tally)) : std::nullopt;
  }
  const Slabs slabs(positions_in(container, moving_.bounds), moving_.bounds, direction);
  for (std::size_t k = 0; k < slabs.count(); ++k) {
    const Box slab = slabs.box(k);
    if (best && is_beyond(best->place, direction, slab, tally)) {
      break;
    }
    std::optional<Furthest> found = furthest_in(slab, direction, task, tally);
    if (!found) {
      continue;
    }
    const int order = best ? compare_along(direction, found->place, best->place, tally) : 1;
    if (order > 0 ||
        (order == 0 && compare_lexicographically(found->place, best->place, tally) < 0)) {
      best = std::move(found);
    }
  }
  return best ? std::optional(usable_along(*best, tally)) : std::nullopt;
}

}  // namespace gcv
