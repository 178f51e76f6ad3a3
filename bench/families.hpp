// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The families of pairs that bench/positions places in many ways.
#pragma once

#include <vector>

#include "sets.hpp"

namespace gcv::bench {

// Those of data only where the data is; tiny pairs on demand. A quick run has fewer and smaller
// pairs.
std::vector<Set> families(bool quick);

// Two coasts of n vertices each; another pair for every seed.
Rings reference_coasts(int n, int seed);

}  // namespace gcv::bench
