// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Regions: gcv_minkowski_sum_region, gcv_no_fit_region, gcv_entrance_region, gcv_inner_fit_region,
// and many at once.
#include <cstddef>
#include <memory>
#include <utility>

#include "batch.hpp"
#include "finite_point.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "handles.hpp"
#include "minkowski_region.hpp"
#include "options.hpp"
#include "pairs.hpp"
#include "task.hpp"

namespace {

using gcv::finite_point;
using gcv::Point;
using gcv::RegionOperand;
using gcv::Task;
using gcv::capi::guarded;
using gcv::capi::read_options;
using gcv::capi::region_options;
using gcv::capi::require;
using gcv::capi::threads_of;

// The region of a + b + shift.
gcv_region* new_region(const RegionOperand& a, const RegionOperand& b, const Point& shift,
                       const gcv_options& options) {
  Task task(threads_of(options), options.progress, options.progress_context);
  return new gcv_region(gcv::minkowski_sum_region(a, b, shift, region_options(options), task));
}

RegionOperand operand(const gcv_polygon* polygon, const char* name) {
  return {polygon->polygon, name};
}

RegionOperand reflected_operand(const gcv_polygon* polygon, const char* name) {
  return {polygon->reflected(), name};
}

using Pairs = gcv::capi::CallersPairs<gcv::Polygon>;

void give_regions(const Pairs& pairs, const gcv_options* options, gcv_region** out,
                  gcv_status* statuses) {
  give_many(pairs, options, out, statuses,
            [&](const auto& polygons, const gcv_options& known, Task& task, auto& regions) {
              return gcv::minkowski_sum_regions(
                  polygons, pairs.names(), region_options(known), threads_of(known), task,
                  [&](std::size_t k, gcv::Region&& region) {
                    regions[k] = std::make_unique<gcv_region>(std::move(region));
                  });
            });
}

}  // namespace

gcv_status gcv_minkowski_sum_region(const gcv_polygon* a, const gcv_polygon* b,
                                    const gcv_options* options, gcv_region** out) {
  return guarded([&] {
    require(a, "a");
    require(b, "b");
    require(out, "out");
    const gcv_options known = read_options(options);
    *out = new_region(operand(a, "a"), operand(b, "b"), {0, 0}, known);
  });
}

gcv_status gcv_no_fit_region(const gcv_polygon* fixed, const gcv_polygon* moving,
                             const double reference[2], const gcv_options* options,
                             gcv_region** out) {
  return guarded([&] {
    require(fixed, "fixed");
    require(moving, "moving");
    require(out, "out");
    const gcv_options known = read_options(options);
    require(reference, "reference");
    const Point shift = finite_point({reference[0], reference[1]}, "reference");
    *out = new_region(operand(fixed, "fixed"), reflected_operand(moving, "moving"), shift, known);
  });
}

gcv_status gcv_entrance_region(const gcv_polygon* a, const gcv_polygon* b, const double a0[2],
                               const gcv_options* options, gcv_region** out) {
  return guarded([&] {
    require(a, "a");
    require(b, "b");
    require(out, "out");
    const gcv_options known = read_options(options);
    require(a0, "a0");
    const Point shift = finite_point({a0[0], a0[1]}, "a0");
    *out = new_region(reflected_operand(a, "a"), operand(b, "b"), shift, known);
  });
}

gcv_status gcv_inner_fit_region(const gcv_polygon* container, const gcv_polygon* moving,
                                const double reference[2], const gcv_options* options,
                                gcv_region** out) {
  return guarded([&] {
    require(container, "container");
    require(moving, "moving");
    require(out, "out");
    const gcv_options known = gcv::capi::read_exact_options(options, "inner fits");
    require(reference, "reference");
    const Point shift = finite_point({reference[0], reference[1]}, "reference");
    Task task(threads_of(known), known.progress, known.progress_context);
    *out = new gcv_region(gcv::inner_fit_region(operand(container, "container"),
                                                reflected_operand(moving, "moving"), shift,
                                                region_options(known), task));
  });
}

gcv_status gcv_minkowski_sum_region_many(const gcv_polygon* const* a, const gcv_polygon* const* b,
                                         size_t count, const gcv_options* options, gcv_region** out,
                                         gcv_status* statuses) {
  return guarded([&] {
    const Pairs pairs{a, &gcv_polygon::whole, b, &gcv_polygon::whole, nullptr, count, false};
    give_regions(pairs, options, out, statuses);
  });
}

gcv_status gcv_no_fit_region_many(const gcv_polygon* const* fixed, const gcv_polygon* const* moving,
                                  const double* references, size_t count,
                                  const gcv_options* options, gcv_region** out,
                                  gcv_status* statuses) {
  return guarded([&] {
    const Pairs pairs{
        fixed, &gcv_polygon::whole, moving, &gcv_polygon::reflected, references, count, true};
    give_regions(pairs, options, out, statuses);
  });
}
