// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_superset_*: the explicit superset.
#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "fill.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "handles.hpp"
#include "minkowski_sum.hpp"

using gcv::capi::fill;
using gcv::capi::guarded;
using gcv::capi::require;

gcv_status gcv_superset_create(const gcv_polygon* a, const gcv_polygon* b, gcv_superset** out) {
  return guarded([&] {
    require(a, "a");
    require(b, "b");
    require(out, "out");
    auto superset = std::make_unique<gcv_superset>();
    const std::vector<gcv::RoundedSupersetEdge> edges =
        gcv::rounded_superset(a->polygon->boundary(), b->polygon->boundary());
    superset->edges.resize(edges.size());  // with the bytes behind the members 0
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const auto& [from, to, source] = edges[k];
      gcv_superset_edge& edge = superset->edges[k];
      edge.x0 = from.x;
      edge.y0 = from.y;
      edge.x1 = to.x;
      edge.y1 = to.y;
      edge.source = gcv::capi::public_source(source);
    }
    *out = superset.release();
  });
}

void gcv_superset_destroy(gcv_superset* superset) { delete superset; }

gcv_status gcv_superset_edges(const gcv_superset* superset, gcv_superset_edge* out, size_t capacity,
                              size_t* required) {
  return guarded([&] {
    require(superset, "superset");
    fill(superset->edges.size(), "edges", "out", out, capacity, required,
         [&](gcv_superset_edge* to) {
           std::copy(superset->edges.begin(), superset->edges.end(), to);
         });
  });
}
