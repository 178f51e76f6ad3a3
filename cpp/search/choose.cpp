// SPDX-License-Identifier: LGPL-3.0-or-later
#include "choose.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "limits.hpp"

namespace gcv {

SearchableSuperset::SearchableSuperset(const Operands& operands)
    : operands_(operands), slack_(slack_of(operands)) {
  const CoarseGrid grid(operands);
  std::optional<RankedEdges> ranked;
  // At least: a vertex contributes to every edge.
  const std::uint64_t vertices = std::uint64_t{operands.a.size()} + operands.b.size();
  std::uint64_t size = vertices;
  if (size <= limits::most_linear_edges && grid.is_fine_enough(operands)) {
    ranked.emplace(operands.directions);
    size = count_superset(operands, *ranked);
  }
  const std::uint64_t most = std::clamp(limits::edges_a_vertex * vertices, limits::most_table_edges,
                                        limits::most_linear_edges);
  const bool is_small = ranked && size <= most;
  EqualChains chains;
  if (!is_small || chains_can_prevail(operands)) {
    chains = find_equal_chains(operands);
  }
  if (is_small && !chains.prevail) {
    table_.emplace(operands, grid, *ranked, size);
  } else {
    product_.emplace(operands, std::move(chains));
  }
}

}  // namespace gcv
