// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "polygon_pair.hpp"

namespace gcv {

// Does the interior of A hold the first vertex of B, where it is? And that of B the first vertex of
// A? The vertex must not lie on the boundary. O(log n) and the edges that a horizontal ray crosses.
bool a_holds_b(const PlacedPair& placed, Tally& tally);
bool b_holds_a(const PlacedPair& placed, Tally& tally);

}  // namespace gcv
