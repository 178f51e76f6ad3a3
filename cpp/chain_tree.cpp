// SPDX-License-Identifier: LGPL-3.0-or-later
#include "chain_tree.hpp"

#include <algorithm>

namespace gcv {

namespace {

Box join(const Box& a, const Box& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

}  // namespace

ChainTree build_chain_tree(std::span<const Point> ring) {
  ChainTree tree;
  tree.vertex_count = static_cast<std::uint32_t>(ring.size());
  std::uint32_t count = (tree.vertex_count + ChainTree::leaf_size - 1) / ChainTree::leaf_size;
  std::uint32_t begin = 0;
  tree.level_begin.push_back(begin);
  while (count > 1) {
    begin += count;
    tree.level_begin.push_back(begin);
    count = (count + 1) / 2;
  }
  tree.boxes.resize(begin + 1);
  for (std::uint32_t leaf = 0; leaf < tree.level_size(0); ++leaf) {
    const Point& first = ring[ChainTree::first_edge(leaf)];
    Box box{first.x, first.y, first.x, first.y};
    for (std::uint32_t i = ChainTree::first_edge(leaf); i < tree.last_edge(leaf); ++i) {
      const Point& end = ring[i + 1 == tree.vertex_count ? 0 : i + 1];
      box = join(box, {end.x, end.y, end.x, end.y});
    }
    tree.boxes[leaf] = box;
  }
  tree.gather(tree.boxes, join);
  return tree;
}

}  // namespace gcv
