// SPDX-License-Identifier: LGPL-3.0-or-later
//
// From the exact ring to a ring of doubles.
#pragma once

#include <vector>

#include "exact_ring.hpp"

namespace gcv {

struct RoundedRing {
  std::vector<Point> vertices;
  // No point of either ring is further than this from the other ring.
  double error_bound = 0;
};

// Each coordinate is the nearest double, ties to even. Throws Error: range, where one is
// not finite, or where the rounded ring is not simple.
RoundedRing round_to_nearest(const ExactRing& ring, Tally& tally);

}  // namespace gcv
