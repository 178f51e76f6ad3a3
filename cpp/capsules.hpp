// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Tighter bounds than boxes for the nodes of a tree over a boundary chain: where two chains
// slide along each other, their boxes overlap long before they do.
#pragma once

#include <span>
#include <vector>

#include "chain_tree.hpp"
#include "point.hpp"

namespace gcv {

// The chains of edges below the children of one node, from each vertex (x, y) to the next: no
// point of a chain is further than its radius from the segment between its ends.
struct CapsuleBlock {
  double x[ChainTree::width + 1];
  double y[ChainTree::width + 1];
  double radius[ChainTree::width];
};

// The capsules for the blocks of the tree over that ring. O(n log n).
std::vector<CapsuleBlock> build_capsules(const ChainTree& tree, std::span<const Point> ring);

}  // namespace gcv
