// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The C interface for tests: handles that end by themselves, failures as exceptions.
#pragma once

#include <gcv/gcv.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "invariants.hpp"

namespace gcv::invariants {

struct Destroy {
  void operator()(gcv_polygon* polygon) const { gcv_polygon_destroy(polygon); }
  void operator()(gcv_outer_face* face) const { gcv_outer_face_destroy(face); }
  void operator()(gcv_region* region) const { gcv_region_destroy(region); }
  void operator()(gcv_scene* scene) const { gcv_scene_destroy(scene); }
  void operator()(gcv_pair_list* list) const { gcv_pair_list_destroy(list); }
  void operator()(gcv_contact_list* list) const { gcv_contact_list_destroy(list); }
};

using PolygonHandle = std::unique_ptr<gcv_polygon, Destroy>;
using SceneHandle = std::unique_ptr<gcv_scene, Destroy>;
using PairListHandle = std::unique_ptr<gcv_pair_list, Destroy>;
using ContactListHandle = std::unique_ptr<gcv_contact_list, Destroy>;

// Failures of the library that end a check.
struct Failure : std::runtime_error {
  Failure(gcv_status code, const std::string& what)
      : std::runtime_error(what + ": " + gcv_status_name(code) + ", " + gcv_last_error_message()),
        status(code) {}
  gcv_status status;
};

inline void require(gcv_status status, const char* what) {
  if (status != GCV_OK) {
    throw Failure(status, what);
  }
}

template <typename Handle>
Polygon vertices(gcv_status (*get)(const Handle*, double*, std::size_t, std::size_t*),
                 const Handle* handle) {
  std::size_t count = 0;
  require(get(handle, nullptr, 0, &count), "the number of vertices");
  Polygon polygon(count);
  require(get(handle, polygon.front().data(), count, &count), "the vertices");
  return polygon;
}

inline PolygonHandle make(const Polygon& polygon) {
  gcv_polygon* handle = nullptr;
  const double* const xy = polygon.empty() ? nullptr : polygon.front().data();
  require(gcv_polygon_create(xy, polygon.size(), 0, &handle), "a polygon");
  return PolygonHandle(handle);
}

// get(list, out, capacity, &required) fills a buffer.
template <typename Element, typename Handle>
std::vector<Element> elements(gcv_status (*get)(const Handle*, Element*, std::size_t, std::size_t*),
                              const Handle* handle) {
  std::size_t count = 0;
  require(get(handle, nullptr, 0, &count), "the number of elements");
  std::vector<Element> result(count);
  if (count > 0) {
    require(get(handle, result.data(), count, &count), "the elements");
  }
  return result;
}

inline bool all_finite(const Polygon& polygon) {
  return std::all_of(polygon.begin(), polygon.end(),
                     [](const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]); });
}

}  // namespace gcv::invariants
