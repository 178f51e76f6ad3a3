// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A random scene for both sides: the library's and the reference's, and a query about it.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "contact_scenes.hpp"
#include "scene_agreement.hpp"

namespace gcv::test {

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
    invariants::require(gcv_scene_create(&out), "a scene");
    scene.reset(out);
    add_members(random);
    if (description.container) {
      const std::size_t shape = *description.container;
      invariants::require(gcv_scene_set_container(scene.get(), shapes[shape].get()), "a container");
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
        invariants::require(gcv_scene_add(scene.get(), &other, member.position.data(), 1, &id),
                            "a member");
        invariants::require(gcv_scene_remove(scene.get(), &id, 1), "its end");
      }
      if (uniform(random, 0, 2) == 0) {
        invariants::require(gcv_scene_add(scene.get(), &other, elsewhere.data(), 1, &id),
                            "a member");
        invariants::require(gcv_scene_set(scene.get(), &id, &polygon, member.position.data(), 1),
                            "a move");
      } else {
        invariants::require(gcv_scene_add(scene.get(), &polygon, member.position.data(), 1, &id),
                            "a member");
      }
      invariants::require(gcv_scene_set_layers(scene.get(), &id, &member.layers, 1), "layers");
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

}  // namespace gcv::test
