// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Best positions in scenes that grow, as layouts do, against those in scenes that are made afresh
// with the same members: the same to the bit, whatever was asked before.
//   scene_layout_test [--cases=N] [--seed=N]: layouts of each family.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "case_options.hpp"
#include "contact_scenes.hpp"
#include "scene_answers.hpp"
#include "scene_texts.hpp"

namespace gcv::test {
namespace {

CaseOptions chosen{8};

using invariants::require;

class Layout {
 public:
  Layout(const MemberScene& description, const std::vector<invariants::PolygonHandle>& shapes,
         Random& random)
      : description_(description), shapes_(shapes), random_(random), scene_(new_scene()) {
    members_.container = description.container;
    require(gcv_scene_set_container(scene_.get(), shapes_[*description.container].get()),
            "a container");
  }

  // Asks for the best positions of a shape, here and afresh, and adds it to one of them. Sometimes
  // another change comes before. Gives what is wrong, or "".
  std::string step() {
    if (below(6) == 0 && !members_.by_id.empty()) {
      loosen();
    }
    const std::size_t shape = below(shapes_.size());
    const std::uint32_t layers = below(5) == 0 ? 1 : UINT32_MAX;
    // Layouts often make a polygon anew.
    const invariants::PolygonHandle anew = made(description_.shapes[shape]);
    const Asked asked{(below(2) == 0 ? anew : shapes_[shape]).get(), {}, {}, layers, {}, 0, 0};
    Name same;
    Name names;
    for (const auto& [id, member] : members_.by_id) {
      same[id] = id;
    }
    const invariants::SceneHandle fresh = made_afresh(members_, shapes_, names);
    const Asker asker(scene_.get(), asked, same);
    const Asker fresh_asker(fresh.get(), asked, names);
    if (asker.bests() != fresh_asker.bests()) {
      return "another best position of shape " + std::to_string(shape);
    }
    if (below(2) == 0 && asker.free_region() != fresh_asker.free_region()) {
      return "another free region of shape " + std::to_string(shape);
    }
    const Asker::Best best = asker.best(below(2) == 0 ? Point{-1, 0} : Point{0.25, 1}, 0);
    require(best.status, "a best position");
    found_ += static_cast<std::size_t>(best.found);
    add(shape, best.found == 1 ? best.position : any_position());
    return "";
  }

  [[nodiscard]] std::size_t found() const { return found_; }

 private:
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(uniform(random_, 0, static_cast<int>(count) - 1));
  }
  Point any_position() { return description_.positions[below(description_.positions.size())]; }

  void add(std::size_t shape, const Point& position) {
    const gcv_polygon* const polygon = shapes_[shape].get();
    Id id = 0;
    require(gcv_scene_add(scene_.get(), &polygon, position.data(), 1, &id), "a member");
    members_.by_id.emplace(id, Member{shape, position, UINT32_MAX});
  }

  // A change that may free positions.
  void loosen() {
    const auto member = std::next(members_.by_id.begin(),
                                  static_cast<std::ptrdiff_t>(below(members_.by_id.size())));
    auto& [id, is] = *member;
    gcv_scene* const scene = scene_.get();
    switch (below(4)) {
      case 0:
        is.layers = 2;
        require(gcv_scene_set_layers(scene, &id, &is.layers, 1), "layers");
        break;
      case 1:
        is.position = any_position();
        require(gcv_scene_set(scene, &id, nullptr, is.position.data(), 1), "a position");
        break;
      case 2:
        require(gcv_scene_set_container(scene, shapes_[*members_.container].get()), "a container");
        break;
      default:
        require(gcv_scene_remove(scene, &id, 1), "its end");
        members_.by_id.erase(member);
    }
    if (below(3) == 0) {
      gcv_scene* copy = nullptr;
      require(gcv_scene_copy(scene_.get(), &copy), "a copy");
      scene_.reset(copy);
    }
  }

  const MemberScene& description_;
  const std::vector<invariants::PolygonHandle>& shapes_;
  Random& random_;
  invariants::SceneHandle scene_;
  Members members_;
  std::size_t found_ = 0;
};

class Layouts : public ::testing::TestWithParam<RegionFamily> {};

TEST_P(Layouts, HaveTheBestPositionsOfScenesMadeAfresh) {
  Random random(chosen.seed);
  std::size_t found = 0;
  for (int k = 0; k < chosen.cases;) {
    const MemberScene description = member_scene(GetParam(), random, 14, 8);
    std::vector<invariants::PolygonHandle> shapes;
    try {
      for (const auto& rings : description.shapes) {
        shapes.push_back(made(rings));
      }
    } catch (const invariants::Failure&) {
      continue;
    }
    if (!description.container) {
      continue;
    }
    ++k;
    Layout layout(description, shapes, random);
    for (int step = 0; step < 24; ++step) {
      ASSERT_EQ(layout.step(), "") << "case " << k << ", step " << step << text_of(description, {});
    }
    found += layout.found();
  }
  std::printf("%d layouts, seed %llu: %zu positions found\n", chosen.cases,
              static_cast<unsigned long long>(chosen.seed), found);
}

INSTANTIATE_TEST_SUITE_P(Families, Layouts,
                         ::testing::ValuesIn(contact_families().begin(), contact_families().end()),
                         [](const auto& family) { return name_of_family(family); });

}  // namespace
}  // namespace gcv::test

int main(int argc, char** argv) { return gcv::test::run_with(gcv::test::chosen, argc, argv); }
