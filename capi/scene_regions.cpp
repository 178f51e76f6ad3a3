// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Free regions: gcv_scene_free_region.
#include <cmath>
#include <optional>

#include "box.hpp"
#include "error.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "handles.hpp"
#include "options.hpp"
#include "scene_queries.hpp"
#include "scene_region.hpp"
#include "task.hpp"

namespace {

using gcv::Box;
using gcv::Error;
using gcv::Status;
using gcv::Task;
using gcv::capi::guarded;
using gcv::capi::require;

std::optional<Box> read_window(const double window[4]) {
  if (window == nullptr) {
    return std::nullopt;
  }
  constexpr const char* names[4] = {"xmin", "ymin", "xmax", "ymax"};
  for (int k = 0; k < 4; ++k) {
    if (!std::isfinite(window[k])) {
      throw Error(Status::not_finite, "window: %s is %g, not a finite number", names[k], window[k]);
    }
  }
  for (int k = 0; k < 2; ++k) {
    if (!(window[k] < window[k + 2])) {
      throw Error(Status::invalid_argument, "window: %s is %.17g, not less than %s, %.17g",
                  names[k], window[k], names[k + 2], window[k + 2]);
    }
  }
  return Box{window[0] + 0.0, window[1] + 0.0, window[2] + 0.0, window[3] + 0.0};
}

}  // namespace

gcv_status gcv_scene_free_region(const gcv_scene* scene, const gcv_polygon* moving,
                                 const double window[4], const gcv_query* query,
                                 const gcv_options* options, gcv_region** out) {
  return guarded([&] {
    require(scene, "scene");
    require(moving, "moving");
    require(out, "out");
    const gcv_options known = gcv::capi::read_exact_options(options, "free regions");
    const gcv::Query asked = gcv::capi::read_query(query);
    const std::optional<Box> bounds = read_window(window);
    Task task(gcv::capi::threads_of(known), known.progress, known.progress_context);
    *out = new gcv_region(gcv::free_region(scene->scene, asked, moving->reflected(), bounds,
                                           gcv::capi::region_options(known), task));
  });
}
