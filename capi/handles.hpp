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
#include "locate.hpp"
#include "minkowski_region.hpp"
#include "minkowski_sum.hpp"
#include "polygon.hpp"
#include "scene.hpp"
#include "scene_contacts.hpp"
#include "scene_pairs.hpp"

struct gcv_polygon {
  explicit gcv_polygon(std::shared_ptr<const gcv::Polygon> prepared)
      : polygon(std::move(prepared)) {
    assert(polygon != nullptr);
  }

  // What regions are computed from.
  [[nodiscard]] std::shared_ptr<const gcv::Polygon> whole() const { return polygon; }
  // The ring that outer faces are computed from. Holes never change an outer face.
  [[nodiscard]] std::shared_ptr<const gcv::Boundary> outer_ring() const {
    return gcv::outer_ring(polygon);
  }
  // The reflection. Made for the first no-fit polygon or region that needs it, then kept.
  [[nodiscard]] std::shared_ptr<const gcv::Polygon> reflected() const {
    return reflected_.get(
        [this] { return std::make_shared<const gcv::Polygon>(gcv::Polygon::reflected(polygon)); });
  }
  [[nodiscard]] std::shared_ptr<const gcv::Boundary> reflected_outer_ring() const {
    return gcv::outer_ring(reflected());
  }

  const std::shared_ptr<const gcv::Polygon> polygon;

 private:
  gcv::Lazy<std::shared_ptr<const gcv::Polygon>> reflected_;
};

struct gcv_outer_face {
  gcv::OuterFace face;
};

struct gcv_region {
  explicit gcv_region(gcv::Region computed) : region(std::move(computed)) {}

  // Made for the first points that are located, then kept.
  [[nodiscard]] const gcv::RegionLocator& locator() const {
    return *locator_.get(
        [this] { return std::make_unique<const gcv::RegionLocator>(region.exact); });
  }

  const gcv::Region region;

 private:
  gcv::Lazy<std::unique_ptr<const gcv::RegionLocator>> locator_;
};

struct gcv_superset {
  std::vector<gcv_superset_edge> edges;
};

struct gcv_contact_list {
  explicit gcv_contact_list(gcv::SceneContactList found) : list(std::move(found)) {}

  const gcv::SceneContactList list;
};

struct gcv_pair_list {
  explicit gcv_pair_list(gcv::PairList found) : list(std::move(found)) {}

  const gcv::PairList list;
};

struct gcv_scene {
  gcv::Scene scene;
};

namespace gcv::capi {

inline gcv_edge_source public_source(const EdgeSource& source) {
  return {static_cast<std::int32_t>(source.kind), source.a, source.b};
}

// Makes a handle. The caller owns it.
gcv_polygon* new_polygon(Polygon&& polygon);
// The new handle shares the polygon.
gcv_polygon* new_polygon(std::shared_ptr<const Polygon> polygon);

}  // namespace gcv::capi
