// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The contents of the opaque handles of gcv.h.
#pragma once

#include <cassert>
#include <memory>
#include <utility>
#include <vector>

#include "gcv/gcv.h"
#include "lazy.hpp"
#include "minkowski_sum.hpp"
#include "polygon.hpp"

struct gcv_polygon {
  explicit gcv_polygon(std::shared_ptr<const gcv::Polygon> prepared)
      : polygon(std::move(prepared)) {
    assert(polygon != nullptr);
  }

  // The ring that outer faces are computed from. Holes never change an outer face.
  [[nodiscard]] std::shared_ptr<const gcv::Boundary> outer_ring() const {
    return gcv::outer_ring(polygon);
  }
  // The reflection of the outer ring. Made for the first no-fit polygon that needs it, then kept.
  [[nodiscard]] std::shared_ptr<const gcv::Boundary> reflected_outer_ring() const {
    return reflected_.get([this] {
      return std::make_shared<const gcv::Boundary>(gcv::Boundary::reflected(outer_ring()));
    });
  }

  const std::shared_ptr<const gcv::Polygon> polygon;

 private:
  gcv::Lazy<std::shared_ptr<const gcv::Boundary>> reflected_;
};

struct gcv_outer_face {
  gcv::OuterFace face;
};

struct gcv_superset {
  std::vector<gcv_superset_edge> edges;
};

namespace gcv::capi {

inline gcv_edge_source public_source(const EdgeSource& source) {
  return {static_cast<std::int32_t>(source.kind), source.a, source.b};
}

// Makes a handle. The caller owns it.
gcv_polygon* new_polygon(Polygon&& polygon);

}  // namespace gcv::capi
