// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A tree of boxes over the edges of a boundary chain. Every node has up to four children, whose
// boxes lie side by side: they are looked at together. The shape of the tree follows from the
// number of edges alone.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "lanes.hpp"
#include "point.hpp"

namespace gcv {

struct ChainTree {
  static constexpr std::uint32_t width = DoubleLanes::width;
  static constexpr std::size_t most_depths = 16;  // of fewer than 2^32 edges

  // The boxes of the children of one node. Those that are missing hold no point.
  using Block = BoxBlock<DoubleLanes, Box>;

  // Node k of depth d has the children 4 k to 4 k + 3 of depth d + 1. The root, which holds
  // all edges, is node 0 of depth 0; the nodes of the last depth are the edges.
  struct Node {
    std::uint32_t depth;
    std::uint32_t index;
  };

  Buffer<Block> blocks;                    // from the root's to those of edges
  std::vector<std::uint32_t> first_block;  // of the children of nodes of depth d
  Box box{};                               // the root's

  [[nodiscard]] bool is_edge(const Node& node) const { return node.depth == first_block.size(); }
  // The number of the block of a node's children.
  [[nodiscard]] std::uint32_t block_below(const Node& node) const {
    return first_block[node.depth] + node.index;
  }
  // The first of the edges below a node.
  [[nodiscard]] std::uint32_t first_edge(const Node& node) const {
    static_assert(width == 4);
    const auto levels = static_cast<std::uint32_t>(first_block.size()) - node.depth;
    return static_cast<std::uint32_t>(std::uint64_t{node.index} << 2 * levels);
  }
  static Node child(const Node& node, std::uint32_t lane) {
    return {node.depth + 1, width * node.index + lane};
  }
};

// The tree over the edges of a ring, whose first vertex is given again as its last.
ChainTree build_chain_tree(std::span<const Point> ring);

}  // namespace gcv
