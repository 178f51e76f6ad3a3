// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Free regions of scenes against their definition: rings, segments and points as text, on random
// scenes full of ties. The reference puts all sums of edges and vertices of all members into one
// arrangement, and asks for each of its faces, edges and vertices whether a member is overlapped.
//   scene_region_reference_test [--cases=N] [--seed=N]: scenes of each unit, and more
// of whole numbers.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case_options.hpp"
#include "free_scenes.hpp"
#include "handles.hpp"
#include "region_reference.hpp"
#include "scene_texts.hpp"

namespace gcv::test {
namespace {

CaseOptions chosen{100};

using invariants::PolygonHandle;
using invariants::require;
using reference::RegionPart;

PolygonHandle made(const std::vector<invariants::Polygon>& rings) {
  std::vector<std::size_t> sizes;
  invariants::Polygon all;
  for (const invariants::Polygon& ring : rings) {
    sizes.push_back(ring.size());
    all.insert(all.end(), ring.begin(), ring.end());
  }
  gcv_polygon* out = nullptr;
  require(gcv_polygon_create_rings(all.front().data(), sizes.data(), sizes.size(), 0, &out),
          "a polygon");
  return PolygonHandle(out);
}

reference::Rings points_of(const std::vector<invariants::Polygon>& rings) {
  reference::Rings result;
  for (const invariants::Polygon& ring : rings) {
    PointVector& points = result.emplace_back();
    for (const invariants::Point& p : ring) {
      points.push_back({p[0], p[1]});
    }
  }
  return result;
}

std::vector<RegionPart> parts_of(const gcv_region* region) {
  std::vector<RegionPart> result;
  std::size_t vertex = 0;
  for (const gcv_region_part& part : invariants::elements(gcv_region_exact_parts, region)) {
    RegionPart& to = result.emplace_back(RegionPart{part.kind, part.polygon, {}});
    for (std::uint64_t k = 0; k < part.vertex_count; ++k) {
      char text[256];
      std::size_t length = 0;
      require(gcv_region_exact_vertex(region, vertex++, text, sizeof text, &length), "a vertex");
      to.vertices.emplace_back(text);
    }
  }
  return result;
}

// Both sides of a scene, with all members that are in some of the layers.
struct ScenePair {
  const FreeScene& description;
  gcv_query query GCV_QUERY_INIT;

  [[nodiscard]] std::vector<RegionPart> got() const {
    const MemberScene& members = description.scene;
    gcv_scene* out = nullptr;
    require(gcv_scene_create(&out), "a scene");
    const invariants::SceneHandle scene(out);
    for (const MemberScene::Member& member : members.members) {
      const PolygonHandle handle = made(members.shapes[member.shape]);
      const gcv_polygon* const polygon = handle.get();
      std::uint64_t id = 0;
      require(gcv_scene_add(out, &polygon, member.position.data(), 1, &id), "a member");
      require(gcv_scene_set_layers(out, &id, &member.layers, 1), "layers");
    }
    if (members.container) {
      require(gcv_scene_set_container(out, made(members.shapes[*members.container]).get()),
              "a container");
    }
    const auto& window = description.window;
    gcv_region* region = nullptr;
    require(gcv_scene_free_region(out, made(members.shapes[members.moving]).get(),
                                  window ? window->data() : nullptr, &query, nullptr, &region),
            "a free region");
    const std::unique_ptr<gcv_region, invariants::Destroy> owner(region);
    return parts_of(region);
  }

  [[nodiscard]] std::vector<RegionPart> wanted() const {
    const MemberScene& members = description.scene;
    reference::PlacedRings placed;
    for (const MemberScene::Member& member : members.members) {
      if ((member.layers & query.layers) != 0) {
        placed.push_back(
            {points_of(members.shapes[member.shape]), {member.position[0], member.position[1]}});
      }
    }
    std::optional<reference::Window> window;
    if (description.window) {
      const auto& [x0, y0, x1, y1] = *description.window;
      window = {{x0, y0}, {x1, y1}};
    }
    const auto container = members.container
                               ? std::optional(points_of(members.shapes[*members.container]))
                               : std::nullopt;
    return reference::free_region(placed, container ? &*container : nullptr,
                                  points_of(members.shapes[members.moving]), window);
  }
};

class FreeRegions : public ::testing::TestWithParam<double> {};

TEST_P(FreeRegions, AreThoseOfTheDefinition) {
  Random random(chosen.seed);
  std::size_t kinds[4] = {};
  const int cases = GetParam() == 1 ? 4 * chosen.cases : chosen.cases;  // tenths take longer
  for (int k = 0; k < cases; ++k) {
    const FreeScene scene = free_scene(random, GetParam(), 12, 0);
    ScenePair pair{scene};
    pair.query.layers = static_cast<std::uint32_t>(uniform(random, 1, 7));
    const std::vector<RegionPart> got = pair.got();
    for (const RegionPart& part : got) {
      ++kinds[part.kind - 1];
    }
    std::vector<std::uint64_t> ids;
    for (std::size_t id = 2; id < scene.scene.members.size() + 2; ++id) {
      ids.push_back(id);
    }
    ASSERT_EQ(reference::text(got), reference::text(pair.wanted()))
        << "case " << k << text_of(scene.scene, ids) << text_of(pair.query) << "\nwindow "
        << (scene.window ? (*scene.window)[0] : 0) << ' ' << (scene.window ? (*scene.window)[1] : 0)
        << ' ' << (scene.window ? (*scene.window)[2] : 0) << ' '
        << (scene.window ? (*scene.window)[3] : 0);
  }
  std::printf("%d scenes, seed %llu: %zu polygons, %zu holes, %zu segments, %zu points\n", cases,
              static_cast<unsigned long long>(chosen.seed), kinds[0], kinds[1], kinds[2], kinds[3]);
}

INSTANTIATE_TEST_SUITE_P(Units, FreeRegions, ::testing::Values(1, 0.1));

}  // namespace
}  // namespace gcv::test

int main(int argc, char** argv) { return gcv::test::run_with(gcv::test::chosen, argc, argv); }
