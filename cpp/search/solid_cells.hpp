// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Which cells of a grid lie inside a solid.
#pragma once

#include <cstdint>
#include <vector>

#include "boundary.hpp"

namespace gcv {

// Cells in a row: from one to before another.
struct CellRun {
  std::uint32_t row;
  std::uint32_t from;
  std::uint32_t to;
};

// The cells of a grid over a box that lie inside a solid, also if they are larger by the margin on
// each side. `size`: of a cell. The first cell begins in the corner of the box, which is in relative
// coordinates, the last ones end behind it. Row by row. O(1) for each row that an edge meets.
std::vector<CellRun> cells_inside(const Boundary& solid, const Box& box, const Point& size,
                                  double margin);

}  // namespace gcv
