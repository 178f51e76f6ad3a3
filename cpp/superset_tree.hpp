// SPDX-License-Identifier: LGPL-3.0-or-later
//
// All superset edges in a tree of boxes. Where they are few, that is soon built, and a search
// in it takes a fraction of one in the implicit superset.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "chain_tree.hpp"
#include "contributing_vertices.hpp"
#include "contributions.hpp"

namespace gcv {

// How many superset edges there are, before merging. O(n + m).
std::uint64_t count_superset(const Operands& operands, const RankedEdges& ranked);

class SupersetTree {
 public:
  // For fewer than 2^32 edges. O(n + m + edges log edges).
  SupersetTree(const Operands& operands, const RankedEdges& ranked);

  // Calls visit(edge) for superset edges, among them all that have a point in the place.
  //   place.overlapping(block): the lanes that may have one;
  //   place.ascends(): are those with larger coordinates to come last?
  template <class Place, class Visit>
  void search(const Place& place, Visit visit) const {
    const auto last = static_cast<std::uint32_t>(tree_.first_block.size() - 1);
    ChainTree::Node stack[most_nodes];
    stack[0] = {0, 0};
    for (std::uint32_t count = 1; count > 0;) {
      const ChainTree::Node node = stack[--count];
      const unsigned lanes = place.overlapping(tree_.blocks[tree_.block_below(node)]);
      const std::size_t siblings =
          node.depth == last ? edges_.size() : tree_.nodes_of_depth(node.depth + 1);
      const std::uint32_t first = count;
      for_each_lane(lanes, [&](std::uint32_t lane) {
        const ChainTree::Node child = ChainTree::child(node, lane);
        // Missing ones overlap where numbers have overflowed.
        if (child.index >= siblings) {
          return;
        }
        if (node.depth == last) {
          visit(edges_[child.index]);
        } else {
          stack[count++] = child;
        }
      });
      if (place.ascends()) {
        std::reverse(stack + first, stack + count);
      }
    }
  }

 private:
  // Each depth leaves three nodes behind when one is gone into.
  static constexpr std::uint32_t most_nodes = 3 * ChainTree::most_depths + 1;

  std::vector<PairEdge> edges_;
  ChainTree tree_;
};

}  // namespace gcv
