// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Rounding outward: a ring of doubles whose region contains the exact one.
#pragma once

#include "exact_ring.hpp"
#include "rounding.hpp"

namespace gcv {

// A simple ring of doubles around the exact ring, a few units in the last place of its
// largest coordinate away. Slits thinner than that close; what lies behind them is then
// inside, and counts in the error bound. Throws as place_nearest.
RoundedRing round_outward(const ExactRing& ring, Task& task, Tally& tally);

}  // namespace gcv
