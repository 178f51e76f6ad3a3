// SPDX-License-Identifier: LGPL-3.0-or-later
#include "penetration.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "error.hpp"
#include "outer_face.hpp"
#include "predicates.hpp"
#include "relation.hpp"

namespace gcv {

Point way_to(const FreePlace& place, const Point& from, Tally& tally) {
  return nearest_point(place.point, negated(from), tally);
}

OwnedContact contact_in(const Operands& operands, FreePlaceSearch& search, const FreePlace& place,
                        std::span<const std::uint64_t> owners, Tally& tally) {
  using Key = std::tuple<std::uint64_t, ContactKind, Index, Index>;
  const auto& of_a = operands.a.corners;
  const auto& of_b = operands.b.corners;
  std::optional<std::pair<Key, PairEdge>> first;
  const auto consider = [&](const PairEdge& edge, const Key& key) {
    if ((!first || key < first->first) && search.holds(edge, place.point)) {
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
                 Task& task, Tally& tally)
    : operands_{a.boundary(), reflected_b.boundary(),
                merge_directions(a.boundary(), reflected_b.boundary(), tally)},
      wanted_(wanted) {
  if (!wanted.holes) {
    outer_ring_ = walk_outer_face(a.outer, reflected_b.outer, task, tally).vertices;
  }
}

Escape EscapeSearch::find(const PlacedPair& placed, Task& task) {
  const Point& from = placed.b.translation;
  if (relation(placed, tally_) != Relation::overlapping) {
    const ExactPoint start = ExactPoint::of_sum({from, {0, 0}});
    return {0, {0, 0}, usable_position(placed.pair, start, tally_), {}};
  }
  const std::optional<FreePlace> place =
      search_.nearest(from, infinity, ways_.outer_ring(), task, 0);
  if (!place) {
    throw Error(Status::internal, "no way out of an overlap");
  }
  return {nearest_distance(place->point, from, tally_), way_to(*place, from, tally_),
          usable_position(placed.pair, place->point, tally_),
          contact_in(ways_.operands(), search_, *place, {}, tally_).contact};
}

}  // namespace gcv
