// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Outer faces: gcv_minkowski_sum, gcv_no_fit_polygon, gcv_entrance_block, and many at once.
#include <cstddef>
#include <memory>
#include <utility>

#include "batch.hpp"
#include "finite_point.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "handles.hpp"
#include "minkowski_sum.hpp"
#include "options.hpp"
#include "pairs.hpp"
#include "task.hpp"

namespace {

using gcv::finite_point;
using gcv::Operand;
using gcv::Point;
using gcv::capi::guarded;
using gcv::capi::read_options;
using gcv::capi::require;
using gcv::capi::threads_of;

// The outer face of a + b + shift.
gcv_outer_face* new_outer_face(const Operand& a, const Operand& b, const Point& shift,
                               const gcv_options& options) {
  gcv::Task task(threads_of(options), options.progress, options.progress_context);
  return new gcv_outer_face{gcv::minkowski_sum(a, b, shift, gcv::capi::sum_options(options), task)};
}

Operand ring_operand(const gcv_polygon* polygon, const char* name) {
  return {polygon->outer_ring(), name};
}

Operand reflected_ring_operand(const gcv_polygon* polygon, const char* name) {
  return {polygon->reflected_outer_ring(), name};
}

using RingPairs = gcv::capi::CallersPairs<gcv::Boundary>;

void give_outer_faces(const RingPairs& pairs, const gcv_options* options, gcv_outer_face** out,
                      gcv_status* statuses) {
  give_many(pairs, options, out, statuses,
            [&](const auto& rings, const gcv_options& known, gcv::Task& task, auto& faces) {
              return gcv::minkowski_sums(
                  rings, pairs.names(), gcv::capi::sum_options(known), threads_of(known), task,
                  [&](std::size_t k, gcv::OuterFace&& face) {
                    faces[k] = std::make_unique<gcv_outer_face>(gcv_outer_face{std::move(face)});
                  });
            });
}

}  // namespace

gcv_status gcv_minkowski_sum(const gcv_polygon* a, const gcv_polygon* b, const gcv_options* options,
                             gcv_outer_face** out) {
  return guarded([&] {
    require(a, "a");
    require(b, "b");
    require(out, "out");
    const gcv_options known = read_options(options);
    *out = new_outer_face(ring_operand(a, "a"), ring_operand(b, "b"), {0, 0}, known);
  });
}

gcv_status gcv_no_fit_polygon(const gcv_polygon* fixed, const gcv_polygon* moving,
                              const double reference[2], const gcv_options* options,
                              gcv_outer_face** out) {
  return guarded([&] {
    require(fixed, "fixed");
    require(moving, "moving");
    require(out, "out");
    const gcv_options known = read_options(options);
    require(reference, "reference");
    const Point shift = finite_point({reference[0], reference[1]}, "reference");
    *out = new_outer_face(ring_operand(fixed, "fixed"), reflected_ring_operand(moving, "moving"),
                          shift, known);
  });
}

gcv_status gcv_entrance_block(const gcv_polygon* a, const gcv_polygon* b, const double a0[2],
                              const gcv_options* options, gcv_outer_face** out) {
  return guarded([&] {
    require(a, "a");
    require(b, "b");
    require(out, "out");
    const gcv_options known = read_options(options);
    require(a0, "a0");
    const Point shift = finite_point({a0[0], a0[1]}, "a0");
    *out = new_outer_face(reflected_ring_operand(a, "a"), ring_operand(b, "b"), shift, known);
  });
}

gcv_status gcv_minkowski_sum_many(const gcv_polygon* const* a, const gcv_polygon* const* b,
                                  size_t count, const gcv_options* options, gcv_outer_face** out,
                                  gcv_status* statuses) {
  return guarded([&] {
    const RingPairs pairs{
        a, &gcv_polygon::outer_ring, b, &gcv_polygon::outer_ring, nullptr, count, false};
    give_outer_faces(pairs, options, out, statuses);
  });
}

gcv_status gcv_no_fit_polygon_many(const gcv_polygon* const* fixed,
                                   const gcv_polygon* const* moving, const double* references,
                                   size_t count, const gcv_options* options, gcv_outer_face** out,
                                   gcv_status* statuses) {
  return guarded([&] {
    const RingPairs pairs{fixed,      &gcv_polygon::outer_ring,
                          moving,     &gcv_polygon::reflected_outer_ring,
                          references, count,
                          true};
    give_outer_faces(pairs, options, out, statuses);
  });
}
