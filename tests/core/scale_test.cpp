// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Huge and tiny coordinates: what is asked of polygons and scenes that are multiplied by a power of
// two has the same answers, multiplied by it, to the bit.
//   scale_test [--cases=N] [--seed=N]: scenes of each family.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "case_options.hpp"
#include "contact_scenes.hpp"
#include "scene_answers.hpp"
#include "scene_texts.hpp"

namespace gcv::test {
namespace {

CaseOptions chosen{24};

using invariants::require;

// Answers about a scene whose coordinates are multiplied, divided by the same.
class Answers {
 public:
  Answers(const MemberScene& description, double scale) : scale_(scale) {
    for (const auto& rings : description.shapes) {
      std::vector<invariants::Polygon> multiplied = rings;
      for (invariants::Polygon& ring : multiplied) {
        for (Point& p : ring) {
          p = times_scale(p);
        }
      }
      shapes_.push_back(made(multiplied));
    }
    for (const Point& p : description.positions) {
      positions_.push_back(times_scale(p));
    }
    moving_ = shapes_[description.moving].get();
    for (const invariants::PolygonHandle& shape : shapes_) {
      add_pair(shape.get());
    }
    add_scene(description);
  }

  [[nodiscard]] const std::vector<double>& values() const { return values_; }

 private:
  [[nodiscard]] Point times_scale(const Point& p) const { return {scale_ * p[0], scale_ * p[1]}; }
  void add(double x) { values_.push_back(x / scale_); }
  void add_name(std::uint64_t x) { values_.push_back(static_cast<double>(x)); }
  void add(gcv_region* out) {
    const Owner<gcv_region> region(out);
    for (const auto& [x, y] : vertices_of(region.get())) {
      add(x);
      add(y);
    }
    for (const Id id : invariants::elements(gcv_region_edge_owners, region.get())) {
      add_name(id);
    }
  }
  void add(const std::vector<gcv_escape>& ways) {
    for (const gcv_escape& way : ways) {
      add(way.depth);
      for (const double x : {way.translation[0], way.translation[1], way.position[0],
                             way.position[1], way.contact.on_a[0], way.contact.on_a[1]}) {
        add(x);
      }
      for (const std::uint64_t name :
           {std::uint64_t{way.contact.a}, std::uint64_t{way.contact.b}, way.contact.id_a}) {
        add_name(name);
      }
    }
  }

  void add_pair(const gcv_polygon* other) {
    gcv_region* region = nullptr;
    require(gcv_minkowski_sum_region(other, moving_, nullptr, &region), "a sum");
    add(region);
    std::vector<gcv_escape> ways(positions_.size());
    require(gcv_penetration(other, moving_, positions_.front().data(), positions_.size(), nullptr,
                            ways.data()),
            "ways out");
    add(ways);
  }

  void add_scene(const MemberScene& description) {
    const invariants::SceneHandle scene = new_scene();
    for (const auto& [shape, position, layers] : description.members) {
      const gcv_polygon* const polygon = shapes_[shape].get();
      const Point at = times_scale(position);
      Id id = 0;
      require(gcv_scene_add(scene.get(), &polygon, at.data(), 1, &id), "a member");
    }
    std::vector<gcv_escape> ways(positions_.size());
    if (description.container) {
      require(gcv_scene_set_container(scene.get(), shapes_[*description.container].get()),
              "a container");
      gcv_region* region = nullptr;
      require(gcv_scene_free_region(scene.get(), moving_, nullptr, nullptr, nullptr, &region),
              "a free region");
      add(region);
      for (const Point& direction : Points{{-1, 0}, {0.25, 1}}) {
        Point best{0, 0};
        std::int32_t is_found = 0;
        require(gcv_scene_best(scene.get(), moving_, direction.data(), nullptr, nullptr,
                               best.data(), &is_found),
                "a best position");
        add(best[0]);
        add(best[1]);
      }
    }
    require(gcv_scene_penetration(scene.get(), moving_, positions_.front().data(),
                                  positions_.size(), nullptr, nullptr, ways.data()),
            "ways out");
    add(ways);
  }

  double scale_;
  std::vector<invariants::PolygonHandle> shapes_;
  Points positions_;
  const gcv_polygon* moving_ = nullptr;
  std::vector<double> values_;
};

// Can all be multiplied by the powers of two below, and lose nothing?
bool can_be_scaled(const MemberScene& scene) {
  const auto is_of_middle_size = [](const Point& p) {
    return std::all_of(p.begin(), p.end(), [](double x) {
      return x == 0 || (std::abs(x) > 0x1p-60 && std::abs(x) < 0x1p60);
    });
  };
  const auto are_of_middle_size = [&](const auto& points) {
    return std::all_of(points.begin(), points.end(), is_of_middle_size);
  };
  return are_of_middle_size(scene.positions) &&
         std::all_of(scene.members.begin(), scene.members.end(),
                     [&](const auto& member) { return is_of_middle_size(member.position); }) &&
         std::all_of(scene.shapes.begin(), scene.shapes.end(), [&](const auto& rings) {
           return std::all_of(rings.begin(), rings.end(), are_of_middle_size);
         });
}

class Scales : public ::testing::TestWithParam<RegionFamily> {};

TEST_P(Scales, ChangeNoAnswers) {
  Random random(chosen.seed);
  int asked = 0;
  for (int k = 0; k < chosen.cases; ++k) {
    const MemberScene description = member_scene(GetParam(), random, 8, 12);
    if (!can_be_scaled(description)) {
      continue;
    }
    std::vector<double> values;
    try {
      values = Answers(description, 1).values();
    } catch (const invariants::Failure&) {
      continue;  // a ring that is not simple
    }
    ++asked;
    for (const double scale : {0x1p600, 0x1p900, 0x1p-500, 0x1p-800}) {
      const std::vector<double> scaled = Answers(description, scale).values();
      ASSERT_EQ(scaled.size(), values.size()) << "times " << scale << text_of(description, {});
      for (std::size_t place = 0; place < values.size(); ++place) {
        ASSERT_EQ(scaled[place], values[place])
            << "times " << scale << ", value " << place << text_of(description, {});
      }
    }
  }
  EXPECT_GT(asked, 0);
  std::printf("%d scenes, seed %llu\n", asked, static_cast<unsigned long long>(chosen.seed));
}

INSTANTIATE_TEST_SUITE_P(Families, Scales,
                         ::testing::ValuesIn(contact_families().begin(), contact_families().end()),
                         [](const auto& family) { return name_of_family(family); });

}  // namespace
}  // namespace gcv::test

int main(int argc, char** argv) { return gcv::test::run_with(gcv::test::chosen, argc, argv); }
