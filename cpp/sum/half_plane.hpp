// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Half a plane of directions is enough. The edges of a ring add up to zero, so every ring has an
// edge strictly inside any open half-plane of directions. The superset edges through an isolated
// point turn all the way round it. A segment lies on superset edges of both of its directions: so
// one of the two directions of the border is taken as well.
#pragma once

#include "contributing_vertices.hpp"

namespace gcv {

// The first rank of the half-plane that holds the fewest superset edges: from that on
// counter-clockwise, without the opposite rank. O(n + m + K).
Rank cheapest_half_plane(const Operands& operands);

}  // namespace gcv
