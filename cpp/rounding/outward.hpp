// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Rounding outward: a ring of doubles whose inside contains the exact ring.
#pragma once

#include <functional>
#include <vector>

#include "exact_ring.hpp"
#include "rounding.hpp"

namespace gcv {

// Computes the outer face of the sum of two polygons. A parameter, because this room is below the
// sums.
using OuterFaceOf = std::function<std::vector<RingVertex>(const Boundary& a, const Boundary& b)>;

// A simple ring of doubles around the exact ring. It is a few units in the last place of the
// largest coordinate away. Thinner slits close. What lies behind them is then inside, and counts in
// the error bound. Its first rounding is so many parts of the task. Throws as place_nearest.
RoundedRing round_outward(const ExactRing& ring, const OuterFaceOf& outer_face_of, Task& task,
                          Tally& tally, std::uint64_t parts = 0);

}  // namespace gcv
