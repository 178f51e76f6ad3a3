// SPDX-License-Identifier: LGPL-3.0-or-later
//
// In place of table.cpp: every superset counts as too large for a tree.
#include <limits>

#include "table.hpp"

namespace gcv {

SupersetCount count_superset(const Operands&, const RankedEdges&) {
  return {std::numeric_limits<std::uint64_t>::max(), 0};
}

CoarseGrid::CoarseGrid(const Operands&) : scale_{0, 0}, middle_{0, 0} {}

bool CoarseGrid::is_fine_enough(const Operands&) const { return false; }

SupersetTable::SupersetTable(const Operands&, const CoarseGrid& grid, const RankedEdges&,
                             std::size_t)
    : grid_(grid) {}

}  // namespace gcv
