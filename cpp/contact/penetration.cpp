// SPDX-License-Identifier: LGPL-3.0-or-later
#include "penetration.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "error.hpp"
#include "gap.hpp"
#include "outer_face.hpp"
#include "predicates.hpp"
#include "relation.hpp"

namespace gcv {

Point way_to(const FreePlace& place, const Point& from, Tally& tally) {
  return nearest_point(place.point, negated(from), tally);
}

double depth_of(const Operands& operands, const FreePlace& place, const Point& from, Tally& tally) {
  if (place.place) {
    return nearest_distance(place.point, from, tally);
  }
  const SumEdge line = coordinates(operands.a, operands.b, place.edge);
  return nearest_gap({line, {from, {0, 0}}, true}, tally);
}

namespace {

// Does a superset edge hold the point?
bool is_on(const PairEdge& edge, const Operands& operands, const ExactPoint& point, Tally& tally) {
  const SumEdge line = coordinates(operands.a, operands.b, edge);
  return side(line, point, tally) == 0 &&
         side(perpendicular(line, line.origin), point, tally) <= 0 &&
         side(perpendicular(line, operands.end(edge)), point, tally) >= 0;
}

}  // namespace

OwnedContact contact_in(const Operands& operands, FreePlaceSearch& search, const FreePlace& place,
                        std::span<const std::uint64_t> owners, Tally& tally) {
  using Key = std::tuple<std::uint64_t, ContactKind, Index, Index>;
  const auto& of_a = operands.a.corners;
  const auto& of_b = operands.b.corners;
  std::optional<std::pair<Key, PairEdge>> first;
  const auto consider = [&](const PairEdge& edge, const Key& key) {
    if ((!first || key < first->first) && is_on(edge, operands, place.point, tally)) {
      first = {key, edge};
    }
  };
  search.for_each_pair_near(place, [&](Index i, Index j) {
    const std::uint64_t owner = owners.empty() ? 0 : owners[operands.a.layout.ring_of(i)];
    const PairEdge translated = operands.translated(i, j);
    if (operands.b_contributes(j, translated.rank)) {
      consider(translated,
               {owner, ContactKind::edge_vertex, of_a[i].edge_number, of_b[j].vertex_number});
    }
    const PairEdge corner = operands.corner(i, j);
    if (operands.a_contributes(i, corner.rank)) {
      consider(corner,
               {owner, ContactKind::vertex_edge, of_a[i].vertex_number, of_b[j].edge_number});
    }
  });
  OwnedContact result;
  if (!first) {
    // Points in which rings touch can be in a place that no superset edge holds.
    search.for_each_pair_near(place, [&](Index i, Index j) {
      if (!owners.empty() && place.point.is_sum &&
          are_equal(operands.point({i, j}), place.point.sum, tally)) {
        const std::uint64_t owner = owners[operands.a.layout.ring_of(i)];
        result.owner = result.owner == 0 ? owner : std::min(result.owner, owner);
      }
    });
    return result;
  }
  const auto& [key, edge] = *first;
  result.edges = {edge.i, edge.j};
  Contact& contact = result.contact;
  std::tie(result.owner, contact.kind, contact.a, contact.b) = key;
  contact.normal = outward_normal(coordinates(operands.a, operands.b, edge), tally);
  contact.on_a =
      contact.kind == ContactKind::edge_vertex
          ? nearest_point(place.point, negated(operands.b.vertices[edge.j]), tally)
          : nearest_point(SumPoint{operands.a.vertices[edge.i], operands.a.position(edge.i)},
                          tally);
  contact.on_b = contact.on_a;
  return result;
}

WaysOut::WaysOut(const Polygon& a, const Polygon& reflected_b, const WantedParts& wanted,
                 std::size_t places, Task& task, Tally& tally)
    : a_(a),
      reflected_b_(reflected_b),
      operands_{a.boundary(), reflected_b.boundary(),
                merge_directions(a.boundary(), reflected_b.boundary(), tally)},
      in_range_(operands_),
      wanted_(wanted),
      places_(places),
      trial_(operands_) {
  if (!wanted.holes) {
    outer_ring_ = walked_outer_ring(task, tally);
  }
}

std::vector<RingVertex> WaysOut::walked_outer_ring(Task& task, Tally& tally) const {
  return walk_outer_face(a_.outer, reflected_b_.outer, task, tally).vertices;
}

std::uint64_t WaysOut::steps_to_spend() const {
  if (are_convex()) {
    return FreePlaceSearch::no_limit;
  }
  constexpr std::uint64_t fewest_searches = 2;  // one alone may be short
  const std::uint64_t searches = searches_;
  return searches < fewest_searches || searches >= places_
             ? 0
             : steps_ / searches * (places_ - searches) / 2;
}

const FreeBoundary* WaysOut::boundary(Task& task, std::uint64_t steps) const {
  if (const FreeBoundary* const found = found_.load(std::memory_order_acquire)) {
    return found;
  }
  if (!trial_.may_begin(std::max(steps, steps_to_spend()))) {
    return nullptr;
  }
  const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
  steps = std::max(steps, steps_to_spend());
  if (!lock.owns_lock() || boundary_ || !trial_.may_begin(steps)) {
    return found_.load(std::memory_order_acquire);
  }
  if (!trial_.run(steps, task, [&](Task& own) { find_boundary(own); })) {
    return nullptr;
  }
  found_.store(&*boundary_, std::memory_order_release);
  return &*boundary_;
}

void WaysOut::find_boundary(Task& task) const {
  Counts counts;
  ExactRegion region;
  find_sum_parts(searched(),
                 wanted_.holes ? walked_outer_ring(task, counts.predicates) : outer_ring_, wanted_,
                 task, counts, region);
  boundary_.emplace(searched(), region, slack_of(searched()), counts.predicates);
}

std::optional<FreePlace> EscapeSearch::nearest_in_range(const Point& from, Task& task) {
  const FreeBoundary* boundary = ways_.boundary(task);
  for (std::uint64_t steps = first_long_search(ways_.operands());; steps *= 4) {
    std::optional<FreePlace> place =
        boundary != nullptr ? search_.nearest(from, *boundary)
                            : search_.nearest(from, infinity, ways_.outer_ring(), task, 0, steps);
    ways_.add_search(search_.last_steps());
    if (place || search_.last_steps() <= steps) {
      return place;
    }
    boundary = ways_.boundary(task, BoundaryTrial::most_for(steps));
  }
}

FreePlace EscapeSearch::nearest(const Point& from, Task& task) {
  const std::optional<Point> start = ways_.in_range().scaled(from);
  std::optional<FreePlace> place = start
                                       ? nearest_in_range(*start, task)
                                       : FreePlaceSearch(ways_.operands(), ways_.wanted(), tally_)
                                             .nearest(from, infinity, ways_.outer_ring(), task, 0);
  if (!place) {
    throw Error(Status::internal, "no way out of an overlap");
  }
  place->point = unscaled_point(ways_.operands(), *place, from);
  return *place;
}

Escape EscapeSearch::find(const PlacedPair& placed, Task& task) {
  const Point& from = placed.b.translation;
  if (relation(placed, tally_) != Relation::overlapping) {
    const ExactPoint start = ExactPoint::of_sum({from, {0, 0}});
    return {0, {0, 0}, usable_position(placed.pair, start, std::nullopt, tally_), {}};
  }
  const FreePlace place = nearest(from, task);
  const OwnedContact found = contact_in(ways_.operands(), search_, place, {}, tally_);
  return {depth_of(ways_.operands(), place, from, tally_), way_to(place, from, tally_),
          usable_position(placed.pair, place.point, found.edges, tally_), found.contact};
}

}  // namespace gcv
