// SPDX-License-Identifier: LGPL-3.0-or-later
#include "chain_tree.hpp"

#include <cassert>

namespace gcv {

namespace {

Box hull_of(const ChainTree::Block& block) {
  return hull_of(hull_of(block.box(0), block.box(1)), hull_of(block.box(2), block.box(3)));
}

}  // namespace

ChainTree build_chain_tree(const EdgeChain& chain) {
  constexpr std::uint32_t width = ChainTree::width;
  ChainTree tree;
  const std::uint32_t edges = chain.size();
  std::uint32_t counts[ChainTree::most_depths];  // blocks of each level, from the edges up
  std::size_t depths = 0;
  std::uint32_t count = edges;
  do {
    count = (count + width - 1) / width;
    counts[depths++] = count;
  } while (count > 1);
  std::uint32_t total = 0;
  tree.first_block.resize(depths);
  for (std::size_t depth = 0; depth < depths; ++depth) {
    tree.first_block[depth] = total;
    total += counts[depths - 1 - depth];
  }
  tree.blocks.resize(total);
  const auto fill = [&](std::uint32_t first, std::uint32_t blocks, std::uint32_t lanes,
                        const auto& box) {
    for (std::uint32_t k = 0; k < blocks * width; ++k) {
      tree.blocks[first + k / width].put(k % width, k < lanes ? box(k) : empty_box);
    }
  };
  fill(tree.first_block.back(), counts[0], edges, [&](std::uint32_t k) {
    const auto ends = chain.ends(k, 1);
    return box_of(ends.front(), ends.back());
  });
  for (std::size_t level = 1; level < depths; ++level) {
    const std::size_t depth = depths - 1 - level;
    fill(tree.first_block[depth], counts[level], counts[level - 1],
         [&](std::uint32_t k) { return hull_of(tree.blocks[tree.first_block[depth + 1] + k]); });
  }
  assert(depths <= ChainTree::most_depths && counts[depths - 1] == 1);
  tree.box = hull_of(tree.blocks.front());
  return tree;
}

}  // namespace gcv
