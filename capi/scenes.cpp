// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Scenes: gcv_scene_create, _copy, _destroy, the changes, and what is in them.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "compiler.hpp"
#include "contacts.hpp"
#include "error.hpp"
#include "fill.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "handles.hpp"
#include "scene.hpp"

namespace {

using gcv::Error;
using gcv::Member;
using gcv::Point;
using gcv::Polygon;
using gcv::Status;
using gcv::capi::fill;
using gcv::capi::guarded;
using gcv::capi::require;
using gcv::capi::require_count;
using gcv::capi::Vectors;

std::vector<std::shared_ptr<const Polygon>> polygons_of(const gcv_polygon* const* polygons,
                                                        std::size_t count) {
  constexpr std::size_t ahead = 8;
  std::vector<std::shared_ptr<const Polygon>> result;
  result.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    if (k + 2 * ahead < count) {
      gcv::prefetch(polygons[k + 2 * ahead]);
      if (const gcv_polygon* const next = polygons[k + ahead]; next != nullptr) {
        gcv::prefetch(next->polygon.get());
        gcv::prefetch(&next->polygon->outer.bounds);
      }
    }
    if (polygons[k] == nullptr) {
      throw Error(Status::null_argument, "polygons: number %zu is NULL", k);
    }
    result.push_back(polygons[k]->polygon);
  }
  return result;
}

// Throws Error: null_argument; as require_count().
std::span<const gcv::Id> ids_of(const std::uint64_t* ids, std::size_t count) {
  require(ids, "ids");
  require_count(count, sizeof *ids, "ids");
  return {ids, count};
}

// Throws Error: as Vectors.
std::vector<Point> points_of(const double* positions, std::size_t count) {
  const Vectors vectors(positions, count, "positions");
  std::vector<Point> result;
  result.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    result.push_back(vectors[k]);
  }
  return result;
}

}  // namespace

gcv_status gcv_scene_create(gcv_scene** out) {
  return guarded([&] {
    require(out, "out");
    *out = std::make_unique<gcv_scene>().release();
  });
}

gcv_status gcv_scene_copy(const gcv_scene* scene, gcv_scene** out) {
  return guarded([&] {
    require(scene, "scene");
    require(out, "out");
    *out = std::make_unique<gcv_scene>(*scene).release();
  });
}

void gcv_scene_destroy(gcv_scene* scene) { delete scene; }

gcv_status gcv_scene_set_container(gcv_scene* scene, const gcv_polygon* container) {
  return guarded([&] {
    require(scene, "scene");
    scene->scene.set_container(container == nullptr ? nullptr : container->polygon.get());
  });
}

gcv_status gcv_scene_add(gcv_scene* scene, const gcv_polygon* const* polygons,
                         const double* positions, size_t count, uint64_t* ids) {
  return guarded([&] {
    require(scene, "scene");
    if (count == 0) {
      return;
    }
    require(polygons, "polygons");
    require(positions, "positions");
    require(ids, "ids");
    const std::vector<Point> points = points_of(positions, count);
    const gcv::Id first = scene->scene.add(polygons_of(polygons, count), points);
    for (std::size_t k = 0; k < count; ++k) {
      ids[k] = first + k;
    }
  });
}

gcv_status gcv_scene_set(gcv_scene* scene, const uint64_t* ids, const gcv_polygon* const* polygons,
                         const double* positions, size_t count) {
  return guarded([&] {
    require(scene, "scene");
    if (count == 0) {
      return;
    }
    const std::span<const gcv::Id> members = ids_of(ids, count);
    scene->scene.set(members, polygons_of(polygons, polygons == nullptr ? 0 : count),
                     points_of(positions, positions == nullptr ? 0 : count));
  });
}

gcv_status gcv_scene_set_layers(gcv_scene* scene, const uint64_t* ids, const uint32_t* layers,
                                size_t count) {
  return guarded([&] {
    require(scene, "scene");
    if (count == 0) {
      return;
    }
    const std::span<const gcv::Id> members = ids_of(ids, count);
    require(layers, "layers");
    scene->scene.set_layers(members, std::span(layers, count));
  });
}

gcv_status gcv_scene_remove(gcv_scene* scene, const uint64_t* ids, size_t count) {
  return guarded([&] {
    require(scene, "scene");
    if (count == 0) {
      return;
    }
    scene->scene.remove(ids_of(ids, count));
  });
}

gcv_status gcv_scene_ids(const gcv_scene* scene, uint64_t* ids, size_t capacity, size_t* required) {
  return guarded([&] {
    require(scene, "scene");
    fill(scene->scene.size(), "ids", "ids", ids, capacity, required, [&](std::uint64_t* to) {
      for (const Member& member : scene->scene.members()) {
        if (member.polygon != nullptr) {
          *to++ = member.id;
        }
      }
    });
  });
}

gcv_status gcv_scene_positions(const gcv_scene* scene, const uint64_t* ids, size_t count,
                               double* xy) {
  return guarded([&] {
    require(scene, "scene");
    if (count == 0) {
      return;
    }
    const std::span<const gcv::Id> members = ids_of(ids, count);
    require(xy, "xy");
    const std::vector<Point> positions = scene->scene.positions(members);
    for (std::size_t k = 0; k < count; ++k) {
      xy[2 * k] = positions[k].x;
      xy[2 * k + 1] = positions[k].y;
    }
  });
}

gcv_status gcv_scene_polygon(const gcv_scene* scene, uint64_t id, gcv_polygon** out) {
  return guarded([&] {
    require(scene, "scene");
    require(out, "out");
    *out = gcv::capi::new_polygon(scene->scene.member(id).polygon);
  });
}
