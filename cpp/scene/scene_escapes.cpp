// SPDX-License-Identifier: LGPL-3.0-or-later
#include "scene_escapes.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "boundary_trial.hpp"
#include "directions.hpp"
#include "exact_region.hpp"
#include "free_boundary.hpp"
#include "free_place.hpp"
#include "joined_solids.hpp"
#include "operands_in_range.hpp"
#include "placed_box.hpp"

namespace gcv {

namespace {

constexpr Box everywhere{-infinity, -infinity, infinity, infinity};

// All of a scene serves places that so many times their neighbourhoods would make up.
constexpr std::uint64_t most_times = 4;

Slots joined(const Slots& p, const Slots& q) {
  Slots all;
  std::set_union(p.begin(), p.end(), q.begin(), q.end(), std::back_inserter(all));
  return all;
}

// Fewer vertices are joined as a whole: places nearby find them again.
constexpr std::size_t many_vertices = 1024;

// Of all vertices of the container and of members.
std::size_t size_of(const Scene& scene, const Slots& slots) {
  std::size_t size = scene.container() ? scene.container()->boundary.size() : 0;
  for (const BoxForest::Slot slot : slots) {
    size += scene.solid(slot).boundary.size();
  }
  return size;
}

}  // namespace

// Members near a place, joined, and the search among them.
struct SceneEscapeSearch::Neighbourhood {
  Slots slots;               // in order
  std::optional<Box> reach;  // the solids are known within that, if not everywhere
  JoinedSolids solids;
  Operands operands;
  std::optional<OperandsInRange> in_range;  // these are searched
  std::optional<FreePlaceSearch> search;
  std::optional<FreeBoundary> boundary;  // of what is free, if it is known

  Neighbourhood(const FreePositions& positions, Slots members, const std::optional<Box>& within,
                Tally& tally)
      : slots(std::move(members)),
        reach(within),
        solids(join_members(positions.scene(), positions.query(), slots, reach)),
        operands{*solids.boundary, positions.reflected(),
                 merge_directions(*solids.boundary, positions.reflected(), tally)},
        trial_(operands) {}

  [[nodiscard]] bool holds(const Slots& others, const Box& near) const {
    return std::includes(slots.begin(), slots.end(), others.begin(), others.end()) &&
           (!reach || gcv::holds(*reach, near));
  }
  // Is there a search without a focus? There is none at all where memory has run out.
  [[nodiscard]] bool is_of_use_everywhere() const { return search && !operands.focus; }
  // Nothing outside of a focus matters to a search.
  void begin(const WantedParts& wanted, const std::optional<Box>& focus, Tally& tally) {
    search.reset();
    boundary.reset();
    operands.focus = focus;
    in_range.emplace(operands);
    search.emplace(in_range->operands(), wanted, tally);
  }
  // The nearest free place, if it is within a distance. `places`: how many more may be asked for.
  std::optional<FreePlace> nearest(const Point& position, double distance, std::uint64_t places,
                                   const WantedParts& wanted, Task& task, Tally& tally) {
    const std::optional<Point> start = in_range->scaled(position);
    const double most = start ? distance * in_range->scale() : distance;
    std::optional<FreePlace> place =
        start ? nearest_scaled(*start, most, places, wanted, task, tally)
              : FreePlaceSearch(operands, wanted, tally).nearest(position, most, {}, task, 1);
    if (!place || (most < infinity && !(place->distance.hi <= most))) {
      return std::nullopt;
    }
    place->point = unscaled_point(operands, *place, position);
    return place;
  }

 private:
  std::optional<FreePlace> nearest_scaled(const Point& position, double distance,
                                          std::uint64_t places, const WantedParts& wanted,
                                          Task& task, Tally& tally) {
    if (!operands.focus) {
      find_boundary(wanted, steps_to_spend(places), task);
    }
    for (std::uint64_t steps = first_long_search(operands); !boundary; steps *= 4) {
      std::optional<FreePlace> place = search->nearest(position, distance, {}, task, 1, steps);
      steps_ += search->last_steps();
      ++searches_;
      if (search->last_steps() <= steps) {
        return place;
      }
      if (operands.focus) {
        begin(wanted, std::nullopt, tally);
      }
      find_boundary(wanted, BoundaryTrial::most_for(steps), task);
    }
    return search->nearest(position, *boundary);
  }
  // Half of those that the next searches take, as many as there were at most: they take about twice
  // as long.
  [[nodiscard]] std::uint64_t steps_to_spend(std::uint64_t places) const {
    return searches_ == 0 ? 0 : steps_ / searches_ * std::min(places, searches_) / 2;
  }
  // If it is not known, and may be found in so many steps.
  void find_boundary(const WantedParts& wanted, std::uint64_t steps, Task& task) {
    if (boundary || !trial_.may_begin(steps)) {
      return;
    }
    trial_.run(steps, task, [&](Task& own) {
      Counts counts;
      ExactRegion region;
      const Operands& searched = in_range->operands();
      find_free_boundary(searched, wanted, own, counts, region);
      boundary.emplace(searched, region, slack_of(searched), counts.predicates);
    });
  }

  BoundaryTrial trial_;
  std::uint64_t steps_ = 0;  // that searches have taken
  std::uint64_t searches_ = 0;
};

SceneEscapeSearch::SceneEscapeSearch(const FreePositions& positions, std::size_t places,
                                     Tally& tally)
    : positions_(positions), tally_(tally), places_(places) {}
SceneEscapeSearch::SceneEscapeSearch(SceneEscapeSearch&&) noexcept = default;
SceneEscapeSearch::~SceneEscapeSearch() = default;

// One that holds the solids serves again. Else it grows by a quarter of what is near at most: more
// costs what it saves. Where those of the places to come, four at most, would make up the scene, it
// is all of it: a hundred ways out of a layout take a third to a half of the time then.
SceneEscapeSearch::Neighbourhood& SceneEscapeSearch::neighbourhood(std::size_t number,
                                                                   const Box& near,
                                                                   const Point& position,
                                                                   double distance) {
  if (number == neighbourhoods_.size()) {
    neighbourhoods_.emplace_back();
  }
  Slots slots = slots_near(positions_.scene(), positions_.query(), near);
  for (std::size_t k = 0; k <= number; ++k) {
    Neighbourhood* const found = neighbourhoods_[k].get();
    if (found && found->holds(slots, near) && (k == number || found->is_of_use_everywhere())) {
      if (!found->is_of_use_everywhere()) {
        found->begin(positions_.wanted(), std::nullopt, tally_);
      }
      return *found;
    }
  }
  std::unique_ptr<Neighbourhood>& last = neighbourhoods_[number];
  const bool serves_all =
      places_ > 0 &&
      slots.size() * std::min<std::uint64_t>(places_ + 1, most_times) >= positions_.scene().size();
  Slots more = serves_all ? slots_near(positions_.scene(), positions_.query(), everywhere)
               : last     ? joined(last->slots, slots)
                          : Slots();
  const bool grows = serves_all || (last && more.size() <= slots.size() + slots.size() / 4);
  if (grows) {
    slots = std::move(more);
  }
  std::optional<Box> reach;
  if (!serves_all && distance < infinity && size_of(positions_.scene(), slots) > many_vertices) {
    reach = !grows        ? std::optional(near)
            : last->reach ? std::optional(hull_of(*last->reach, near))
                          : std::nullopt;
  }
  last = std::make_unique<Neighbourhood>(positions_, std::move(slots), reach, tally_);
  std::optional<Box> focus;
  if (!grows && distance < infinity) {
    const Point place = last->operands.relative_place(position);
    focus = widened(box_of(place, place), distance + slack_of(last->operands));
  }
  last->begin(positions_.wanted(), focus, tally_);
  return *last;
}

// Within a distance, only solids that are no further from the polygon matter. The first distance is
// about half the size of the polygon. It grows, more and more, until it holds a free position.
SceneEscape SceneEscapeSearch::find(const Point& position, Task& task) {
  places_ -= places_ > 0 ? 1 : 0;
  const ExactPoint start = ExactPoint::of_sum({position, {0, 0}});
  if (positions_.relation(position, tally_) != Relation::overlapping) {
    return {0, {0, {0, 0}, positions_.usable(start, tally_), {}}};
  }
  const Box box = moved_outwards(positions_.moving().bounds, position);
  const std::optional<Solid> container =
      positions_.query().admits_container() ? positions_.scene().container() : std::nullopt;
  double distance =
      ((box.x1 - box.x0) + (box.y1 - box.y0)) / 4 + std::numeric_limits<double>::min();
  double factor = 2;
  for (std::size_t number = 0;; ++number) {
    const Box near = widened_outwards(box, distance);
    // All that is free lies in the container. Without one, all is free far away.
    const bool is_all =
        (container && holds(near, container->boundary.bounds)) || !(distance < infinity);
    if (is_all) {
      distance = infinity;
    }
    Neighbourhood& found = neighbourhood(number, near, position, distance);
    const std::optional<FreePlace> place =
        found.nearest(position, distance, places_ + 1, positions_.wanted(), task, tally_);
    if (place) {
      const OwnedContact touched =
          contact_in(found.operands, *found.search, *place, found.solids.owners, tally_);
      return {touched.owner,
              {depth_of(found.operands, *place, position, tally_), way_to(*place, position, tally_),
               positions_.usable(place->point, tally_), touched.contact}};
    }
    if (is_all) {
      return {0, {infinity, {0, 0}, {position, Relation::overlapping}, {}}};
    }
    factor *= factor;
    distance *= factor;
  }
}

}  // namespace gcv
