// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Finds the edges of a boundary that are near a place.
#pragma once

#include <optional>
#include <vector>

#include "chain_tree.hpp"
#include "ring_layout.hpp"
#include "swept_spheres.hpp"

namespace gcv {

// How much further the nodes of a block extend than the longest edges below them: they do not
// become shorter than these. 0 for an edge.
struct NodeSpreads {
  double of[ChainTree::width];
};

// A tree over the edges, with boxes and line-swept spheres, which have the same blocks.
struct ChainIndex {
  std::vector<Index> order;  // of the edges; empty where it is theirs on the boundary
  ChainTree tree;
  std::vector<SweptSphereBlock> spheres;
  std::vector<NodeSpreads> spreads;

  // That of a number in the order.
  [[nodiscard]] Index edge(Index number) const { return order.empty() ? number : order[number]; }
};

// In the order of the edges on the boundary. O(n log n).
ChainIndex build_chain_index(const EdgeChain& chain);

// In the order of Hilbert's curve, where that is much better. A winding of a spiral goes round all
// the others inside it, and a node for each of them; on the curve, the next edges are those of
// other windings. O(n), or O(n log n) where there is an index.
std::optional<ChainIndex> build_index_on_curve(const ChainIndex& index, const EdgeChain& chain);

}  // namespace gcv
