// SPDX-License-Identifier: LGPL-3.0-or-later
#include "chain_tree.hpp"

#include <algorithm>

namespace gcv {

namespace {

Box join(const Box& a, const Box& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

// Appends the tree over the edges in [first, last).
void append(ChainTree& tree, std::span<const Box> edges, std::uint32_t first, std::uint32_t last) {
  const auto node = static_cast<std::uint32_t>(tree.nodes.size());
  tree.nodes.push_back({edges[first], 0, first});
  if (last - first > 1) {
    const std::uint32_t middle = first + (last - first + 1) / 2;
    append(tree, edges, first, middle);
    const auto right = static_cast<std::uint32_t>(tree.nodes.size());
    append(tree, edges, middle, last);
    tree.nodes[node].right = right;
    tree.nodes[node].box = join(tree.nodes[node + 1].box, tree.nodes[right].box);
  }
}

}  // namespace

Box box_of(const Point& p, const Point& q) {
  return {std::min(p.x, q.x), std::min(p.y, q.y), std::max(p.x, q.x), std::max(p.y, q.y)};
}

ChainTree build_chain_tree(std::span<const Box> edges) {
  ChainTree tree;
  tree.nodes.reserve(2 * edges.size() - 1);
  append(tree, edges, 0, static_cast<std::uint32_t>(edges.size()));
  return tree;
}

ChainTree build_chain_tree(std::span<const Point> ring) {
  std::vector<Box> edges;
  edges.reserve(ring.size());
  for (std::size_t k = 0; k < ring.size(); ++k) {
    edges.push_back(box_of(ring[k], ring[k + 1 == ring.size() ? 0 : k + 1]));
  }
  return build_chain_tree(edges);
}

}  // namespace gcv
