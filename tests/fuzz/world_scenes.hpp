// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Bytes -> three small polygons in a container, and one that moves; and what the library says of
// them.
#pragma once

#include <array>
#include <string>

#include "../worlds/compare.hpp"
#include "world_answers.hpp"

namespace gcv::fuzz {

struct WorldScene {
  World container;
  std::array<World, 3> members;
  std::array<WorldPoint, 3> positions;
  World moving;
};

inline World read_member(Input& input) {
  switch (input.below(4)) {
    case 0:
      return {in_integers(grid_rectangle(input, 2))};
    case 1:
      return {histogram(heights(input))};
    case 2:
      return {key(1, 1, 1, 1)};
    default:
      return {any_ring(input)};
  }
}

inline World read_container(Input& input) {
  const Int width = small(input, 3, 7);
  const Int height = small(input, 3, 7);
  switch (input.below(4)) {
    case 0:
      return {rectangle(0, 0, width, height)};
    case 1:
      return {rectangle(0, 0, width, height), rectangle(1, 1, 2, 2)};
    case 2:
      // An angle.
      return {{{0, 0}, {width, 0}, {width, 2}, {2, 2}, {2, height}, {0, height}}};
    default: {
      World container{any_ring(input)};
      for (WorldPoint& p : container[0]) {
        p = 2 * p;
      }
      return container;
    }
  }
}

inline WorldScene read_scene(Input& input) {
  WorldScene scene;
  scene.container = in_corner(read_container(input));
  for (World& member : scene.members) {
    member = in_corner(read_member(input));
  }
  for (WorldPoint& position : scene.positions) {
    position = {small(input, 0, 6), small(input, 0, 6)};
  }
  // What moves may be what is there already.
  scene.moving = input.below(4) == 0 ? scene.members[0] : in_corner(read_member(input));
  return scene;
}

inline std::string text(const WorldScene& scene) {
  std::string result = "\n  container: " + worlds::text(scene.container);
  for (std::size_t k = 0; k < scene.members.size(); ++k) {
    result += "\n  member: " + worlds::text(worlds::moved(scene.members[k], scene.positions[k]));
  }
  return result + "\n  moving: " + worlds::text(scene.moving);
}

// The polygons of a scene, and the scene.
struct MadeScene {
  MadeScene(const WorldScene& given, const Variant& variant)
      : container(make(given.container, variant, variant.shift)),
        moving(make(given.moving, variant, variant.moving_shift)) {
    gcv_scene* created = nullptr;
    worlds::check(gcv_scene_create(&created));
    scene.reset(created);
    worlds::check(gcv_scene_set_container(created, container.get()));
    for (std::size_t k = 0; k < members.size(); ++k) {
      members[k] = make(given.members[k], variant, {});
      const WorldPoint at = worlds::image(variant.symmetry, given.positions[k]) + variant.shift;
      const std::array<double, 2> xy{variant.number(at.x), variant.number(at.y)};
      const gcv_polygon* member = members[k].get();
      std::uint64_t id = 0;
      worlds::check(gcv_scene_add(created, &member, xy.data(), 1, &id));
    }
  }

  Handle container;
  Handle moving;
  std::array<Handle, 3> members;
  worlds::Owner<gcv_scene> scene;
};

inline Answers ask_scene(const MadeScene& made, const Places& places, const Variant& variant,
                         Theme theme) {
  Answers answers;
  if (theme == Theme::regions || theme == Theme::fits) {
    gcv_region* region = nullptr;
    worlds::check(gcv_scene_free_region(made.scene.get(), made.moving.get(), nullptr, nullptr,
                                        nullptr, &region));
    const worlds::Owner<gcv_region> owner(region);
    answers.region = parts(*region, variant);
    answers.located = locate(*region, doubles(places, variant));
  }
  const auto cast = [&](const double* from, const double* motions, std::size_t count,
                        const gcv_options* options, gcv_impact* out) {
    return gcv_scene_cast(made.scene.get(), made.moving.get(), from, motions, count, nullptr,
                          options, out);
  };
  ask(worlds::SceneSubject(*made.scene, *made.moving), places, variant, theme, cast, answers);
  return answers;
}

// What is wrong with the answers about a scene, by those about its polygons; or nothing.
inline const char* contradiction(const WorldScene& scene, const MadeScene& made,
                                 const Places& places, const Answers& answers) {
  if (!answers.located.empty() && answers.located != answers.relation) {
    return "the free region is not where the relation is free";
  }
  gcv_region* fit = nullptr;
  const std::array<double, 2> origin{};
  worlds::check(
      gcv_inner_fit_region(made.container.get(), made.moving.get(), origin.data(), nullptr, &fit));
  const worlds::Owner<gcv_region> owner(fit);
  std::vector<std::int8_t> relation = locate(*fit, doubles(places, {}));
  std::vector<double> distance(relation.size(), HUGE_VAL);
  for (std::size_t k = 0; k < scene.members.size(); ++k) {
    Variant from_member;
    from_member.moving_shift = scene.positions[k];
    const worlds::PairSubject pair(*made.members[k], *made.moving);
    const std::vector<gcv_separation> separations = pair.distance(doubles(places, from_member));
    for (std::size_t i = 0; i < separations.size(); ++i) {
      relation[i] = std::min(relation[i], static_cast<std::int8_t>(separations[i].relation));
      distance[i] = std::min(distance[i], separations[i].distance);
    }
  }
  if (relation != answers.relation) {
    return "the relation to a scene is not that to its polygons";
  }
  for (std::size_t i = 0; i < answers.distance.size(); ++i) {
    const gcv_separation& answer = answers.distance[i];
    constexpr std::uint64_t container_id = 1;
    if (answer.relation == GCV_APART && answer.nearest.id_a != container_id
            ? answer.distance != distance[i]
            : answer.distance > distance[i]) {
      return "the distance from a scene is not that from its nearest polygon";
    }
  }
  return nullptr;
}

// Everything, against the definitions.
inline void compare(const WorldScene& scene, worlds::Report& report) {
  using worlds::Operand;
  const std::array<Operand, 3> members{Operand(scene.members[0]), Operand(scene.members[1]),
                                       Operand(scene.members[2])};
  worlds::compare_scene(Operand(scene.container), members, scene.positions, Operand(scene.moving),
                        report);
}

}  // namespace gcv::fuzz
