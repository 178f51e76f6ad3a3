// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Bounding volume hierarchy over the edges of a boundary chain, with boxes; or over other boxes
// that are in an order in which neighbours are near. A node has up to four children. Their boxes
// lie side by side, so that one SIMD operation tests all four. The shape of the tree depends on the
// number of edges only.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "box.hpp"
#include "point.hpp"
#include "ring_layout.hpp"
#include "simd.hpp"
#include "task.hpp"

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

// The box of all children.
inline Box hull_of(const ChainTree::Block& block) {
  return hull_of(hull_of(block.box(0), block.box(1)), hull_of(block.box(2), block.box(3)));
}
// The children that there are, as bits. The boxes of missing ones hold no point. But where numbers
// overflow, no box is apart from another, not even these.
inline unsigned children_of(const ChainTree::Block& block) {
  return ~((SimdDouble::load(block.x0) > SimdDouble::load(block.x1)).bits()) & SimdDouble::all;
}

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

// Builds the tree over `count` boxes, at least one. box(k) is that of number k. O(n).
template <class BoxOf>
ChainTree build_tree(std::uint32_t count, BoxOf box) {
  constexpr std::uint32_t width = ChainTree::width;
  ChainTree tree;
  std::uint32_t counts[ChainTree::most_depths];  // blocks of each level, from the edges up
  std::size_t depths = 0;
  std::uint32_t nodes = count;
  do {
    nodes = (nodes + width - 1) / width;
    counts[depths++] = nodes;
  } while (nodes > 1);
  std::uint32_t total = 0;
  tree.first_block.resize(depths);
  for (std::size_t depth = 0; depth < depths; ++depth) {
    tree.first_block[depth] = total;
    total += counts[depths - 1 - depth];
  }
  tree.blocks.resize(total);
  Pace pace;
  const auto fill = [&](std::uint32_t first, std::uint32_t blocks, std::uint32_t lanes,
                        const auto& box_of_lane) {
    for (std::uint32_t k = 0; k < blocks * width; ++k) {
      pace.step();
      tree.blocks[first + k / width].put(k % width, k < lanes ? box_of_lane(k) : empty_box);
    }
  };
  fill(tree.first_block.back(), counts[0], count, box);
  for (std::size_t level = 1; level < depths; ++level) {
    const std::size_t depth = depths - 1 - level;
    fill(tree.first_block[depth], counts[level], counts[level - 1],
         [&](std::uint32_t k) { return hull_of(tree.blocks[tree.first_block[depth + 1] + k]); });
  }
  assert(depths <= ChainTree::most_depths && counts[depths - 1] == 1);
  tree.box = hull_of(tree.blocks.front());
  return tree;
}

// Builds the tree over those edges. O(n).
ChainTree build_chain_tree(const EdgeChain& chain);

}  // namespace gcv
