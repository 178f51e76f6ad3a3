// SPDX-License-Identifier: LGPL-3.0-or-later
#include "tree_product.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limits.hpp"

namespace gcv {

namespace {

double mean_edge_size_of(const Operands& operands) {
  double sum = 0;
  for (const Boundary* polygon : {&operands.a, &operands.b}) {
    for (Index i = 0; i < polygon->size(); ++i) {
      const Point p = polygon->relative(i);
      const Point q = polygon->relative(polygon->next(i));
      sum += std::max(std::abs(q.x - p.x), std::abs(q.y - p.y));
    }
  }
  return sum / (static_cast<double>(operands.a.size()) + operands.b.size());
}

const ChainIndex& index_for(const Boundary& polygon, const Boundary& other,
                            const EqualChains& chains) {
  return limits::is_small_beside(other.size(), polygon.size()) && !chains.exist()
             ? polygon.search_index()
             : polygon.index();
}

// Beside a small polygon nodes are compared by their spreads: a comb and a disc that lies over its
// mouths takes 0.01 of the time by extents. Saws with themselves would take 400 times as long.
const ChainIndex::Spreads* spreads_of(const Operands& operands, const ChainIndex& index) {
  return limits::is_one_small(operands.a.size(), operands.b.size()) ? index.spreads().data()
                                                                    : nullptr;
}

}  // namespace

// Repeated chains are numbered in the order of the boundary. Two large polygons are searched in
// that order, too: what is inside a spiral lies inside of their sum, and is hardly looked at.
TreeProduct::TreeProduct(const Operands& operands, EqualChains chains)
    : TreeProduct(operands, index_for(operands.a, operands.b, chains),
                  index_for(operands.b, operands.a, chains), std::move(chains)) {}

TreeProduct::TreeProduct(const Operands& operands, const ChainIndex& a, const ChainIndex& b,
                         EqualChains chains)
    : operands_(operands),
      a_{a, spreads_of(operands, a), node_sectors(operands.a, operands.directions.rank_a, a),
         std::move(chains.a)},
      b_{b, spreads_of(operands, b), node_sectors(operands.b, operands.directions.rank_b, b),
         std::move(chains.b)},
      mean_edge_size_(mean_edge_size_of(operands)) {}

std::vector<TreeProduct::SectorBlock> TreeProduct::node_sectors(const Boundary& polygon,
                                                                const Ranks& ranks,
                                                                const ChainIndex& index) const {
  const auto sectors = [&](Rank first, Rank last) {
    return sectors_of(operands_.directions, first, last);
  };
  constexpr std::uint32_t width = ChainTree::width;
  const std::vector<std::uint32_t>& first_block = index.tree.first_block;
  std::vector<SectorBlock> result(index.tree.blocks.size());
  for (Index k = 0; k < polygon.size(); ++k) {
    const Index i = index.edge(k);
    SectorBlock& block = result[first_block.back() + k / width];
    block.edges[k % width] = sectors(ranks[i], ranks[i]);
    block.cones[k % width] =
        polygon.corners[i].convex ? sectors(ranks[polygon.previous(i)], ranks[i]) : 0;
  }
  for (std::size_t depth = first_block.size() - 1; depth-- > 0;) {
    const std::uint32_t children = first_block[depth + 1];
    const std::size_t end = depth + 2 < first_block.size() ? first_block[depth + 2] : result.size();
    for (std::uint32_t k = 0; children + k < end; ++k) {
      const SectorBlock& child = result[children + k];
      SectorBlock& block = result[first_block[depth] + k / width];
      block.edges[k % width] = child.edges[0] | child.edges[1] | child.edges[2] | child.edges[3];
      block.cones[k % width] = child.cones[0] | child.cones[1] | child.cones[2] | child.cones[3];
    }
  }
  return result;
}

}  // namespace gcv
