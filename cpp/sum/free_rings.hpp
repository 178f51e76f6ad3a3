// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Rings of a free set, made canonical. Its faces can have several rings, and a ring that was walked
// can visit a point twice: where solids make islands, and these touch.
#pragma once

#include <vector>

#include "contributing_vertices.hpp"
#include "exact_ring.hpp"
#include "tally.hpp"

namespace gcv {

// A ring of a face and what it is: the outer one, or that of an island.
struct FreePolygon {
  std::vector<RingVertex> outer;
  std::vector<std::vector<RingVertex>> holes;
};

// The polygons of rings with the free side on the right. In canonical order. Rings are cut where
// they visit a point twice, if `cut`.
std::vector<FreePolygon> free_polygons(const Operands& operands,
                                       std::vector<std::vector<RingVertex>> rings, bool cut,
                                       Tally& tally);

}  // namespace gcv
