// SPDX-License-Identifier: LGPL-3.0-or-later
#include "region_operands.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace gcv::hard {

namespace {

using invariants::Point;
using invariants::PolygonHandle;

PolygonHandle scaled(const gcv_polygon* polygon, double factor) {
  const double map[6] = {factor, 0, 0, 0, factor, 0};
  gcv_polygon* out = nullptr;
  return PolygonHandle(gcv_polygon_affine(polygon, map, &out) == GCV_OK ? out : nullptr);
}

// The extents of both polygons between the boundary of the hole and that of the block, and more.
PolygonHandle frame_of(const Polygon& a, const gcv_polygon* handle_a, const gcv_polygon* b) {
  double box[4];
  double of_b[4];
  invariants::require(gcv_polygon_bounds(handle_a, box), "the bounds");
  invariants::require(gcv_polygon_bounds(b, of_b), "the bounds");
  const double margin = std::max({box[2] - box[0], box[3] - box[1], of_b[2] - of_b[0],
                                  of_b[3] - of_b[1], std::abs(box[0]), std::abs(box[1])});
  const double x0 = box[0] - margin;
  const double y0 = box[1] - margin;
  const double x1 = box[2] + margin;
  const double y1 = box[3] + margin;
  Polygon rings{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  rings.insert(rings.end(), a.begin(), a.end());
  const std::size_t sizes[2] = {4, a.size()};
  gcv_polygon* out = nullptr;
  const gcv_status status = gcv_polygon_create_rings(rings.front().data(), sizes, 2, 0, &out);
  return PolygonHandle(status == GCV_OK ? out : nullptr);
}

}  // namespace

RegionOperands::RegionOperands(const Pair& pair)
    : a(invariants::make(pair.a)),
      b(invariants::make(pair.b)),
      frame(frame_of(pair.a, a.get(), b.get())) {
  for (const double factor : {-1.0, -0.125}) {
    PolygonHandle polygon = scaled(b.get(), factor);
    if (polygon != nullptr) {
      moving.push_back(std::move(polygon));
    }
  }
}

Pairs region_pairs(const Pairs& pairs) {
  constexpr std::size_t most_sums = 50000;
  constexpr std::size_t most_pairs = 40;
  Pairs small;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(small),
               [](const Pair& pair) { return pair.a.size() * pair.b.size() <= most_sums; });
  const std::size_t step = small.size() / most_pairs + 1;
  Pairs spread;
  for (std::size_t k = 0; k < small.size(); k += step) {
    spread.push_back(small[k]);
  }
  return spread;
}

}  // namespace gcv::hard
