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

// Segments from (x0, y0) to (x1, y1).
struct SegmentBlock {
  double x0[ChainTree::width];
  double y0[ChainTree::width];
  double x1[ChainTree::width];
  double y1[ChainTree::width];

  void put(std::uint32_t lane, const Point& from, const Point& to) {
    x0[lane] = from.x;
    y0[lane] = from.y;
    x1[lane] = to.x;
    y1[lane] = to.y;
  }
};

// The chains of edges below the children of one node: no point of a chain is further than its
// radius from the segment from (x0, y0) to (x1, y1), but for roundings: 24 u times the extents of
// the ring. The segment of an edge is the edge itself.
struct CapsuleBlock : SegmentBlock {
  double radius[ChainTree::width];
};

// The capsules for the blocks of the tree over that ring, which is closed as for it. O(n log n).
std::vector<CapsuleBlock> build_capsules(const ChainTree& tree, std::span<const Point> ring);

}  // namespace gcv
