// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Finds the edges of a boundary that are near a place.
#pragma once

#include <optional>
#include <vector>

#include "chain_tree.hpp"
#include "lazy.hpp"
#include "ring_layout.hpp"
#include "swept_spheres.hpp"

namespace gcv {

// A tree over the edges, with boxes and line-swept spheres, which have the same blocks.
struct ChainIndex {
  std::vector<Index> order;  // of the edges; empty where it is theirs on the boundary
  ChainTree tree;
  std::vector<SweptSphereBlock> spheres;

  // How much further nodes extend than the longest edges below them: nodes do not become shorter
  // than these. 0 for an edge. The first call takes O(n).
  struct Spreads {
    double of[ChainTree::width];  // of the nodes of a block
  };
  [[nodiscard]] const std::vector<Spreads>& spreads() const;
  // That of one node; the extents of the root.
  [[nodiscard]] double spread(const ChainTree::Node& node) const {
    return node.depth == 0
               ? extents_of(tree.box)
               : spreads()[tree.block_below({node.depth - 1, node.index / ChainTree::width})]
                     .of[node.index % ChainTree::width];
  }
  // That of a number in the order.
  [[nodiscard]] Index edge(Index number) const { return order.empty() ? number : order[number]; }

  Lazy<std::vector<Spreads>> lazy_spreads;
};

// In the order of the edges on the boundary. O(n log n).
ChainIndex build_chain_index(const EdgeChain& chain);

// In the order of Hilbert's curve, where that is much better. A winding of a spiral goes round all
// the others inside it, and a node for each of them; on the curve, the next edges are those of
// other windings. O(n), or O(n log n) where there is an index.
std::optional<ChainIndex> build_index_on_curve(const ChainIndex& index, const EdgeChain& chain);

}  // namespace gcv
