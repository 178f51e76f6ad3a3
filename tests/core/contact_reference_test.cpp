// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Questions about two polygons against their definitions, on random scenes full of ties. The
// reference looks at every pair of edges and vertices, in fractions.
//   contact_reference_test [--cases=N] [--seed=N]: scenes of each family.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "case_options.hpp"
#include "contact_agreement.hpp"
#include "contact_scenes.hpp"
#include "scene_texts.hpp"

namespace gcv::test {
namespace {

CaseOptions chosen{30};

// Calls check(scene, pair) for the scenes of the family whose polygons are valid.
template <class Check>
void for_each_scene(const RegionFamily& family, int count, int translations, Check check) {
  Random random(chosen.seed);
  for (int k = 0; k < count;) {
    const ContactScene scene = contact_scene(family, random, translations);
    std::unique_ptr<ContactPair> pair;
    try {
      pair = std::make_unique<ContactPair>(scene.a, scene.b);
    } catch (const invariants::Failure&) {
      continue;
    }
    for (const std::string& message : check(scene, *pair)) {
      ADD_FAILURE() << "case " << k << ": " << message << "\na: " << text_of_rings(scene.a)
                    << "\nb: " << text_of_rings(scene.b);
    }
    ++k;
  }
}

class TwoPolygons : public ::testing::TestWithParam<RegionFamily> {};

TEST_P(TwoPolygons, HaveTheRelationOfTheDefinition) {
  ContactCounts counts;
  for_each_scene(GetParam(), 4 * chosen.cases, 16,
                 [&](const ContactScene& scene, const auto& pair) {
                   return check_relations(pair, scene.translations, counts);
                 });
  std::printf("seed %llu: %zu apart, %zu touching, %zu overlapping\n",
              static_cast<unsigned long long>(chosen.seed), counts.apart, counts.touching,
              counts.overlapping);
}

TEST_P(TwoPolygons, HaveTheDistanceOfTheDefinition) {
  ContactCounts counts;
  for_each_scene(GetParam(), 4 * chosen.cases, 8, [&](const ContactScene& scene, const auto& pair) {
    return check_distances(pair, scene.translations, counts);
  });
  std::printf("seed %llu: %zu out of range\n", static_cast<unsigned long long>(chosen.seed),
              counts.out_of_range);
}

TEST_P(TwoPolygons, MoveUntilTheyOverlap) {
  ContactCounts counts;
  for_each_scene(GetParam(), chosen.cases, 6, [&](const ContactScene& scene, const auto& pair) {
    return check_casts(pair, scene.translations, scene.motions, counts);
  });
  std::printf(
      "seed %llu: %zu hits, %zu misses, %zu overlap at the start, %zu without a free "
      "position, %zu out of range\n",
      static_cast<unsigned long long>(chosen.seed), counts.hits, counts.misses,
      counts.starts_inside, counts.not_free, counts.out_of_range);
}

// Distances: 0, that of the polygons, and the length of a motion. Slopes from none to a steep one.
TEST_P(TwoPolygons, HaveTheContactsOfTheDefinition) {
  const std::vector<double> slopes{0, 0, 0x1p-52, 0.125, 3};
  ContactCounts counts;
  std::size_t number = 0;
  for_each_scene(GetParam(), 2 * chosen.cases, 6, [&](const ContactScene& scene, const auto& pair) {
    Messages messages;
    for (std::size_t k = 0; k < scene.translations.size(); ++k) {
      const Point& t = scene.translations[k];
      gcv_separation separation{};
      if (gcv_distance(pair.a.get(), pair.b.get(), t.data(), 1, nullptr, &separation) != GCV_OK) {
        ++counts.out_of_range;
        continue;
      }
      const double length = std::hypot(scene.motions[k][0], scene.motions[k][1]);
      const std::vector<double> distances{0, separation.distance,
                                          std::min(length, std::numeric_limits<double>::max())};
      const double slope = slopes[number % slopes.size()];
      const double distance = distances[number % distances.size()];
      ++number;
      const Messages found = check_contacts(pair, t, distance, slope, counts);
      messages.insert(messages.end(), found.begin(), found.end());
    }
    return messages;
  });
  std::printf("seed %llu: %zu contacts in %zu lists, %zu out of range\n",
              static_cast<unsigned long long>(chosen.seed), counts.listed, number,
              counts.out_of_range);
}

// The reference takes seconds for a case of many vertices.
TEST_P(TwoPolygons, LeaveOverlapsTheShortestWay) {
  const bool is_large = std::string(GetParam().name) == "spiky stars";
  ContactCounts counts;
  for_each_scene(GetParam(), is_large ? (chosen.cases + 14) / 15 : chosen.cases, 6,
                 [&](const ContactScene& scene, const auto& pair) {
                   return check_escapes(pair, scene.translations, counts);
                 });
  std::printf("seed %llu: %zu overlap, %zu without a free position, %zu out of range\n",
              static_cast<unsigned long long>(chosen.seed), counts.overlapping, counts.not_free,
              counts.out_of_range);
}

template <class Result>
bool same_bytes(const Result& p, const Result& q) {
  return std::memcmp(&p, &q, sizeof p) == 0;
}

TEST(Answers, AreTheSameForOneTranslationAndForManyByThreads) {
  gcv_options options = GCV_OPTIONS_INIT;
  options.threads = 3;
  constexpr std::size_t count = 400;
  const RegionFamily family{"exact fits", jigsaws};
  std::size_t checked = 0;
  for_each_scene(family, 6, static_cast<int>(count), [&](const ContactScene& scene, auto& pair) {
    Messages messages;
    std::vector<gcv_separation> separations(count);
    std::vector<gcv_impact> impacts(count);
    const gcv_status far = gcv_distance(pair.a.get(), pair.b.get(), scene.translations[0].data(),
                                        count, &options, separations.data());
    const gcv_status away = gcv_cast(pair.a.get(), pair.b.get(), scene.translations[0].data(),
                                     scene.motions[0].data(), count, &options, impacts.data());
    for (std::size_t k = 0; k < count && far == GCV_OK && away == GCV_OK; ++k) {
      const Point& t = scene.translations[k];
      gcv_separation separation;
      gcv_impact impact;
      invariants::require(
          gcv_distance(pair.a.get(), pair.b.get(), t.data(), 1, nullptr, &separation), "one");
      invariants::require(gcv_cast(pair.a.get(), pair.b.get(), t.data(), scene.motions[k].data(), 1,
                                   nullptr, &impact),
                          "one");
      if (!same_bytes(separation, separations[k]) || !same_bytes(impact, impacts[k])) {
        report(messages, t, scene.motions[k], "another answer alone");
      }
      ++checked;
    }
    return messages;
  });
  EXPECT_GT(checked, 0U);
}

// a consists of two lenses that meet in (0, 2) and (0, -2). b has a part between them and a part
// round the right one, which meet in the same points. b can go nowhere.
TEST(Rings, ThatTouchInTheSamePointsHoldEachOther) {
  const ContactPair pair({{{-3, 0}, {0, -2}, {3, 0}, {0, 2}}, {{-1, 0}, {0, 2}, {1, 0}, {0, -2}}},
                         {{{0, 2}, {-0.5, 0}, {0, -2}, {-1, -5}, {8, -5}, {8, 5}, {-1, 5}},
                          {{0, 2}, {0.5, 0}, {0, -2}, {1, -4}, {7, -4}, {7, 4}, {1, 4}}});
  Points translations;
  Points motions;
  for (int x = -4; x <= 4; ++x) {
    for (int y = -4; y <= 4; ++y) {
      translations.push_back({0, 0});
      motions.push_back({x / 4.0, y / 4.0});
    }
  }
  ContactCounts counts;
  EXPECT_EQ(check_casts(pair, translations, motions, counts), Messages{});
  EXPECT_EQ(check_relations(pair, motions, counts), Messages{});
  EXPECT_EQ(counts.touching, 1U);
  EXPECT_EQ(counts.hits, 80U);
}

INSTANTIATE_TEST_SUITE_P(Families, TwoPolygons,
                         ::testing::ValuesIn(contact_families().begin(), contact_families().end()),
                         [](const auto& family) { return name_of_family(family); });

}  // namespace
}  // namespace gcv::test

int main(int argc, char** argv) { return gcv::test::run_with(gcv::test::chosen, argc, argv); }
