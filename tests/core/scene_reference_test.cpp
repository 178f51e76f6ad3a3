// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Scenes against the definitions, on random members full of ties. The reference looks at all pairs
// of edges and vertices of all members whose boxes come near, in fractions.
//   scene_reference_test [--cases=N] [--seed=N]: scenes of each family.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "case_options.hpp"
#include "contact_scenes.hpp"
#include "scene_agreement.hpp"
#include "scene_texts.hpp"

namespace gcv::test {
namespace {

CaseOptions chosen{12};

using invariants::require;

// Both sides of a scene, and the query to ask it.
struct SceneOfCase {
  MemberScene description;
  std::vector<invariants::PolygonHandle> shapes;
  std::vector<reference::Solid> solids;
  invariants::SceneHandle scene;
  std::vector<std::uint64_t> ids;
  CheckedScene checked;
  std::vector<std::uint64_t> ignored;
  gcv_query query GCV_QUERY_INIT;

  // Throws invariants::Failure where a polygon is not valid.
  SceneOfCase(MemberScene case_of_family, Random& random) : description(std::move(case_of_family)) {
    for (const auto& rings : description.shapes) {
      shapes.push_back(made(rings));
      solids.push_back(reference::make_solid(rings));
    }
    gcv_scene* out = nullptr;
    require(gcv_scene_create(&out), "a scene");
    scene.reset(out);
    add_members(random);
    if (description.container) {
      const std::size_t shape = *description.container;
      require(gcv_scene_set_container(scene.get(), shapes[shape].get()), "a container");
      checked.solids.push_back(placed_container(solids[shape]));
    }
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const MemberScene::Member& member = description.members[k];
      checked.solids.push_back(
          placed_member(ids[k], member.layers, solids[member.shape], member.position));
    }
    checked.handle = scene.get();
    ask_some(random);
  }

  // NULL for some that are about all members.
  [[nodiscard]] const gcv_query* asked() const {
    const bool is_about_all = query.layers == UINT32_MAX && query.ignore_count == 0;
    return is_about_all && ids.size() % 2 == 0 ? nullptr : &query;
  }

  [[nodiscard]] MovingPolygon moving() const {
    return {shapes[description.moving].get(), solids[description.moving]};
  }

 private:
  // One by one: some begin elsewhere, as another polygon, and some are there for a while only.
  void add_members(Random& random) {
    for (const MemberScene::Member& member : description.members) {
      const gcv_polygon* const polygon = shapes[member.shape].get();
      const gcv_polygon* const other = shapes.front().get();
      const Point elsewhere{1, -1};
      std::uint64_t id = 0;
      if (uniform(random, 0, 3) == 0) {
        require(gcv_scene_add(scene.get(), &other, member.position.data(), 1, &id), "a member");
        require(gcv_scene_remove(scene.get(), &id, 1), "its end");
      }
      if (uniform(random, 0, 2) == 0) {
        require(gcv_scene_add(scene.get(), &other, elsewhere.data(), 1, &id), "a member");
        require(gcv_scene_set(scene.get(), &id, &polygon, member.position.data(), 1), "a move");
      } else {
        require(gcv_scene_add(scene.get(), &polygon, member.position.data(), 1, &id), "a member");
      }
      require(gcv_scene_set_layers(scene.get(), &id, &member.layers, 1), "layers");
      ids.push_back(id);
    }
  }

  void ask_some(Random& random) {
    if (uniform(random, 0, 1) == 0) {
      query.layers = static_cast<std::uint32_t>(uniform(random, 1, 7));
    }
    for (int k = uniform(random, 0, 2); k > 0 && query.layers != UINT32_MAX; --k) {
      ignored.push_back(static_cast<std::uint64_t>(uniform(random, 1, 12)));
    }
    query.ignore = ignored.data();
    query.ignore_count = ignored.size();
  }
};

// Calls check(case) for the scenes of the family whose polygons are valid.
template <class Check>
void for_each_scene(const RegionFamily& family, int most_members, int positions, Check check) {
  Random random(chosen.seed);
  for (int k = 0; k < chosen.cases;) {
    std::optional<SceneOfCase> scene;
    try {
      scene.emplace(member_scene(family, random, most_members, positions), random);
    } catch (const invariants::Failure&) {
      continue;
    }
    for (const std::string& message : check(*scene)) {
      ADD_FAILURE() << "case " << k << ": " << message << text_of(scene->description, scene->ids)
                    << text_of(scene->query);
    }
    ++k;
  }
}

// Stars have many edges: the reference takes long for them.
int members_of(const RegionFamily& family, int most) {
  return std::string(family.name) == "spiky stars" ? most / 3 : most;
}

class Scenes : public ::testing::TestWithParam<RegionFamily> {};

TEST_P(Scenes, HaveTheRelationsOfTheDefinition) {
  SceneCounts counts;
  for_each_scene(GetParam(), members_of(GetParam(), 12), 8, [&](const SceneOfCase& c) {
    return check_scene_relations(c.checked, c.moving(), c.description.positions, c.asked(), counts);
  });
  std::printf("seed %llu: %zu apart, %zu touching, %zu overlapping\n",
              static_cast<unsigned long long>(chosen.seed), counts.contacts.apart,
              counts.contacts.touching, counts.contacts.overlapping);
}

TEST_P(Scenes, HaveTheDistancesOfTheDefinition) {
  SceneCounts counts;
  for_each_scene(GetParam(), members_of(GetParam(), 12), 4, [&](const SceneOfCase& c) {
    return check_scene_distances(c.checked, c.moving(), c.description.positions, c.asked(), counts);
  });
  std::printf("seed %llu: %zu ties, %zu infinite, %zu out of range\n",
              static_cast<unsigned long long>(chosen.seed), counts.ties, counts.infinite,
              counts.contacts.out_of_range);
}

TEST_P(Scenes, AreHitAsByTheDefinition) {
  SceneCounts counts;
  for_each_scene(GetParam(), members_of(GetParam(), 8), 2, [&](const SceneOfCase& c) {
    return check_scene_casts(c.checked, c.moving(), c.description.positions, c.description.motions,
                             c.asked(), counts);
  });
  std::printf(
      "seed %llu: %zu hits, %zu misses, %zu overlap at the start, %zu ties, %zu without a free "
      "position, %zu out of range\n",
      static_cast<unsigned long long>(chosen.seed), counts.contacts.hits, counts.contacts.misses,
      counts.contacts.starts_inside, counts.ties, counts.contacts.not_free,
      counts.contacts.out_of_range);
}

// 0, the distance of the nearest one, and the length of a motion.
double distance_of(const SceneOfCase& c, std::size_t number) {
  const Point& motion = c.description.motions.front();
  const double length = std::hypot(motion[0], motion[1]);
  gcv_separation nearest{};
  const gcv_status status =
      gcv_scene_distance(c.scene.get(), c.moving().handle, c.description.positions.front().data(),
                         1, c.asked(), nullptr, &nearest);
  const double distance = number % 3 == 0                       ? 0
                          : number % 3 == 1 && status == GCV_OK ? nearest.distance
                                                                : length;
  return std::min(distance, std::numeric_limits<double>::max());
}

TEST_P(Scenes, HaveThePairsOfTheDefinition) {
  SceneCounts counts;
  std::size_t number = 0;
  for_each_scene(GetParam(), members_of(GetParam(), 9), 1, [&](const SceneOfCase& c) {
    const double distance = distance_of(c, number++);
    Messages messages = check_scene_near(c.checked, c.moving(), c.description.positions.front(),
                                         distance, c.asked(), counts);
    const Messages others = check_scene_pairs(c.checked, distance, c.asked(), counts);
    messages.insert(messages.end(), others.begin(), others.end());
    return messages;
  });
  std::printf("seed %llu: %zu pairs\n", static_cast<unsigned long long>(chosen.seed), counts.pairs);
}

TEST_P(Scenes, HaveTheContactsOfTheDefinition) {
  static constexpr double slopes[] = {0, 0, 0x1p-52, 0.125, 3};
  SceneCounts counts;
  std::size_t number = 0;
  for_each_scene(GetParam(), members_of(GetParam(), 6), 1, [&](const SceneOfCase& c) {
    const double slope = slopes[number % std::size(slopes)];
    return check_scene_contacts(c.checked, distance_of(c, number++), slope, c.asked(), counts);
  });
  std::printf("seed %llu: %zu contacts, %zu lists out of range\n",
              static_cast<unsigned long long>(chosen.seed), counts.contacts.listed,
              counts.contacts.out_of_range);
}

INSTANTIATE_TEST_SUITE_P(Families, Scenes,
                         ::testing::ValuesIn(contact_families().begin(), contact_families().end()),
                         [](const auto& family) { return name_of_family(family); });

}  // namespace
}  // namespace gcv::test

int main(int argc, char** argv) { return gcv::test::run_with(gcv::test::chosen, argc, argv); }
