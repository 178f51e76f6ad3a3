// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where polygons are free in scenes, on random members on small grids: the free region by the
// relation at many places, the best positions and the ways out of overlaps by the free region.
//   scene_free_test [--cases=N] [--seed=N]: scenes of each unit, and some of each family.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>

#include "case_options.hpp"
#include "free_agreement.hpp"
#include "free_scenes.hpp"
#include "scene_of_case.hpp"
#include "scene_texts.hpp"

namespace gcv::test {
namespace {

CaseOptions chosen{400};

std::string text_of_window(const Window& window) {
  return !window ? ", no window"
                 : "\nwindow " + text_of(Point{(*window)[0], (*window)[1]}) + " to " +
                       text_of(Point{(*window)[2], (*window)[3]});
}

// Does the query admit the container?
bool has_container(const SceneOfCase& c) {
  const PlacedSolids solids = asked_solids(c.checked, c.asked());
  return !solids.empty() && solids.front()->id == 1;
}

// Calls check(case, window) for scenes with that unit.
template <class Check>
void for_each_scene(double unit, Check check) {
  Random random(chosen.seed);
  for (int k = 0; k < chosen.cases; ++k) {
    const FreeScene scene = free_scene(random, unit, 6, 60);
    const SceneOfCase c(scene.scene, random);
    for (const std::string& message : check(c, scene.window)) {
      ADD_FAILURE() << "case " << k << ": " << message << text_of(c.description, c.ids)
                    << text_of(c.query) << text_of_window(scene.window);
    }
  }
}

// Large enough for the ways out, where no container bounds them.
Window window_around(double unit) { return {{-64 * unit, -64 * unit, 64 * unit, 64 * unit}}; }

class FreePositions : public ::testing::TestWithParam<double> {};

TEST_P(FreePositions, AreWhereNothingOverlaps) {
  FreeCounts counts;
  for_each_scene(GetParam(), [&](const SceneOfCase& c, Window window) {
    const MovingPolygon moving = c.moving();
    const FreeQuestion question{c.checked, moving, c.asked()};
    window = window || has_container(c) ? window : window_around(GetParam());
    return check_places(question, question.region(window).get(), window, c.description.positions,
                        counts);
  });
  std::printf(
      "%d scenes, seed %llu: %zu polygons, %zu holes, %zu segments, %zu points; places: %zu "
      "inside, "
      "%zu on boundaries, %zu outside, %zu on borders\n",
      chosen.cases, static_cast<unsigned long long>(chosen.seed), counts.polygons, counts.holes,
      counts.segments, counts.points, counts.inside, counts.boundary, counts.outside,
      counts.on_border);
}

// Windows with the end of a fit in the middle of a side, or in a corner.
std::vector<Window> windows_beside(const Point& p, double unit) {
  std::vector<Window> windows;
  for (const double dx : {0.0, -1.0, -2.0}) {
    for (const double dy : {0.0, -1.0, -2.0}) {
      const double x = p[0] + dx * unit;
      const double y = p[1] + dy * unit;
      windows.push_back({{x, y, x + 2 * unit, y + 2 * unit}});
    }
  }
  return windows;
}

TEST_P(FreePositions, HaveTheFitsOfTheWholeInAWindow) {
  FreeCounts counts;
  for_each_scene(GetParam(), [&](const SceneOfCase& c, const Window& given) {
    Messages messages;
    if (!has_container(c)) {
      return messages;
    }
    const MovingPolygon moving = c.moving();
    const FreeQuestion question{c.checked, moving, c.asked()};
    const ExactParts whole = exact_parts(question.region({}).get());
    std::vector<Window> windows;
    if (given) {
      windows.push_back(given);
    }
    for (const ExactPart& part : whole) {
      if (part.kind >= GCV_PART_SEGMENT && windows.size() < 30) {
        const auto beside = windows_beside(invariants::nearest(part.points.back()), GetParam());
        windows.insert(windows.end(), beside.begin(), beside.end());
      }
    }
    for (const Window& window : windows) {
      for (const std::string& message :
           check_fits(whole, question.region(window).get(), window, counts)) {
        messages.push_back(message + text_of_window(window));
      }
    }
    return messages;
  });
  EXPECT_GT(counts.fits_in_window, 0U);
  std::printf("%d scenes, seed %llu: %zu ends of fits in windows\n", chosen.cases,
              static_cast<unsigned long long>(chosen.seed), counts.fits_in_window);
}

TEST_P(FreePositions, AreTheFurthestInADirection) {
  static const Points directions{{-1, 0}, {0, -1}, {1, 0}, {1, 1}, {-3, 2}, {0.1, -0.3}};
  FreeCounts counts;
  for_each_scene(GetParam(), [&](const SceneOfCase& c, const Window&) {
    if (!has_container(c)) {
      return Messages{};
    }
    const MovingPolygon moving = c.moving();
    const FreeQuestion question{c.checked, moving, c.asked()};
    return check_best(question, exact_parts(question.region({}).get()), directions, counts);
  });
  std::printf("%d scenes, seed %llu: %zu ties, %zu without a free position, %zu overlap\n",
              chosen.cases, static_cast<unsigned long long>(chosen.seed), counts.ties, counts.none,
              counts.contacts.not_free);
}

TEST_P(FreePositions, AreTheNearestOnes) {
  FreeCounts counts;
  for_each_scene(GetParam(), [&](const SceneOfCase& c, const Window&) {
    const MovingPolygon moving = c.moving();
    const FreeQuestion question{c.checked, moving, c.asked()};
    const Window window = has_container(c) ? Window{} : window_around(GetParam());
    const Points positions(c.description.positions.begin(), c.description.positions.begin() + 6);
    return check_ways_out(question, exact_parts(question.region(window).get()), positions, counts);
  });
  std::printf("%d scenes, seed %llu: %zu overlaps, %zu ties, %zu without a way out, %zu overlap\n",
              chosen.cases, static_cast<unsigned long long>(chosen.seed),
              counts.contacts.overlapping, counts.ties, counts.none, counts.contacts.not_free);
}

INSTANTIATE_TEST_SUITE_P(Units, FreePositions, ::testing::Values(1, 0.1));

// The rectangle between two positions, if it is one.
Window window_between(const Point& p, const Point& q) {
  const auto [x0, x1] = std::minmax(p[0], q[0]);
  const auto [y0, y1] = std::minmax(p[1], q[1]);
  return x0 < x1 && y0 < y1 ? Window{{x0, y0, x1, y1}} : std::nullopt;
}

Messages check_all(const SceneOfCase& c, bool is_in_window, FreeCounts& counts) {
  const MovingPolygon moving = c.moving();
  const FreeQuestion question{c.checked, moving, c.asked()};
  const Points& positions = c.description.positions;
  const Window window = window_between(positions[0], positions[1]);
  Messages messages;
  const auto add = [&](const Messages& others) {
    messages.insert(messages.end(), others.begin(), others.end());
  };
  if (has_container(c)) {
    const ExactParts whole = exact_parts(question.region({}).get());
    add(check_best(question, whole, {{-1, 0}, {0.25, 1}}, counts));
    add(check_ways_out(question, whole, {positions[0], positions[1]}, counts));
  }
  if (window && (is_in_window || !has_container(c))) {
    add(check_places(question, question.region(window).get(), window, positions, counts));
  } else if (has_container(c)) {
    add(check_places(question, question.region({}).get(), {}, positions, counts));
  }
  return messages;
}

// Members of any size and anywhere.
class FreePositionsOfFamilies : public ::testing::TestWithParam<RegionFamily> {};

TEST_P(FreePositionsOfFamilies, AgreeWithTheRelation) {
  FreeCounts counts;
  Random random(chosen.seed);
  for (int k = 0; k < chosen.cases / 50;) {
    std::optional<SceneOfCase> c;
    try {
      c.emplace(member_scene(GetParam(), random, 6, 12), random);
    } catch (const invariants::Failure&) {  // a polygon that is not valid
      continue;
    }
    try {
      for (const std::string& message : check_all(*c, k % 2 == 0, counts)) {
        ADD_FAILURE() << "case " << k << ": " << message << text_of(c->description, c->ids)
                      << text_of(c->query);
      }
    } catch (const invariants::Failure& failure) {
      EXPECT_EQ(failure.status, GCV_ERR_RANGE) << "case " << k << ": " << failure.what();
      ++counts.contacts.out_of_range;
    }
    ++k;
  }
  std::printf("seed %llu: %zu polygons, %zu fits, %zu overlaps, %zu out of range\n",
              static_cast<unsigned long long>(chosen.seed), counts.polygons,
              counts.segments + counts.points, counts.contacts.overlapping,
              counts.contacts.out_of_range);
}

INSTANTIATE_TEST_SUITE_P(Families, FreePositionsOfFamilies,
                         ::testing::ValuesIn(contact_families().begin(), contact_families().end()),
                         [](const auto& family) { return name_of_family(family); });

}  // namespace
}  // namespace gcv::test

int main(int argc, char** argv) { return gcv::test::run_with(gcv::test::chosen, argc, argv); }
