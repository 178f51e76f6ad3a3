// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A tree of boxes over the edges of a boundary chain, or others in an order in which
// neighbours are near. Every node has up to four children, whose boxes lie side by side:
// they are looked at together. The shape of the tree follows from the number of edges alone.
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
  static constexpr std::uint32_t width = 4;
  static constexpr unsigned all_lanes = 15;
  static constexpr std::size_t most_depths = 16;  // of fewer than 2^32 edges

  // The boxes of the children of one node. Those that are missing hold no point.
  struct Block {
    double x0[width];
    double y0[width];
    double x1[width];
    double y1[width];

    [[nodiscard]] Box box(std::uint32_t lane) const {
      return {x0[lane], y0[lane], x1[lane], y1[lane]};
    }
    void put(std::uint32_t lane, const Box& with) {
      x0[lane] = with.x0;
      y0[lane] = with.y0;
      x1[lane] = with.x1;
      y1[lane] = with.y1;
    }
  };

  // Node k of depth d has the children 4 k to 4 k + 3 of depth d + 1. The root, which holds
  // all edges, is node 0 of depth 0; the nodes of the last depth are the edges.
  struct Node {
    std::uint32_t depth;
    std::uint32_t index;
  };

  std::uint32_t edges = 0;
  std::vector<Block> blocks;               // from the root's to those of edges
  std::vector<std::uint32_t> first_block;  // of the children of nodes of depth d
  Box box{};                               // the root's

  [[nodiscard]] bool is_edge(const Node& node) const { return node.depth == first_block.size(); }
  // How many nodes have that depth, above that of the edges.
  [[nodiscard]] std::uint32_t nodes_of_depth(std::uint32_t depth) const {
    const std::size_t end = depth + 1 < first_block.size() ? first_block[depth + 1] : blocks.size();
    return static_cast<std::uint32_t>(end) - first_block[depth];
  }
  // Is there such a node? Boxes that are missing can overlap only such as are not finite.
  [[nodiscard]] bool has(const Node& node) const {
    return node.index < (is_edge(node) ? edges : nodes_of_depth(node.depth));
  }
  // The number of the block of a node's children.
  [[nodiscard]] std::uint32_t block_below(const Node& node) const {
    return first_block[node.depth] + node.index;
  }
  static Node child(const Node& node, std::uint32_t lane) {
    return {node.depth + 1, width * node.index + lane};
  }
};

// The lanes of the boxes that are apart from the given one. Where numbers have overflowed,
// they are not.
inline LaneMask apart_from(const ChainTree::Block& block, const Box& box) {
  return (Lanes::load(block.x0) > box.x1) | (Lanes::load(block.x1) < box.x0) |
         (Lanes::load(block.y0) > box.y1) | (Lanes::load(block.y1) < box.y0);
}

// The other lanes, as bits.
inline unsigned overlapping(const ChainTree::Block& block, const Box& box) {
  return ~apart_from(block, box).bits() & ChainTree::all_lanes;
}

// The box of the segment pq.
Box box_of(const Point& p, const Point& q);

// The tree over edges with these boxes; at least one.
ChainTree build_chain_tree(std::span<const Box> edges);

// The tree over the edges of the closed ring.
ChainTree build_chain_tree(std::span<const Point> ring);

// The pairs of edges whose boxes overlap: calls visit(i, j) for each, once, until it returns
// false or until so many pairs of nodes have been looked at.
template <class Visit>
class OverlappingPairs {
 public:
  OverlappingPairs(const ChainTree& tree, std::uint64_t most_looks, Visit& visit)
      : tree_(tree), looks_left_(most_looks), visit_(visit) {}

  // Those of edges below the node. False where it was ended.
  bool within(const ChainTree::Node& node) {
    if (tree_.is_edge(node)) {
      return true;
    }
    const ChainTree::Block& block = tree_.blocks[tree_.block_below(node)];
    for (std::uint32_t lane = 0; lane < ChainTree::width; ++lane) {
      if (!(block.x0[lane] <= block.x1[lane])) {
        break;
      }
      const ChainTree::Node child = ChainTree::child(node, lane);
      unsigned later = overlapping(block, block.box(lane)) & ~0U << (lane + 1);
      for (; later != 0; later &= later - 1) {
        const auto other = static_cast<std::uint32_t>(std::countr_zero(later));
        const ChainTree::Node sibling = ChainTree::child(node, other);
        if (tree_.has(sibling) && !between(child, block.box(lane), sibling, block.box(other))) {
          return false;
        }
      }
      if (!within(child)) {
        return false;
      }
    }
    return true;
  }

  // Those of one edge below each of two nodes, whose boxes overlap. False where it was ended.
  bool between(const ChainTree::Node& a, const Box& box_a, const ChainTree::Node& b,
               const Box& box_b) {
    if (looks_left_-- == 0) {
      return false;
    }
    if (a.depth > b.depth) {
      return between(b, box_b, a, box_a);
    }
    if (tree_.is_edge(a)) {
      return visit_(a.index, b.index);
    }
    const ChainTree::Block& block = tree_.blocks[tree_.block_below(a)];
    for (unsigned lanes = overlapping(block, box_b); lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
      const ChainTree::Node child = ChainTree::child(a, lane);
      if (tree_.has(child) && !between(b, box_b, child, block.box(lane))) {
        return false;
      }
    }
    return true;
  }

 private:
  const ChainTree& tree_;
  std::uint64_t looks_left_;
  Visit& visit_;
};

// False where it was ended.
template <class Visit>
bool visit_overlapping_pairs(const ChainTree& tree, std::uint64_t most_looks, Visit visit) {
  return OverlappingPairs<Visit>(tree, most_looks, visit).within({0, 0});
}

// Calls visit(i, j) for all of them.
template <class Visit>
void for_each_overlapping_pair(const ChainTree& tree, Visit visit) {
  visit_overlapping_pairs(tree, ~std::uint64_t{0}, [&](std::uint32_t i, std::uint32_t j) {
    visit(i, j);
    return true;
  });
}

}  // namespace gcv
