// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_minkowski_sum, gcv_no_fit_polygon, gcv_entrance_block and gcv_minkowski_sum_many.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "batch.hpp"
#include "error.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "handles.hpp"
#include "minkowski_sum.hpp"
#include "options.hpp"
#include "task.hpp"

namespace {

using gcv::Error;
using gcv::Operand;
using gcv::Point;
using gcv::Status;
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

Point read_reference(const double reference[2], const char* name) {
  require(reference, name);
  const Point point{reference[0], reference[1]};
  if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
    throw Error(Status::not_finite, "%s: the %s coordinate is %g, not a finite number", name,
                std::isfinite(point.x) ? "y" : "x", std::isfinite(point.x) ? point.y : point.x);
  }
  return {point.x + 0.0, point.y + 0.0};
}

Operand operand(const gcv_polygon* polygon, const char* name) {
  return {polygon->outer_ring(), name};
}

Operand reflected_operand(const gcv_polygon* polygon, const char* name) {
  return {polygon->reflected_outer_ring(), name};
}

std::vector<gcv::OperandPair> read_pairs(const gcv_polygon* const* a, const gcv_polygon* const* b,
                                         std::size_t count) {
  const auto prepared = [](const gcv_polygon* polygon) {
    return polygon == nullptr ? nullptr : polygon->outer_ring();
  };
  std::vector<gcv::OperandPair> pairs(count);
  std::transform(a, a + count, b, pairs.begin(),
                 [&](const gcv_polygon* first, const gcv_polygon* second) {
                   return gcv::OperandPair{prepared(first), prepared(second)};
                 });
  return pairs;
}

}  // namespace

gcv_status gcv_minkowski_sum(const gcv_polygon* a, const gcv_polygon* b, const gcv_options* options,
                             gcv_outer_face** out) {
  return guarded([&] {
    require(a, "a");
    require(b, "b");
    require(out, "out");
    const gcv_options known = read_options(options);
    *out = new_outer_face(operand(a, "a"), operand(b, "b"), {0, 0}, known);
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
    const Point shift = read_reference(reference, "reference");
    *out =
        new_outer_face(operand(fixed, "fixed"), reflected_operand(moving, "moving"), shift, known);
  });
}

gcv_status gcv_entrance_block(const gcv_polygon* a, const gcv_polygon* b, const double a0[2],
                              const gcv_options* options, gcv_outer_face** out) {
  return guarded([&] {
    require(a, "a");
    require(b, "b");
    require(out, "out");
    const gcv_options known = read_options(options);
    const Point shift = read_reference(a0, "a0");
    *out = new_outer_face(reflected_operand(a, "a"), operand(b, "b"), shift, known);
  });
}

gcv_status gcv_minkowski_sum_many(const gcv_polygon* const* a, const gcv_polygon* const* b,
                                  size_t count, const gcv_options* options, gcv_outer_face** out,
                                  gcv_status* statuses) {
  return guarded([&] {
    if (count == 0) {
      return;
    }
    require(a, "a");
    require(b, "b");
    require(out, "out");
    require(statuses, "statuses");
    const gcv_options known = read_options(options);
    gcv::Task task(1, known.progress, known.progress_context);
    std::vector<std::unique_ptr<gcv_outer_face>> faces(count);
    const gcv::BatchReport report = gcv::minkowski_sums(
        read_pairs(a, b, count), gcv::capi::sum_options(known), threads_of(known), task,
        [&](std::size_t k, gcv::OuterFace&& face) {
          faces[k] = std::make_unique<gcv_outer_face>(gcv_outer_face{std::move(face)});
        });
    if (report.first_failure) {
      static_cast<void>(gcv::capi::record(*report.first_failure));
    }
    std::transform(faces.begin(), faces.end(), out,
                   [](std::unique_ptr<gcv_outer_face>& face) { return face.release(); });
    std::transform(report.statuses.begin(), report.statuses.end(), statuses,
                   [](Status status) { return static_cast<gcv_status>(status); });
  });
}
