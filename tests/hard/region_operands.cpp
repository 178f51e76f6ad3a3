// SPDX-License-Identifier: LGPL-3.0-or-later
#include "region_operands.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "frame.hpp"

namespace gcv::hard {

namespace {

using invariants::PolygonHandle;

PolygonHandle scaled(const gcv_polygon* polygon, double factor) {
  const double map[6] = {factor, 0, 0, 0, factor, 0};
  gcv_polygon* out = nullptr;
  return PolygonHandle(gcv_polygon_affine(polygon, map, &out) == GCV_OK ? out : nullptr);
}

}  // namespace

RegionOperands::RegionOperands(const Pair& pair)
    : a(invariants::make(pair.a)),
      b(invariants::make(pair.b)),
      frame(invariants::frame_of(pair.a, pair.b)) {
  for (const double factor : {-1.0, -0.125}) {
    PolygonHandle polygon = scaled(b.get(), factor);
    if (polygon != nullptr) {
      moving.push_back(std::move(polygon));
    }
  }
}

Pairs region_pairs(const Pairs& pairs, std::size_t count) {
  constexpr std::size_t most_sums = 50000;
  Pairs small;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(small),
               [](const Pair& pair) { return pair.a.size() * pair.b.size() <= most_sums; });
  const std::size_t step = small.size() / count + 1;
  Pairs spread;
  for (std::size_t k = 0; k < small.size(); k += step) {
    spread.push_back(small[k]);
  }
  return spread;
}

}  // namespace gcv::hard
