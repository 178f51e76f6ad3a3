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
  const std::vector<ChainTree::Node>& nodes = polygon.tree.nodes;
  std::vector<NodeSectors> result(nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (nodes[k].right == 0) {
      const Index i = nodes[k].first;
      result[k].edges = sectors({ranks[i], ranks[i]});
      result[k].cones =
          polygon.convex[i] != 0 ? sectors({ranks[polygon.previous(i)], ranks[i]}) : 0;
    }
  }
  polygon.tree.gather(result, [](const NodeSectors& l, const NodeSectors& r) {
    return NodeSectors{l.edges | r.edges, l.cones | r.cones};
  });
  return result;
}

}  // namespace gcv
