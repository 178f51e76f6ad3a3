// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A container as the hole of a polygon: what is free in both is the same.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "handles.hpp"

namespace gcv::invariants {

// A block with that hole, so large that it goes into no pocket of the other polygon; NULL where
// doubles end before.
inline PolygonHandle frame_of(const Polygon& hole, const Polygon& other) {
  double box[4];
  double of_other[4];
  require(gcv_polygon_bounds(make(hole).get(), box), "the bounds");
  require(gcv_polygon_bounds(make(other).get(), of_other), "the bounds");
  const double margin = std::max({box[2] - box[0], box[3] - box[1], of_other[2] - of_other[0],
                                  of_other[3] - of_other[1], std::abs(box[0]), std::abs(box[1])});
  const double x0 = box[0] - margin;
  const double y0 = box[1] - margin;
  const double x1 = box[2] + margin;
  const double y1 = box[3] + margin;
  Polygon rings{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  rings.insert(rings.end(), hole.begin(), hole.end());
  const std::size_t sizes[2] = {4, hole.size()};
  gcv_polygon* frame = nullptr;
  const gcv_status status = gcv_polygon_create_rings(rings.front().data(), sizes, 2, 0, &frame);
  return PolygonHandle(status == GCV_OK ? frame : nullptr);
}

}  // namespace gcv::invariants
