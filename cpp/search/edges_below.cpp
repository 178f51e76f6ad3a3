// SPDX-License-Identifier: LGPL-3.0-or-later
#include "edges_below.hpp"

#include "task.hpp"

namespace gcv {

std::vector<EdgesBelow> all_edges_below(const ChordTree& tree, const Boundary& polygon,
                                        const Ranks& ranks, const Directions& directions) {
  std::vector<EdgesBelow> result(tree.blocks.size() * ChordTree::width);
  Pace pace;
  for (std::size_t k = result.size(); k-- > 0;) {
    pace.step();
    const auto node = static_cast<ChordTree::Node>(k);
    if ((tree.block_of(node).lanes >> ChordTree::lane_of(node) & 1U) == 0) {
      continue;
    }
    const std::uint32_t below = tree.below(node);
    if (tree.is_edge(node)) {
      const Rank rank = ranks[below];
      result[node] = {sectors_of(directions, rank, rank),
                      polygon.corners[below].convex
                          ? sectors_of(directions, ranks[polygon.previous(below)], rank)
                          : 0,
                      1};
      continue;
    }
    for (std::uint32_t lane = 0; lane < ChordTree::width; ++lane) {
      const EdgesBelow& child = result[ChordTree::node(below, lane)];
      result[node].edges |= child.edges;
      result[node].cones |= child.cones;
      result[node].size += child.size;
    }
  }
  return result;
}

}  // namespace gcv
