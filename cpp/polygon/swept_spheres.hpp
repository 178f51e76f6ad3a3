// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Line-swept spheres for the nodes of a bounding volume hierarchy over a boundary chain. They are
// tighter than boxes: where two chains slide along each other, their boxes overlap long before the
// chains do. Source: Larsen, Gottschalk, Lin, Manocha, "Fast proximity queries with swept sphere
// volumes", 1999.
#pragma once

#include <span>
#include <vector>

#include "chain_tree.hpp"
#include "point.hpp"

namespace gcv {

// Segments from (x0, y0) to (x1, y1), side by side.
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

// The line-swept spheres of the children of one node. No point of the chain below a child is
// further than the radius from its segment. Rounding adds up to 24 u times the extents of the ring.
// For a child that is an edge, the segment is that edge.
struct SweptSphereBlock : SegmentBlock {
  double radius[ChainTree::width];
};

// Builds the line-swept spheres for all blocks of the tree over those edges, in that order, or in
// theirs where it is empty. O(n log n).
std::vector<SweptSphereBlock> build_swept_spheres(const ChainTree& tree, const EdgeChain& chain,
                                                  std::span<const Index> order);

}  // namespace gcv
