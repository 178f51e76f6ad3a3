// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_outer_face_*: reads results from an outer face.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "area.hpp"
#include "edge_sources.hpp"
#include "error.hpp"
#include "exact_indices.hpp"
#include "fill.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "handles.hpp"
#include "ring_predicates.hpp"
#include "stats.hpp"
#include "wkt.hpp"

using gcv::Error;
using gcv::Status;
using gcv::capi::CallersFloatingPoint;
using gcv::capi::fill;
using gcv::capi::fill_points;
using gcv::capi::fill_text;
using gcv::capi::give_finite;
using gcv::capi::guarded;
using gcv::capi::require;

void gcv_outer_face_destroy(gcv_outer_face* face) { delete face; }

gcv_status gcv_outer_face_vertex_count(const gcv_outer_face* face, size_t* out) {
  return guarded<CallersFloatingPoint>([&] {
    require(face, "face");
    require(out, "out");
    *out = face->face.rounded.vertices.size();
  });
}

gcv_status gcv_outer_face_vertices(const gcv_outer_face* face, double* xy, size_t capacity,
                                   size_t* required) {
  return guarded<CallersFloatingPoint>([&] {
    require(face, "face");
    fill_points(face->face.rounded.vertices, xy, capacity, required);
  });
}

gcv_status gcv_outer_face_exact_vertex_count(const gcv_outer_face* face, size_t* out) {
  return guarded<CallersFloatingPoint>([&] {
    require(face, "face");
    require(out, "out");
    *out = face->face.exact.size();
  });
}

gcv_status gcv_outer_face_exact_vertex(const gcv_outer_face* face, size_t index, char* text,
                                       size_t capacity, size_t* required) {
  return guarded([&] {
    require(face, "face");
    if (index >= face->face.exact.size()) {
      throw Error(Status::invalid_argument, "index is %zu, the exact ring has %zu vertices", index,
                  face->face.exact.size());
    }
    fill_text(gcv::exact_vertex(face->face.exact, index), text, capacity, required);
  });
}

gcv_status gcv_outer_face_edge_sources(const gcv_outer_face* face, gcv_edge_source* out,
                                       size_t capacity, size_t* required) {
  return guarded([&] {
    require(face, "face");
    fill(face->face.exact.size(), "edges", "out", out, capacity, required,
         [&](gcv_edge_source* to) {
           const std::vector<gcv::EdgeSource> sources = gcv::edge_sources(face->face.exact);
           std::transform(sources.begin(), sources.end(), to, gcv::capi::public_source);
         });
  });
}

gcv_status gcv_outer_face_exact_indices(const gcv_outer_face* face, uint64_t* out, size_t capacity,
                                        size_t* required) {
  return guarded([&] {
    require(face, "face");
    fill(face->face.rounded.vertices.size(), "indices", "out", out, capacity, required,
         [&](std::uint64_t* to) {
           const std::vector<std::uint64_t> indices =
               gcv::exact_indices(face->face.exact, face->face.rounded);
           std::copy(indices.begin(), indices.end(), to);
         });
  });
}

gcv_status gcv_outer_face_error_bound(const gcv_outer_face* face, double* out) {
  return guarded<CallersFloatingPoint>([&] {
    require(face, "face");
    require(out, "out");
    *out = face->face.rounded.error_bound;
  });
}

gcv_status gcv_outer_face_area(const gcv_outer_face* face, double* out) {
  return guarded([&] {
    require(face, "face");
    require(out, "out");
    give_finite(gcv::ring_area(face->face.rounded.vertices), "the area of the outer face", out);
  });
}

gcv_status gcv_outer_face_wkt(const gcv_outer_face* face, char* text, size_t capacity,
                              size_t* required) {
  return guarded([&] {
    require(face, "face");
    fill_text(gcv::format_polygon(face->face.rounded.vertices), text, capacity, required);
  });
}

gcv_status gcv_outer_face_polygon(const gcv_outer_face* face, gcv_polygon** out) {
  return guarded([&] {
    require(face, "face");
    require(out, "out");
    *out = gcv::capi::new_polygon(
        std::make_shared<const gcv::Polygon>(face->face.rounded.vertices, "polygon"));
  });
}

gcv_status gcv_outer_face_stats(const gcv_outer_face* face, gcv_stats* out) {
  return guarded<CallersFloatingPoint>([&] {
    require(face, "face");
    require(out, "out");
    gcv::capi::give_stats(face->face.counts, face->face.rounded.vertices_repaired, 0, out);
  });
}
