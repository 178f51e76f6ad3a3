// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A binary tree of boxes over the boundary chain of a polygon. A leaf covers a few
// consecutive edges, every other node the edges of one or two children. The shape of
// the tree follows from the number of vertices alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "point.hpp"

namespace gcv {

struct ChainTree {
  static constexpr std::uint32_t leaf_size = 4;

  // A node: the k-th from the left on its level; level 0 are the leaves.
  struct Node {
    std::uint32_t level;
    std::uint32_t k;
  };

  std::vector<std::uint32_t> level_begin;  // index of each level's first node in boxes
  std::vector<Box> boxes;                  // of the edges below a node, both ends included
  std::uint32_t vertex_count = 0;

  [[nodiscard]] std::size_t index(Node node) const { return level_begin[node.level] + node.k; }
  [[nodiscard]] Node root() const {
    return {static_cast<std::uint32_t>(level_begin.size() - 1), 0};
  }
  [[nodiscard]] std::uint32_t level_size(std::uint32_t level) const {
    const std::size_t end = level + 1 < level_begin.size() ? level_begin[level + 1] : boxes.size();
    return static_cast<std::uint32_t>(end - level_begin[level]);
  }
  // A node above the leaves has a left child 2k, and a right child 2k + 1 if that exists.
  [[nodiscard]] bool has_right_child(Node node) const {
    return 2 * node.k + 1 < level_size(node.level - 1);
  }
  // The edges i in [first, last) of a leaf.
  [[nodiscard]] static std::uint32_t first_edge(std::uint32_t leaf) { return leaf * leaf_size; }
  [[nodiscard]] std::uint32_t last_edge(std::uint32_t leaf) const {
    const std::uint32_t end = (leaf + 1) * leaf_size;
    return end < vertex_count ? end : vertex_count;
  }

  // Fills every level above the leaves from the one below: node = combine(left, right).
  template <class Value, class Combine>
  void gather(std::vector<Value>& values, Combine combine) const {
    for (std::uint32_t level = 1; level < level_begin.size(); ++level) {
      for (std::uint32_t k = 0; k < level_size(level); ++k) {
        const std::size_t left = index({level - 1, 2 * k});
        values[index({level, k})] =
            has_right_child({level, k}) ? combine(values[left], values[left + 1]) : values[left];
      }
    }
  }
};

// The tree of the closed ring. At least one vertex.
ChainTree build_chain_tree(std::span<const Point> ring);

}  // namespace gcv
