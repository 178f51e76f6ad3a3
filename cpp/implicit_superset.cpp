// SPDX-License-Identifier: LGPL-3.0-or-later
#include "implicit_superset.hpp"

namespace gcv {

ImplicitSuperset::ImplicitSuperset(const Operands& operands)
    : operands_(operands),
      sectors_a_(node_sectors(operands.a, operands.directions.rank_a)),
      sectors_b_(node_sectors(operands.b, operands.directions.rank_b)) {}

// The sectors that the range touches. Sector numbers grow with ranks, so a rank in the
// range lies in one of them.
Sectors ImplicitSuperset::sectors(const RankRange& range) const {
  constexpr std::uint64_t most = 64;
  const std::uint64_t turn = 2 * std::uint64_t{operands_.directions.half_turn};
  const auto sector = [&](Rank rank) { return turn <= most ? rank : rank * most / turn; };
  const Sectors from_first = ~Sectors{0} << sector(range.first);
  const Sectors to_last = ~Sectors{0} >> (most - 1 - sector(range.last));
  return range.first <= range.last ? from_first & to_last : from_first | to_last;
}

std::vector<ImplicitSuperset::NodeSectors> ImplicitSuperset::node_sectors(
    const Polygon& polygon, const std::vector<Rank>& ranks) const {
  const ChainTree& tree = polygon.tree;
  std::vector<NodeSectors> result(tree.boxes.size());
  for (Index leaf = 0; leaf < tree.level_size(0); ++leaf) {
    NodeSectors node{0, 0};
    for (Index i = ChainTree::first_edge(leaf); i < tree.last_edge(leaf); ++i) {
      node.edges |= sectors({ranks[i], ranks[i]});
      if (polygon.convex[i] != 0) {
        node.cones |= sectors({ranks[polygon.previous(i)], ranks[i]});
      }
    }
    result[leaf] = node;
  }
  tree.gather(result, [](const NodeSectors& l, const NodeSectors& r) {
    return NodeSectors{l.edges | r.edges, l.cones | r.cones};
  });
  return result;
}

}  // namespace gcv
