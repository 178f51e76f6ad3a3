// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Bounding volume hierarchy over the edges of a boundary chain, with boxes. A node has up to four
// children. Their boxes lie side by side, so that one SIMD operation tests all four. The shape of
// the tree depends on the number of edges only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "box.hpp"
#include "point.hpp"
#include "ring_layout.hpp"
#include "simd.hpp"

namespace gcv {

struct ChainTree {
  static constexpr std::uint32_t width = SimdDouble::width;
  static constexpr std::size_t most_depths = 16;  // enough for 2^32 edges

  // The boxes of the children of one node. The box of a missing child holds no point.
  using Block = BoxBlock<SimdDouble, Box>;

  // Node k of depth d has the children 4 k to 4 k + 3 of depth d + 1. The root is node 0 of depth 0
  // and holds all edges. The nodes of the last depth are the edges.
  struct Node {
    std::uint32_t depth;
    std::uint32_t index;
  };

  Buffer<Block> blocks;                    // from that of the root to those of the edges
  std::vector<std::uint32_t> first_block;  // of each depth; it has the children of node 0
  Box box{};                               // of the root

  [[nodiscard]] bool is_edge(const Node& node) const { return node.depth == first_block.size(); }
  // The index of the block that holds the children of a node.
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

// The edges of closed rings, one ring after the other.
class EdgeChain {
 public:
  // `points` holds the vertices of each ring, and the first vertex of each ring again as its last.
  EdgeChain(PointVector points, const RingLayout& layout)
      : layout_(layout), points_(std::move(points)) {}

  [[nodiscard]] Index size() const { return layout_.size(); }
  // The ends of `count` edges from `first` on. The ends of consecutive edges of a ring are in a
  // row.
  [[nodiscard]] std::span<const Point> ends(Index first, Index count) const {
    const Index last = first + count - 1;
    const Index begin = first + layout_.ring_of(first);
    return std::span<const Point>(points_).subspan(begin, last + layout_.ring_of(last) + 2 - begin);
  }

 private:
  const RingLayout& layout_;
  PointVector points_;
};

// Builds the tree over those edges. O(n).
ChainTree build_chain_tree(const EdgeChain& chain);

}  // namespace gcv
