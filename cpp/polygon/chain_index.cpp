// SPDX-License-Identifier: LGPL-3.0-or-later
#include "chain_index.hpp"

#include <algorithm>

#include "box.hpp"
#include "curve_order.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

// So many nodes of one level lie over a place, on average, before another order is tried. Coasts,
// combs, stars and zigzags in any position have 2 at most, a spiral of 100 turns has 60.
constexpr double many_nodes = 16;

Box box_of_edge(const EdgeChain& chain, Index edge) {
  const auto ends = chain.ends(edge, 1);
  return box_of(ends.front(), ends.back());
}

double area_of(const Box& box) { return (box.x1 - box.x0) * (box.y1 - box.y0); }

// How many nodes of a level lie over a place, on average, and at most of all levels above the
// edges.
double nodes_over_a_place(const ChainIndex& index) {
  const ChainTree& tree = index.tree;
  double most = 0;
  for (std::size_t depth = 0; depth + 1 < tree.first_block.size(); ++depth) {
    double area = 0;
    for (std::uint32_t k = tree.first_block[depth]; k < tree.first_block[depth + 1]; ++k) {
      const SweptSphereBlock& spheres = index.spheres[k];
      for_each_lane(children_of(tree.blocks[k]), [&](std::uint32_t lane) {
        const double length =
            length_bound(spheres.x1[lane] - spheres.x0[lane], spheres.y1[lane] - spheres.y0[lane]);
        area += std::min(area_of(tree.blocks[k].box(lane)), 2 * spheres.radius[lane] * length);
      });
    }
    most = std::max(most, area);
  }
  return most / area_of(tree.box);
}

std::vector<ChainIndex::Spreads> spreads_of(const ChainTree& tree) {
  std::vector<ChainIndex::Spreads> spreads(tree.blocks.size());
  std::vector<double> longest(tree.blocks.size());  // edges below all nodes of a block
  for (std::size_t depth = tree.first_block.size(); depth-- > 0;) {
    const bool are_edges = depth + 1 == tree.first_block.size();
    const std::size_t end = are_edges ? tree.blocks.size() : tree.first_block[depth + 1];
    for (std::size_t k = tree.first_block[depth]; k < end; ++k) {
      const std::size_t children = ChainTree::width * (k - tree.first_block[depth]);
      for_each_lane(children_of(tree.blocks[k]), [&](std::uint32_t lane) {
        const double extents = extents_of(tree.blocks[k].box(lane));
        const double edge =
            are_edges ? extents : longest[tree.first_block[depth + 1] + children + lane];
        spreads[k].of[lane] = extents - edge;
        longest[k] = std::max(longest[k], edge);
      });
    }
  }
  return spreads;
}

}  // namespace

const std::vector<ChainIndex::Spreads>& ChainIndex::spreads() const {
  return lazy_spreads.get([this] { return spreads_of(tree); });
}

ChainIndex build_chain_index(const EdgeChain& chain) {
  ChainIndex index{{}, build_chain_tree(chain), {}, {}};
  index.spheres = build_swept_spheres(index.tree, chain, index.order);
  return index;
}

std::optional<ChainIndex> build_index_on_curve(const ChainIndex& index, const EdgeChain& chain) {
  const double nodes = nodes_over_a_place(index);
  if (!(nodes > many_nodes)) {
    return std::nullopt;
  }
  ChainIndex on_curve;
  on_curve.order = order_on_curve(chain.size(), [&](Index k) { return box_of_edge(chain, k); });
  on_curve.tree = build_tree(
      chain.size(), [&](std::uint32_t k) { return box_of_edge(chain, on_curve.order[k]); });
  on_curve.spheres = build_swept_spheres(on_curve.tree, chain, on_curve.order);
  if (!(nodes_over_a_place(on_curve) < nodes / 4)) {
    return std::nullopt;
  }
  return on_curve;
}

}  // namespace gcv
