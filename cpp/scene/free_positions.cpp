// SPDX-License-Identifier: LGPL-3.0-or-later
#include "free_positions.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "directions.hpp"
#include "free_place.hpp"
#include "joined_solids.hpp"
#include "operands_in_range.hpp"
#include "placed_box.hpp"
#include "units.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

// Holds the part of a box that is no further in a direction, a unit vector, than a point of it that
// is rounded to doubles.
Box no_further_than(const Point& p, const Point& direction, const Box& box) {
  // Of a coordinate and a difference.
  const double error = 0x1p-40 * size_of(box) + 0x1p-1000;
  // The bound of a coordinate, with the least of the other one. Far away, or not a number, where
  // there is none.
  const auto bound = [&](double at, double along, double other, double across, double from,
                         double to) {
    const double most = std::max(across * (other - from), across * (other - to));
    const double change = (most + std::abs(across) * error + 0x1p-1000) / along;
    const double margin = error + 0x1p-40 * std::abs(change);
    return along > 0 ? at + change + margin : at + change - margin;
  };
  const double x = bound(p.x, direction.x, p.y, direction.y, box.y0, box.y1);
  const double y = bound(p.y, direction.y, p.x, direction.x, box.x0, box.x1);
  Box part = box;
  if (direction.x > 0) {
    part.x1 = x < part.x1 ? x : part.x1;
  } else if (direction.x < 0) {
    part.x0 = x > part.x0 ? x : part.x0;
  }
  if (direction.y > 0) {
    part.y1 = y < part.y1 ? y : part.y1;
  } else if (direction.y < 0) {
    part.y0 = y > part.y0 ? y : part.y0;
  }
  return part;
}

// Of points, the furthest in a direction, the lexicographically smallest of several.
class FurthestOfAll {
 public:
  FurthestOfAll(const Point& direction, Tally& tally) : direction_(direction), tally_(tally) {}

  void take(const ExactPoint& point) {
    if (!found_ || is_before(point, *found_)) {
      found_ = point;
    }
  }
  [[nodiscard]] const std::optional<ExactPoint>& found() const { return found_; }

 private:
  [[nodiscard]] bool is_before(const ExactPoint& p, const ExactPoint& q) const {
    const int order = compare_along(direction_, p, q, tally_);
    return order > 0 || (order == 0 && compare_lexicographically(p, q, tally_) < 0);
  }

  const Point direction_;
  Tally& tally_;
  std::optional<ExactPoint> found_;
};

}  // namespace

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

std::optional<UsablePosition> FreePositions::furthest_among(const Operands& operands,
                                                            const Point& direction,
                                                            const std::optional<ExactPoint>& first,
                                                            Task& task, Tally& tally) const {
  const OperandsInRange in_range(operands);
  const Operands& searched = first ? operands : in_range.operands();
  FreePlaceSearch search(searched, wanted_, tally);
  FurthestOfAll furthest_of_all(direction, tally);
  const auto is_shown = [&](const FreePlace& fit) {
    const ExactPoint point = unscaled_point(operands, fit);
    const bool result = usable(point, tally).relation != Relation::overlapping;
    if (!result) {
      furthest_of_all.take(point);
    }
    return result;
  };
  const auto place = search.furthest(direction, {is_shown, false}, task, 1, first);
  if (place) {
    furthest_of_all.take(unscaled_point(operands, *place));
  }
  // Out of range, a search from the first place on is slower than one without.
  if (query_.ignored.empty() && !(furthest_of_all.found() && in_range.are_scaled())) {
    scene_.known_bests().keep(question(direction), {furthest_of_all.found()});
  }
  const auto position_of = [&](FreePlaceSearch& among, const FreePlace& found) {
    return usable_along(unscaled_point(operands, found), among.ways_off(found),
                        {-direction.x, -direction.y}, tally);
  };
  if (place) {
    const UsablePosition position = position_of(search, *place);
    if (position.relation != Relation::overlapping) {
      return position;
    }
    // So are corners, where that of what is free is narrower than the gaps between doubles.
    FreePlaceSearch near(searched, wanted_, tally);
    const auto is_shown_near = [&](const FreePlace& other) {
      return position_of(near, other).relation != Relation::overlapping;
    };
    const auto shown = search.furthest(direction, {is_shown_near, true}, task, 1, first);
    return shown ? position_of(near, *shown) : position;
  }
  if (!furthest_of_all.found()) {
    return std::nullopt;
  }
  // Where nothing else is free, fits count.
  const auto is_any = [](const FreePlace& /*fit*/) { return true; };
  const auto fit = search.furthest(direction, {is_any, false}, task, 1, first);
  return fit ? std::optional(usable(unscaled_point(operands, *fit), tally)) : std::nullopt;
}

std::optional<UsablePosition> FreePositions::furthest_from(const ExactPoint& first,
                                                           const Point& direction, Task& task,
                                                           Tally& tally) const {
  const Box positions =
      no_further_than(nearest_point(first, {0, 0}, tally), unit_vector(direction),
                      sum_outwards(scene_.container()->boundary.bounds, reflected_.bounds));
  // Edges that begin before that would pass free places where what covers these is left out. With
  // this margin, most do not: layouts take 0.6 to 1 of the time.
  const Box& extents = reflected_.bounds;
  const double margin = ((extents.x1 - extents.x0) + (extents.y1 - extents.y0)) / 4;
  const std::shared_ptr<const JoinedSolids> kept = scene_.kept_solids().find(query_.layers);
  const std::shared_ptr<const Boundary> solids =
      kept ? kept->boundary
           : join_solids_near(scene_, query_, reflected_, widened_outwards(positions, margin))
                 .boundary;
  Operands operands{*solids, reflected_, merge_directions(*solids, reflected_, tally)};
  operands.focus = widened(operands.relative_box(positions), slack_of(operands));
  return furthest_among(operands, direction, first, task, tally);
}

std::optional<UsablePosition> FreePositions::furthest(const Point& direction, Task& task,
                                                      Tally& tally) const {
  const auto known =
      query_.ignored.empty() ? scene_.known_bests().find(question(direction)) : std::nullopt;
  if (known) {
    return known->place ? furthest_from(*known->place, direction, task, tally) : std::nullopt;
  }
  const std::shared_ptr<const JoinedSolids> solids = join_all_solids(scene_, query_, reflected_);
  const Operands operands{*solids->boundary, reflected_,
                          merge_directions(*solids->boundary, reflected_, tally)};
  return furthest_among(operands, direction, std::nullopt, task, tally);
}

}  // namespace gcv
