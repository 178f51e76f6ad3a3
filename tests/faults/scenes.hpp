// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A scene of polygons that nothing is prepared for yet, the questions about it, and all that there
// is to know of it, byte by byte.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "questions.hpp"

namespace gcv::faults {

inline constexpr std::uint64_t first_id = 2;

// Members 2, 3, 5, ... in a container, and polygons that are not there yet.
struct NewScene {
  std::vector<Owner<gcv_polygon>> polygons;
  Owner<gcv_polygon> moving;
  Owner<gcv_scene> scene;

  NewScene()
      : polygons(new_polygons()),
        moving(read("POLYGON ((0 0, 1 0.25, 0.5 1, 0.25 0.5))")),
        scene(made<gcv_scene>(gcv_scene_create)) {
    static constexpr double positions[] = {0, 0, 5, 0.5, -9, 1, 0.1, 8, 1e16, 0, -2, -3, 2, 5};
    constexpr std::size_t count = std::size(positions) / 2;
    std::vector<const gcv_polygon*> members;
    for (std::size_t k = 0; k < count; ++k) {
      members.push_back(polygons[k % 3].get());
    }
    std::uint64_t ids[count];
    require(gcv_scene_add(scene.get(), members.data(), positions, count, ids));
    require(gcv_scene_remove(scene.get(), &ids[2], 1));
    const Owner<gcv_polygon> container =
        read("POLYGON ((-12 -12, 20 -12, 20 20, -12 20), (-8 -8, -6 -8, -6 -6))");
    require(gcv_scene_set_container(scene.get(), container.get()));
    const std::uint32_t layers = 3;
    require(gcv_scene_set_layers(scene.get(), &ids[1], &layers, 1));
  }

 private:
  static std::vector<Owner<gcv_polygon>> new_polygons() {
    std::vector<Owner<gcv_polygon>> result;
    for (Pair& pair : pairs()) {
      result.push_back(std::move(pair.a));
    }
    return result;
  }
};

// Places of the moving polygon, in steps through the scene. Each motion leads to the place before.
inline Places scene_places(std::size_t count) {
  Places places;
  for (std::size_t k = 0; k < count; ++k) {
    const auto step = [k](std::size_t prime) { return static_cast<double>(k % prime); };
    const Vertex t{step(13) - 6.5, 1.25 * step(11) - 4};
    const Vertex before = k == 0 ? t : places.translations.back();
    places.translations.push_back(t);
    places.motions.push_back({before.x - t.x, before.y - t.y});
  }
  return places;
}

struct SceneQuestion {
  const char* name;
  std::size_t answer_size;
  gcv_status (*ask)(const NewScene& s, const Places& places, const gcv_query* query,
                    const gcv_options* options, void* out);
};

inline constexpr SceneQuestion scene_questions[] = {
    {"gcv_scene_relation", sizeof(std::int8_t),
     [](const NewScene& s, const Places& places, const gcv_query* query, const gcv_options* options,
        void* out) {
       return gcv_scene_relation(s.scene.get(), s.moving.get(), places.xy(), places.count(), query,
                                 options, static_cast<std::int8_t*>(out));
     }},
    {"gcv_scene_distance", sizeof(gcv_separation),
     [](const NewScene& s, const Places& places, const gcv_query* query, const gcv_options* options,
        void* out) {
       return gcv_scene_distance(s.scene.get(), s.moving.get(), places.xy(), places.count(), query,
                                 options, static_cast<gcv_separation*>(out));
     }},
    {"gcv_scene_cast", sizeof(gcv_impact),
     [](const NewScene& s, const Places& places, const gcv_query* query, const gcv_options* options,
        void* out) {
       return gcv_scene_cast(s.scene.get(), s.moving.get(), places.xy(), places.motions_xy(),
                             places.count(), query, options, static_cast<gcv_impact*>(out));
     }},
    {"gcv_scene_penetration", sizeof(gcv_escape),
     [](const NewScene& s, const Places& places, const gcv_query* query, const gcv_options* options,
        void* out) {
       return gcv_scene_penetration(s.scene.get(), s.moving.get(), places.xy(), places.count(),
                                    query, options, static_cast<gcv_escape*>(out));
     }},
};

inline std::string answers(const SceneQuestion& question, const NewScene& scene,
                           const Places& places, const gcv_query* query,
                           const gcv_options* options) {
  std::string bytes(places.count() * question.answer_size, '?');
  require(question.ask(scene, places, query, options, bytes.data()));
  return bytes;
}

inline gcv_status free_region_of(const NewScene& s, const gcv_query* query, gcv_region** out) {
  static constexpr double window[] = {-9, -8.5, 9, 8};
  return gcv_scene_free_region(s.scene.get(), s.moving.get(), window, query, nullptr, out);
}

struct Best {
  double position[2];
  std::int32_t found;
};

inline gcv_status best_in(const NewScene& s, const gcv_query* query, Best* out) {
  static constexpr double direction[] = {-2, 1};
  return gcv_scene_best(s.scene.get(), s.moving.get(), direction, query, nullptr, out->position,
                        &out->found);
}

inline gcv_status near(const NewScene& s, const gcv_query* query, gcv_pair_list** out) {
  static constexpr double position[] = {1, 1};
  return gcv_scene_near(s.scene.get(), s.moving.get(), position, 3, query, nullptr, out);
}
inline gcv_status pairs_of(const NewScene& s, const gcv_pair_list* previous,
                           const gcv_options* options, gcv_pair_list** out) {
  return gcv_scene_pairs(s.scene.get(), previous, 3, nullptr, options, out);
}
inline gcv_status contacts_of(const NewScene& s, const gcv_contact_list* previous,
                              const gcv_options* options, gcv_contact_list** out) {
  return gcv_scene_contacts(s.scene.get(), previous, 0.5, 0.125, nullptr, options, out);
}

// Members, and what all questions say of them in some layers.
inline std::string transcript(const NewScene& s) {
  std::string bytes;
  append_elements<std::uint64_t>(
      bytes, [&](std::uint64_t* out, std::size_t capacity, std::size_t* required) {
        return gcv_scene_ids(s.scene.get(), out, capacity, required);
      });
  std::vector<std::uint64_t> ids(bytes.size() / sizeof(std::uint64_t));
  std::size_t count = 0;
  require(gcv_scene_ids(s.scene.get(), ids.data(), ids.size(), &count));
  std::vector<Vertex> positions(count + 1);
  require(gcv_scene_positions(s.scene.get(), ids.data(), count, &positions.front().x));
  for (std::size_t k = 0; k < count; ++k) {
    append(bytes, positions[k]);
    bytes += transcript(made<gcv_polygon>([&](gcv_polygon** out) {
                          return gcv_scene_polygon(s.scene.get(), ids[k], out);
                        }).get());
  }
  gcv_query query = GCV_QUERY_INIT;
  for (const std::uint32_t layers : {UINT32_MAX, 1U, 4U}) {
    query.layers = layers;
    for (const SceneQuestion& question : scene_questions) {
      bytes += answers(question, s, scene_places(4), &query, nullptr);
    }
    bytes += transcript(
        made<gcv_pair_list>([&](gcv_pair_list** out) { return near(s, &query, out); }).get());
    bytes += transcript(
        made<gcv_region>([&](gcv_region** out) { return free_region_of(s, &query, out); }).get());
    Best best{};
    append(bytes, best_in(s, &query, &best));  // there may be no container
    append(bytes, best.position);
  }
  bytes += transcript(made<gcv_pair_list>([&](gcv_pair_list** out) {
                        return pairs_of(s, nullptr, nullptr, out);
                      }).get());
  return bytes + transcript(made<gcv_contact_list>([&](gcv_contact_list** out) {
                              return contacts_of(s, nullptr, nullptr, out);
                            }).get());
}

}  // namespace gcv::faults
