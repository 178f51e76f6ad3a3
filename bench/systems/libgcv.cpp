// SPDX-License-Identifier: LGPL-3.0-or-later
#include <dlfcn.h>
#include <gcv/gcv.h>

#include <memory>
#include <stdexcept>

#include "system.hpp"

namespace gcv::bench {

namespace {

// The functions of one build of the library. All builds have the same names, so each is
// loaded apart.
struct Library {
  decltype(&gcv_last_error_message) last_error_message;
  decltype(&gcv_polygon_create) polygon_create;
  decltype(&gcv_polygon_simplified) polygon_simplified;
  decltype(&gcv_polygon_destroy) polygon_destroy;
  decltype(&gcv_minkowski_sum) minkowski_sum;
  decltype(&gcv_outer_face_exact_vertex_count) exact_vertex_count;
  decltype(&gcv_outer_face_error_bound) error_bound;
  decltype(&gcv_outer_face_vertex_count) vertex_count;
  decltype(&gcv_outer_face_vertices) vertices;
  decltype(&gcv_outer_face_destroy) outer_face_destroy;

  void check(gcv_status status) const {
    if (status != GCV_OK) {
      throw std::runtime_error(last_error_message());
    }
  }
};

template <class Function>
void find(void* handle, const char* name, Function*& function) {
  function = reinterpret_cast<Function*>(dlsym(handle, name));
  if (function == nullptr) {
    throw std::runtime_error(dlerror());
  }
}

Library load(const char* file) {
  void* const handle = dlopen(file, RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    throw std::runtime_error(dlerror());
  }
  Library library{};
  find(handle, "gcv_last_error_message", library.last_error_message);
  find(handle, "gcv_polygon_create", library.polygon_create);
  find(handle, "gcv_polygon_simplified", library.polygon_simplified);
  find(handle, "gcv_polygon_destroy", library.polygon_destroy);
  find(handle, "gcv_minkowski_sum", library.minkowski_sum);
  find(handle, "gcv_outer_face_exact_vertex_count", library.exact_vertex_count);
  find(handle, "gcv_outer_face_error_bound", library.error_bound);
  find(handle, "gcv_outer_face_vertex_count", library.vertex_count);
  find(handle, "gcv_outer_face_vertices", library.vertices);
  find(handle, "gcv_outer_face_destroy", library.outer_face_destroy);
  return library;
}

using PolygonHandle = std::shared_ptr<gcv_polygon>;

PolygonHandle make_handle(const Library& library, const Ring& ring) {
  gcv_polygon* polygon = nullptr;
  library.check(library.polygon_create(&ring.data()->x, ring.size(), 0, &polygon));
  return {polygon, library.polygon_destroy};
}

// The polygon within half of the tolerance.
PolygonHandle make_simplified(const Library& library, const Ring& ring,
                              const gcv_options& options) {
  const PolygonHandle polygon = make_handle(library, ring);
  gcv_polygon* simplified = nullptr;
  double bound = 0;
  library.check(library.polygon_simplified(polygon.get(), options.tolerance / 2, options.rounding,
                                           &simplified, &bound));
  return {simplified, library.polygon_destroy};
}

gcv_options options_of(Precision precision) {
  gcv_options options = GCV_OPTIONS_INIT;
  options.rounding = precision.outward ? GCV_ROUND_OUTWARD : GCV_ROUND_NEAREST;
  options.tolerance = precision.tolerance;
  return options;
}

Ring sum(const Library& library, const gcv_polygon* a, const gcv_polygon* b,
         const gcv_options& options, Observation& observation) {
  gcv_outer_face* sum = nullptr;
  library.check(library.minkowski_sum(a, b, &options, &sum));
  const std::unique_ptr<gcv_outer_face, decltype(&gcv_outer_face_destroy)> face(
      sum, library.outer_face_destroy);
  library.check(library.exact_vertex_count(sum, &observation.exact_vertices));
  library.check(library.error_bound(sum, &observation.error_bound));
  std::size_t count = 0;
  library.check(library.vertex_count(sum, &count));
  Ring ring(count);
  library.check(library.vertices(sum, &ring.data()->x, count, &count));
  return ring;
}

}  // namespace

Prepare libgcv_cold(const char* library, Precision precision) {
  return [lib = load(library), options = options_of(precision)](const Ring& a, const Ring& b) {
    auto observation = std::make_shared<Observation>();
    return Job{[lib, options, &a, &b, observation] {
                 const PolygonHandle p = make_handle(lib, a);
                 const PolygonHandle q = make_handle(lib, b);
                 return sum(lib, p.get(), q.get(), options, *observation);
               },
               [observation] { return *observation; }};
  };
}

Prepare libgcv_prepared(const char* library, Precision precision) {
  return [lib = load(library), options = options_of(precision)](const Ring& a, const Ring& b) {
    auto observation = std::make_shared<Observation>();
    const PolygonHandle p = make_simplified(lib, a, options);
    const PolygonHandle q = make_simplified(lib, b, options);
    gcv_options rounding_alone = options;
    rounding_alone.tolerance = 0;
    return Job{[lib, rounding_alone, p, q, observation] {
                 return sum(lib, p.get(), q.get(), rounding_alone, *observation);
               },
               [observation] { return *observation; }};
  };
}

}  // namespace gcv::bench
