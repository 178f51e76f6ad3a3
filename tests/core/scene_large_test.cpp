// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Scenes of many members against the answers about two polygons, one by one. All sides are level or
// upright and all coordinates are quarters of a unit of any size: differences of positions are
// exact, and distances and times are equal where their doubles are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "contact_agreement.hpp"
#include "generators.hpp"

namespace gcv::test {
namespace {

using invariants::require;
using Id = std::uint64_t;

struct Member {
  std::size_t shape;
  Point position;
};

invariants::Polygon box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

invariants::PolygonHandle made_in(double unit, reference::Rings rings) {
  for (invariants::Polygon& ring : rings) {
    for (Point& p : ring) {
      p = {unit * p[0], unit * p[1]};
    }
  }
  return made(rings);
}

constexpr double extent = 96;

// The first ones are those of members. The container, and its solid near the members in two parts.
struct Shapes {
  std::vector<invariants::PolygonHandle> handles;
  invariants::PolygonHandle container;
  invariants::PolygonHandle around;
  invariants::PolygonHandle pillar;

  explicit Shapes(double unit)
      : container(made_in(unit, {box(0, 0, extent, extent), box(40, 40, 56, 48)})),
        around(made_in(unit, {box(-200, -200, 300, 300), box(0, 0, extent, extent)})),
        pillar(made_in(unit, {box(40, 40, 56, 48)})) {
    handles.push_back(made_in(unit, {box(0, 0, 1, 1)}));
    handles.push_back(made_in(unit, {box(0, 0, 2, 0.5)}));
    handles.push_back(made_in(unit, {box(0, 0, 3, 3), box(1, 1, 2, 2)}));
    handles.push_back(made_in(unit, {{{0, 0}, {2, 0}, {2, 0.5}, {0.5, 0.5}, {0.5, 2}, {0, 2}}}));
    handles.push_back(made_in(unit, {box(0, 0, 12, 0.25)}));
  }
};

class LargeScene {
 public:
  LargeScene(std::uint64_t seed, double unit) : random_(seed), unit_(unit), shapes_(unit) {
    gcv_scene* out = nullptr;
    require(gcv_scene_create(&out), "a scene");
    scene_.reset(out);
    require(gcv_scene_set_container(out, shapes_.container.get()), "a container");
  }

  void add(std::size_t count) {
    std::vector<const gcv_polygon*> polygons;
    Points positions;
    std::vector<Member> members;
    for (std::size_t k = 0; k < count; ++k) {
      members.push_back({below(shapes_.handles.size()), any_position()});
      polygons.push_back(shapes_.handles[members[k].shape].get());
      positions.push_back(members[k].position);
    }
    std::vector<Id> ids(count);
    require(
        gcv_scene_add(scene_.get(), polygons.data(), positions.front().data(), count, ids.data()),
        "members");
    for (std::size_t k = 0; k < count; ++k) {
      members_[ids[k]] = members[k];
    }
  }

  // A part of the members: about one in so many.
  void move(std::size_t one_in) {
    const std::vector<Id> ids = some(one_in);
    Points positions(ids.size() + 1);
    for (std::size_t k = 0; k < ids.size(); ++k) {
      members_[ids[k]].position = positions[k] = any_position();
    }
    require(gcv_scene_set(scene_.get(), ids.data(), nullptr, positions.front().data(), ids.size()),
            "moves");
  }

  void remove(std::size_t one_in) {
    const std::vector<Id> ids = some(one_in);
    require(gcv_scene_remove(scene_.get(), ids.data(), ids.size()), "ends");
    for (const Id id : ids) {
      members_.erase(id);
    }
  }

  // With the lists of the last call as earlier ones. Gives the number of pairs.
  std::size_t check_lists(double units) {
    const double distance = unit_ * units;
    gcv_options options = GCV_OPTIONS_INIT;
    options.threads = 2;
    gcv_query query = GCV_QUERY_INIT;
    const Id container = 1;
    query.ignore = &container;
    query.ignore_count = 1;
    gcv_pair_list* pairs = nullptr;
    require(gcv_scene_pairs(scene_.get(), pairs_.get(), distance, nullptr, &options, &pairs),
            "pairs");
    pairs_.reset(pairs);
    gcv_contact_list* contacts = nullptr;
    require(gcv_scene_contacts(scene_.get(), contacts_.get(), distance, 0.125, &query, &options,
                               &contacts),
            "contacts");
    contacts_.reset(contacts);
    const std::vector<gcv_pair> got = invariants::elements(gcv_pair_list_pairs, pairs);
    const std::vector<gcv_pair> wanted = pairs_within(distance);
    EXPECT_EQ(got.size(), wanted.size());
    EXPECT_TRUE(same_bytes(got, wanted)) << "other pairs within " << distance;
    EXPECT_TRUE(same_bytes(invariants::elements(gcv_contact_list_contacts, contacts),
                           contacts_within(wanted, distance)))
        << "other contacts within " << distance;
    return got.size();
  }

  void check_places(std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      const gcv_polygon* const moving = shapes_.handles[below(shapes_.handles.size())].get();
      const Point position = any_position();
      const Point motion{quarter(-200, 200), quarter(-200, 200)};
      check_place(moving, position);
      check_cast(moving, position, motion);
      check_near(moving, position, quarter(0, 12));
    }
  }

 private:
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(uniform(random_, 0, static_cast<int>(count) - 1));
  }
  double quarter(int low, int high) { return unit_ * (uniform(random_, low, high) / 4.0); }

  // Some stick out of the container.
  Point any_position() {
    constexpr int last = 4 * static_cast<int>(extent);
    const double x = quarter(-4, last);
    return {x, quarter(-4, last)};
  }

  std::vector<Id> some(std::size_t one_in) {
    std::vector<Id> ids;
    for (const auto& [id, member] : members_) {
      if (below(one_in) == 0) {
        ids.insert(ids.begin() + static_cast<std::ptrdiff_t>(below(ids.size() + 1)), id);
      }
    }
    return ids;
  }

  template <class Element>
  static bool same_bytes(const std::vector<Element>& p, const std::vector<Element>& q) {
    return p.size() == q.size() &&
           (p.empty() || std::memcmp(p.data(), q.data(), p.size() * sizeof(Element)) == 0);
  }

  static Point minus(const Point& p, const Point& q) { return {p[0] - q[0], p[1] - q[1]}; }

  // The solids that a polygon meets, with the id of the container for both of its parts.
  template <class Visit>
  void for_each_solid(Visit visit) const {
    visit(Id{1}, shapes_.around.get(), Point{0, 0});
    visit(Id{1}, shapes_.pillar.get(), Point{0, 0});
    for (const auto& [id, member] : members_) {
      visit(id, shapes_.handles[member.shape].get(), member.position);
    }
  }

  static gcv_separation separation(const gcv_polygon* a, const gcv_polygon* b, const Point& t) {
    gcv_separation result{};
    require(gcv_distance(a, b, t.data(), 1, nullptr, &result), "a distance");
    return result;
  }

  // By ids, the container's parts as one.
  using Near = std::map<std::pair<Id, Id>, int>;
  static void take(Near& near, Id a, Id b, const gcv_separation& s, double distance) {
    if (s.distance <= distance) {
      const auto [at, is_new] = near.try_emplace({a, b}, s.relation);
      at->second = std::min(at->second, static_cast<int>(s.relation));
    }
  }
  static std::vector<gcv_pair> listed(const Near& near) {
    std::vector<gcv_pair> pairs;
    for (const auto& [ids, relation] : near) {
      pairs.push_back({ids.first, ids.second, relation, 0});
    }
    return pairs;
  }

  [[nodiscard]] std::vector<gcv_pair> pairs_within(double distance) const {
    Near near;
    const double reach = 12 * unit_;  // the longest side
    for (auto a = members_.begin(); a != members_.end(); ++a) {
      const gcv_polygon* const polygon = shapes_.handles[a->second.shape].get();
      for (const gcv_polygon* part : {shapes_.around.get(), shapes_.pillar.get()}) {
        take(near, 1, a->first, separation(part, polygon, a->second.position), distance);
      }
      for (auto b = std::next(a); b != members_.end(); ++b) {
        const Point t = minus(b->second.position, a->second.position);
        if (std::abs(t[0]) <= reach + distance && std::abs(t[1]) <= reach + distance) {
          take(near, a->first, b->first,
               separation(polygon, shapes_.handles[b->second.shape].get(), t), distance);
        }
      }
    }
    return listed(near);
  }

  // Of the pairs of members.
  [[nodiscard]] std::vector<gcv_contact> contacts_within(const std::vector<gcv_pair>& pairs,
                                                         double distance) const {
    std::vector<gcv_contact> contacts;
    for (const gcv_pair& pair : pairs) {
      if (pair.a == 1) {
        continue;
      }
      const Member& a = members_.at(pair.a);
      const Member& b = members_.at(pair.b);
      gcv_contact_list* list = nullptr;
      require(gcv_contacts(shapes_.handles[a.shape].get(), shapes_.handles[b.shape].get(),
                           minus(b.position, a.position).data(), distance, 0.125, nullptr, &list),
              "contacts");
      const invariants::ContactListHandle owner(list);
      for (gcv_contact c : invariants::elements(gcv_contact_list_contacts, list)) {
        c.id_a = pair.a;
        c.id_b = pair.b;
        for (const std::size_t k : {0U, 1U}) {
          c.on_a[k] += a.position[k];
          c.on_b[k] += a.position[k];
        }
        contacts.push_back(c);
      }
    }
    const auto order = [](const gcv_contact& c) {
      return std::tuple(std::abs(c.gap), c.id_a, c.id_b, c.kind, c.a, c.b);
    };
    std::sort(contacts.begin(), contacts.end(),
              [&](const gcv_contact& c, const gcv_contact& d) { return order(c) < order(d); });
    return contacts;
  }

  void check_place(const gcv_polygon* moving, const Point& position) const {
    int relation = GCV_APART;
    double least = HUGE_VAL;
    Id nearest = 0;
    for_each_solid([&](Id id, const gcv_polygon* polygon, const Point& place) {
      const gcv_separation s = separation(polygon, moving, minus(position, place));
      relation = std::min(relation, static_cast<int>(s.relation));
      if (s.distance < least) {
        least = s.distance;
        nearest = id;
      }
    });
    std::int8_t got_relation = 77;
    gcv_separation got{};
    require(gcv_scene_relation(scene_.get(), moving, position.data(), 1, nullptr, nullptr,
                               &got_relation),
            "a relation");
    require(gcv_scene_distance(scene_.get(), moving, position.data(), 1, nullptr, nullptr, &got),
            "a distance");
    EXPECT_EQ(got_relation, relation) << text_of(position);
    EXPECT_EQ(got.relation, relation) << text_of(position);
    EXPECT_EQ(got.distance, least) << text_of(position);
    EXPECT_EQ(got.nearest.id_a, nearest) << text_of(position);
  }

  void check_cast(const gcv_polygon* moving, const Point& position, const Point& motion) const {
    double first = 1;
    Id hit = 0;
    for_each_solid([&](Id id, const gcv_polygon* polygon, const Point& place) {
      gcv_impact impact{};
      require(gcv_cast(polygon, moving, minus(position, place).data(), motion.data(), 1, nullptr,
                       &impact),
              "a cast");
      if (impact.hit == 1 && (hit == 0 || impact.time < first)) {
        first = impact.time;
        hit = id;
      }
    });
    gcv_impact got{};
    require(gcv_scene_cast(scene_.get(), moving, position.data(), motion.data(), 1, nullptr,
                           nullptr, &got),
            "a cast");
    EXPECT_EQ(got.hit, hit == 0 ? 0 : 1) << text_of(position) << ", " << text_of(motion);
    EXPECT_EQ(got.time, first) << text_of(position) << ", " << text_of(motion);
    EXPECT_EQ(got.contact.id_a, hit) << text_of(position) << ", " << text_of(motion);
  }

  void check_near(const gcv_polygon* moving, const Point& position, double distance) const {
    Near near;
    for_each_solid([&](Id id, const gcv_polygon* polygon, const Point& place) {
      take(near, id, 0, separation(polygon, moving, minus(position, place)), distance);
    });
    gcv_pair_list* list = nullptr;
    require(
        gcv_scene_near(scene_.get(), moving, position.data(), distance, nullptr, nullptr, &list),
        "what is near");
    const invariants::PairListHandle owner(list);
    EXPECT_TRUE(same_bytes(invariants::elements(gcv_pair_list_pairs, list), listed(near)))
        << text_of(position) << " within " << distance;
  }

  Random random_;
  double unit_;
  Shapes shapes_;
  invariants::SceneHandle scene_;
  std::map<Id, Member> members_;
  invariants::PairListHandle pairs_;
  invariants::ContactListHandle contacts_;
};

// The exponents of the unit.
class LargeScenes : public ::testing::TestWithParam<int> {};

TEST_P(LargeScenes, AnswerAsTheirMembersDo) {
  LargeScene scene(1, std::ldexp(1.0, GetParam()));
  std::size_t pairs = 0;
  for (const std::size_t count : {1U, 4U, 60U, 700U}) {
    scene.add(count);
    pairs += scene.check_lists(0);
    scene.check_places(10);
  }
  for (const std::size_t one_in : {40U, 5U, 1U}) {
    scene.move(one_in);
    pairs += scene.check_lists(0);
    scene.check_places(10);
  }
  pairs += scene.check_lists(0.75);
  for (const std::size_t one_in : {30U, 3U, 2U, 2U}) {
    scene.remove(one_in);
    pairs += scene.check_lists(0.75);
    scene.add(30);
    pairs += scene.check_lists(0.75);
    scene.check_places(10);
  }
  EXPECT_GT(pairs, 1000U);
}

INSTANTIATE_TEST_SUITE_P(Units, LargeScenes, ::testing::Values(0, -1000, 1000));

}  // namespace
}  // namespace gcv::test
