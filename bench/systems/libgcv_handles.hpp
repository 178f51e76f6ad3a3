// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Handles of libgcv, for the systems that use its C interface.
#pragma once

#include <gcv/gcv.h>

#include <memory>
#include <stdexcept>

#include "point.hpp"

namespace gcv::bench {

inline void check(gcv_status status) {
  if (status != GCV_OK) {
    throw std::runtime_error(gcv_last_error_message());
  }
}

struct Destroy {
  void operator()(gcv_polygon* polygon) const { gcv_polygon_destroy(polygon); }
  void operator()(gcv_outer_face* face) const { gcv_outer_face_destroy(face); }
  void operator()(gcv_region* region) const { gcv_region_destroy(region); }
  void operator()(gcv_scene* scene) const { gcv_scene_destroy(scene); }
};
template <class Handle>
using Owned = std::unique_ptr<Handle, Destroy>;

inline Owned<gcv_polygon> make_polygon(const PointVector& ring) {
  gcv_polygon* polygon = nullptr;
  check(gcv_polygon_create(&ring.data()->x, ring.size(), 0, &polygon));
  return Owned<gcv_polygon>(polygon);
}

}  // namespace gcv::bench
