// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What regions are made of, for a pair of the catalogue.
#pragma once

#include <cstddef>
#include <vector>

#include "catalogue.hpp"
#include "handles.hpp"

namespace gcv::hard {

// Pairs are meant for no-fit polygons: b is the reflection of a polygon that moves. Where that goes
// into a as a container, an eighth of it may go too.
struct RegionOperands {
  explicit RegionOperands(const Pair& pair);

  invariants::PolygonHandle a;
  invariants::PolygonHandle b;
  // The reflection of b, and an eighth of it where doubles can show that.
  std::vector<invariants::PolygonHandle> moving;
  // A block with a as its hole, so large that it goes into no pocket of a moving polygon. NULL
  // where doubles end before.
  invariants::PolygonHandle frame;
};

// Pairs with at most 50,000 sums of two vertices: about as many as given, evenly spread.
Pairs region_pairs(const Pairs& pairs, std::size_t count);

}  // namespace gcv::hard
