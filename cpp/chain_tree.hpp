// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A binary tree of boxes over the edges of a boundary chain, or others in an order in which
// neighbours are near: a leaf is one edge, every other node the edges of its two children.
// The shape of the tree follows from the number of edges alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "point.hpp"

namespace gcv {

struct ChainTree {
  // In preorder: the left child follows its parent. Leaves have no right child.
  struct Node {
    Box box;              // of the edges below, both ends included
    std::uint32_t right;  // the right child; 0 for a leaf
    std::uint32_t first;  // the first edge below
  };
  std::vector<Node> nodes;

  // Fills values[k] of every inner node k from its children's: combine(left, right).
  template <class Value, class Combine>
  void gather(std::vector<Value>& values, Combine combine) const {
    for (std::size_t k = nodes.size(); k-- > 0;) {
      if (nodes[k].right != 0) {
        values[k] = combine(values[k + 1], values[nodes[k].right]);
      }
    }
  }
};

// The box of the segment pq.
Box box_of(const Point& p, const Point& q);

// The tree over edges with these boxes; at least one.
ChainTree build_chain_tree(std::span<const Box> edges);

// The tree over the edges of the closed ring.
ChainTree build_chain_tree(std::span<const Point> ring);

inline bool overlap(const Box& a, const Box& b) {
  return a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1;
}

// Calls visit(i, j) for every pair of edges whose boxes overlap, once.
template <class Visit>
class OverlappingPairs {
 public:
  OverlappingPairs(const ChainTree& tree, Visit& visit)
      : nodes_(tree.nodes.data()), visit_(visit) {}

  void within(std::uint32_t node) {
    const std::uint32_t right = nodes_[node].right;
    if (right != 0) {
      within(node + 1);
      within(right);
      between(node + 1, right);
    }
  }

 private:
  void between(std::uint32_t k, std::uint32_t l) {
    const ChainTree::Node& first = nodes_[k];
    const ChainTree::Node& second = nodes_[l];
    if (!overlap(first.box, second.box)) {
      return;
    }
    if (first.right == 0 && second.right == 0) {
      visit_(first.first, second.first);
    } else if (second.right == 0) {
      between(k + 1, l);
      between(first.right, l);
    } else {
      between(k, l + 1);
      between(k, second.right);
    }
  }

  const ChainTree::Node* nodes_;
  Visit& visit_;
};

template <class Visit>
void for_each_overlapping_pair(const ChainTree& tree, Visit visit) {
  OverlappingPairs<Visit>(tree, visit).within(0);
}

}  // namespace gcv
