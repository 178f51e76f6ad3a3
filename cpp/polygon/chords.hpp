// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Chords for the nodes of a bounding volume hierarchy over a boundary chain: from the first vertex
// of the chain below a node to the last one. The sum of two chains is close to the parallelogram of
// their chords. That tells what it covers (search/witness.hpp).
#pragma once

#include <vector>

#include "chain_tree.hpp"
#include "swept_spheres.hpp"

namespace gcv {

// The chords of the children of one node. No point of the chain below a child is further than the
// radius from its chord. Rounding adds up to 24 u times the extents of the boundary. An edge is its
// own chord, with the radius 0. Children that hold edges of several rings have an infinite radius.
struct ChordBlock : SegmentBlock {
  double radius[ChainTree::width];
  double length[ChainTree::width];  // of the chord
};

// Builds the chords for all blocks of the tree over those edges. O(n log n).
std::vector<ChordBlock> build_chords(const ChainTree& tree, const EdgeChain& chain,
                                     const RingLayout& layout);

}  // namespace gcv
