// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Finds where rings of doubles do what the rings of a region must not.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "point.hpp"

namespace gcv {

// An edge of a ring: from vertex `edge` to the next one.
struct RingEdge {
  std::size_t ring;
  std::size_t edge;
};

struct RingConflict {
  RingEdge first;
  RingEdge second;
};

// Two edges of one ring that meet, and are not neighbours; and two edges of different rings that
// cross or overlap, or touch where the rings cross. Rings may touch in points. No ring has equal
// neighbours. The order of the result depends on the rings alone. Uses bounding volume hierarchies:
// fast if few edges are near each other.
std::vector<RingConflict> find_ring_conflicts(std::span<const PointVector> rings);

// Are edges of two rings within that distance of each other, in both coordinates? Maybe also where
// they are up to two times as far apart.
bool are_rings_near(std::span<const PointVector> rings, double distance);

}  // namespace gcv
