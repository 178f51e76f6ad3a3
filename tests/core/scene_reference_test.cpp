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
#include "scene_of_case.hpp"
#include "scene_texts.hpp"

namespace gcv::test {
namespace {

CaseOptions chosen{12};

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
