// SPDX-License-Identifier: LGPL-3.0-or-later
#include "scene_agreement.hpp"

#include <algorithm>
#include <cmath>

#include "correct_rounding.hpp"

namespace gcv::test {

namespace {

using invariants::exact;
using reference::Exact;
using reference::Rational;

ExactBox box_of(const reference::Solid& solid) {
  ExactBox box{solid.corners.front().place, solid.corners.front().place};
  for (const reference::Corner& corner : solid.corners) {
    const Exact& p = corner.place;
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

// The nearest one: of several, the first.
struct NearestSolid {
  std::uint64_t id = 0;
  reference::Separation separation;
};

std::optional<NearestSolid> nearest_of(const PlacedSolids& solids, const PlacedSolid& moving,
                                       SceneCounts& counts) {
  std::optional<NearestSolid> nearest;
  for (const PlacedSolid* solid : solids) {
    if (nearest && squared_box_gap(*solid, moving) > nearest->separation.squared_distance) {
      continue;
    }
    const reference::Separation separation = reference::separation(solid->solid, moving.solid);
    if (nearest && separation.squared_distance == nearest->separation.squared_distance) {
      ++counts.ties;
    }
    if (!nearest || separation.squared_distance < nearest->separation.squared_distance) {
      nearest = {solid->id, separation};
    }
  }
  return nearest;
}

std::string distance_difference(const gcv_separation& got, int relation,
                                const std::optional<NearestSolid>& wanted) {
  const std::string wrong = relation_difference(got.relation, relation);
  if (!wrong.empty()) {
    return wrong;
  }
  if (got.reserved != 0) {
    return "reserved is not 0";
  }
  if (!wanted) {
    return std::isinf(got.distance) && got.distance > 0
               ? contact_difference(got.nearest, nullptr)
               : "distance " + text_of(got.distance) + ", not infinite";
  }
  const reference::Separation& separation = wanted->separation;
  if (!invariants::is_nearest_root(got.distance, separation.squared_distance)) {
    return "distance " + text_of(got.distance) + " is not the nearest to the root of " +
           separation.squared_distance.str();
  }
  return contact_difference(got.nearest, separation.nearest ? &*separation.nearest : nullptr,
                            {wanted->id, 0});
}

// Nothing if they are further from each other than the root of the square.
std::optional<int> relation_within(const PlacedSolid& a, const PlacedSolid& b,
                                   const Rational& squared_distance) {
  if (squared_box_gap(a, b) > squared_distance) {
    return {};
  }
  const reference::Separation separation = reference::separation(a.solid, b.solid);
  return separation.squared_distance <= squared_distance ? std::optional(separation.relation)
                                                         : std::nullopt;
}

std::string text_of(const gcv_pair& pair) {
  return std::to_string(pair.a) + ", " + std::to_string(pair.b) + ": " +
         std::to_string(pair.relation);
}

std::string pairs_difference(const std::vector<gcv_pair>& got,
                             const std::vector<gcv_pair>& wanted) {
  for (std::size_t k = 0; k < got.size() || k < wanted.size(); ++k) {
    if (k >= got.size()) {
      return "no pair " + text_of(wanted[k]);
    }
    if (k >= wanted.size()) {
      return "one pair too many: " + text_of(got[k]);
    }
    if (text_of(got[k]) != text_of(wanted[k]) || got[k].reserved != 0) {
      return "the pair " + text_of(got[k]) + ", not " + text_of(wanted[k]);
    }
  }
  return "";
}

gcv_pair pair_of(std::uint64_t a, std::uint64_t b, int relation) { return {a, b, relation, 0}; }

}  // namespace

PlacedSolid placed_member(std::uint64_t id, std::uint32_t layers, const reference::Solid& polygon,
                          const Point& position) {
  const reference::Solid solid = moved(polygon, exact(position));
  return {id, layers, solid, box_of(solid)};
}

PlacedSolid placed_container(const reference::Solid& polygon) {
  return {1, UINT32_MAX, complement(polygon), {}};
}

PlacedSolids asked_solids(const CheckedScene& scene, const gcv_query* query) {
  PlacedSolids solids;
  for (const PlacedSolid& solid : scene.solids) {
    const auto is_ignored = [&] {
      const std::uint64_t* const end = query->ignore + query->ignore_count;
      return std::find(query->ignore, end, solid.id) != end;
    };
    if (query == nullptr ? solid.layers != 0
                         : (solid.layers & query->layers) != 0 && !is_ignored()) {
      solids.push_back(&solid);
    }
  }
  return solids;
}

PlacedSolid moved_there(const MovingPolygon& moving, const Exact& t) {
  const reference::Solid solid = moved(moving.solid, t);
  return {0, 0, solid, box_of(solid)};
}

Rational squared_box_gap(const PlacedSolid& a, const PlacedSolid& b) {
  if (!a.box || !b.box) {
    return 0;
  }
  const auto gap = [](const Rational& low, const Rational& high, const Rational& other_low,
                      const Rational& other_high) {
    return std::max<Rational>({0, other_low - high, low - other_high});
  };
  const Rational x = gap(a.box->low.x, a.box->high.x, b.box->low.x, b.box->high.x);
  const Rational y = gap(a.box->low.y, a.box->high.y, b.box->low.y, b.box->high.y);
  return x * x + y * y;
}

int relation_of(const PlacedSolid& a, const PlacedSolid& b) {
  return squared_box_gap(a, b) > 0 ? reference::apart : reference::relation(a.solid, b.solid);
}

int relation_to_all(const PlacedSolids& solids, const PlacedSolid& b) {
  int relation = reference::apart;
  for (const PlacedSolid* solid : solids) {
    relation = std::min(relation, relation_of(*solid, b));
  }
  return relation;
}

Messages check_scene_relations(const CheckedScene& scene, const MovingPolygon& moving,
                               const Points& positions, const gcv_query* query,
                               SceneCounts& counts) {
  const PlacedSolids solids = asked_solids(scene, query);
  std::vector<std::int8_t> got(positions.size());
  invariants::require(gcv_scene_relation(scene.handle, moving.handle, positions.front().data(),
                                         positions.size(), query, nullptr, got.data()),
                      "relations");
  Messages messages;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const int wanted = relation_to_all(solids, moved_there(moving, exact(positions[k])));
    std::size_t& count = wanted == reference::apart      ? counts.contacts.apart
                         : wanted == reference::touching ? counts.contacts.touching
                                                         : counts.contacts.overlapping;
    ++count;
    report(messages, positions[k], relation_difference(got[k], wanted));
  }
  return messages;
}

Messages check_scene_distances(const CheckedScene& scene, const MovingPolygon& moving,
                               const Points& positions, const gcv_query* query,
                               SceneCounts& counts) {
  const PlacedSolids solids = asked_solids(scene, query);
  Messages messages;
  for (const Point& position : positions) {
    const PlacedSolid there = moved_there(moving, exact(position));
    const std::optional<NearestSolid> wanted = nearest_of(solids, there, counts);
    gcv_separation got;
    const gcv_status status =
        gcv_scene_distance(scene.handle, moving.handle, position.data(), 1, query, nullptr, &got);
    counts.infinite += wanted ? 0 : 1;
    if (wanted && wanted->separation.nearest && is_out_of_range(*wanted->separation.nearest)) {
      ++counts.contacts.out_of_range;
      report(messages, position, status == GCV_ERR_RANGE ? "" : "a distance, not GCV_ERR_RANGE");
      continue;
    }
    if (status == GCV_ERR_RANGE) {
      report(messages, position, "a distance out of range");
      continue;
    }
    invariants::require(status, "a distance");
    report(messages, position, distance_difference(got, relation_to_all(solids, there), wanted));
  }
  return messages;
}

Messages check_scene_near(const CheckedScene& scene, const MovingPolygon& moving,
                          const Point& position, double distance, const gcv_query* query,
                          SceneCounts& counts) {
  const PlacedSolid there = moved_there(moving, exact(position));
  const Rational squared_distance = Rational(distance) * Rational(distance);
  std::vector<gcv_pair> wanted;
  for (const PlacedSolid* solid : asked_solids(scene, query)) {
    if (const auto relation = relation_within(*solid, there, squared_distance)) {
      wanted.push_back(pair_of(solid->id, 0, *relation));
    }
  }
  counts.pairs += wanted.size();
  gcv_pair_list* list = nullptr;
  invariants::require(
      gcv_scene_near(scene.handle, moving.handle, position.data(), distance, query, nullptr, &list),
      "what is near");
  const invariants::PairListHandle owner(list);
  const std::string difference =
      pairs_difference(invariants::elements(gcv_pair_list_pairs, owner.get()), wanted);
  Messages messages;
  report(messages, position,
         difference.empty() ? "" : "within " + test::text_of(distance) + ": " + difference);
  return messages;
}

Messages check_scene_pairs(const CheckedScene& scene, double distance, const gcv_query* query,
                           SceneCounts& counts) {
  const PlacedSolids solids = asked_solids(scene, query);
  const Rational squared_distance = Rational(distance) * Rational(distance);
  std::vector<gcv_pair> wanted;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    for (std::size_t j = i + 1; j < solids.size(); ++j) {
      if (const auto relation = relation_within(*solids[i], *solids[j], squared_distance)) {
        wanted.push_back(pair_of(solids[i]->id, solids[j]->id, *relation));
      }
    }
  }
  counts.pairs += wanted.size();
  gcv_pair_list* list = nullptr;
  invariants::require(gcv_scene_pairs(scene.handle, nullptr, distance, query, nullptr, &list),
                      "pairs");
  const invariants::PairListHandle owner(list);
  const std::string difference =
      pairs_difference(invariants::elements(gcv_pair_list_pairs, owner.get()), wanted);
  return difference.empty()
             ? Messages{}
             : Messages{"pairs within " + test::text_of(distance) + ": " + difference};
}

Messages check_scene_contacts(const CheckedScene& scene, double distance, double slope,
                              const gcv_query* query, SceneCounts& counts) {
  const PlacedSolids solids = asked_solids(scene, query);
  std::vector<ListedContact> wanted;
  bool out_of_range = false;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    for (std::size_t j = i + 1; j < solids.size(); ++j) {
      const PlacedSolid& a = *solids[i];
      const PlacedSolid& b = *solids[j];
      if (squared_box_gap(a, b) > Rational(distance) * Rational(distance)) {
        continue;
      }
      for (const reference::Contact& c :
           contacts(a.solid, b.solid, Rational(distance), Rational(slope))) {
        wanted.push_back({{a.id, b.id}, c});
        out_of_range = out_of_range || is_out_of_range(c);
      }
    }
  }
  const std::string place =
      "contacts within " + test::text_of(distance) + ", slope " + test::text_of(slope) + ": ";
  gcv_contact_list* list = nullptr;
  const gcv_status status =
      gcv_scene_contacts(scene.handle, nullptr, distance, slope, query, nullptr, &list);
  const invariants::ContactListHandle owner(list);
  if (out_of_range) {
    ++counts.contacts.out_of_range;
    return status == GCV_ERR_RANGE ? Messages{} : Messages{place + "not GCV_ERR_RANGE"};
  }
  if (status == GCV_ERR_RANGE) {
    return {place + "out of range"};
  }
  invariants::require(status, "contacts");
  counts.contacts.listed += wanted.size();
  const std::string difference =
      list_difference(invariants::elements(gcv_contact_list_contacts, owner.get()), wanted);
  return difference.empty() ? Messages{} : Messages{place + difference};
}

}  // namespace gcv::test
