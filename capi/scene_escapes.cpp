// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Free positions in a scene: gcv_scene_best, gcv_scene_penetration.
#include "error.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"

gcv_status gcv_scene_best(const gcv_scene*, const gcv_polygon*, const double[2], const gcv_query*,
                          const gcv_options*, double[2], int32_t*) {
  return gcv::capi::guarded([] { throw gcv::Error(gcv::Status::internal, "not yet"); });
}

gcv_status gcv_scene_penetration(const gcv_scene*, const gcv_polygon*, const double*, size_t,
                                 const gcv_query*, const gcv_options*, gcv_escape*) {
  return gcv::capi::guarded([] { throw gcv::Error(gcv::Status::internal, "not yet"); });
}
