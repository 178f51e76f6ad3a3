// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "exact_ring.hpp"
#include "tally.hpp"

namespace gcv {

// The outer face as the walk found it: counter-clockwise, from the lexicographically
// smallest vertex, without collinear vertices. Edge k leaves vertex k.
struct Walk {
  std::vector<RingVertex> vertices;
  std::uint64_t steps = 0;
  std::uint64_t candidates = 0;
  // The edges of the vertices are any of those that coincide with them (equal_chains.hpp).
  bool chains_are_repeated = false;
};

// A walk from one vertex of the hull of the sum to the next, and the edge that it arrived by.
struct Arc {
  Walk walk;
  EdgeName last;
  Tally tally;
};

}  // namespace gcv
