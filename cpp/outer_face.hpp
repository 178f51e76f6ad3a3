// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The walk along the outer face of the sum (the paper, section 4.3, way 1), over the
// implicit superset. Every decision is exact.
#pragma once

#include <cstdint>
#include <vector>

#include "contributing_vertices.hpp"
#include "predicates.hpp"
#include "task.hpp"

namespace gcv {

// A vertex of the outer face: the sum of vertices i and j, or else the crossing of the
// edge that arrives with the edge that leaves.
struct RingVertex {
  bool is_sum;
  Index i;
  Index j;
  EdgeName arriving;  // of collinear superset edges in a row, the last
  EdgeName leaving;   // the first of them
};

// The outer face as the walk found it: counter-clockwise, from the lexicographically
// smallest vertex, without collinear vertices. Edge k leaves vertex k.
struct Walk {
  std::vector<RingVertex> vertices;
  std::uint64_t steps = 0;
  std::uint64_t candidates = 0;
  // The edges of the vertices are any of those that coincide with them (repeated_chains.hpp).
  bool chains_are_repeated = false;
};

Walk walk_outer_face(const Operands& operands, Task& task, Tally& tally);

}  // namespace gcv
