// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The whole boundary of what the open sum of two operands leaves free, exactly: rings, segments and
// points. As canonical parts.
#pragma once

#include <vector>

#include "contributing_vertices.hpp"
#include "minkowski_sum.hpp"
#include "region.hpp"
#include "task.hpp"
#include "window_border.hpp"

namespace gcv {

// Which parts are wanted beside the outer ring.
struct WantedParts {
  bool holes = true;
  bool fits = true;  // segments and points
};

// How many steps a task is told of for the parts beside an outer face. They take several times as
// long as that.
std::uint64_t estimated_cover_steps(const Boundary& a, const Boundary& b);

// Makes it the first ring of a sum.
void add_outer_ring(std::vector<RingVertex> outer, ExactRegion& region);

// Adds the parts of the closed sum of two polygons. `outer` is the ring of its outer face.
void find_sum_parts(const Operands& operands, const std::vector<RingVertex>& outer,
                    const WantedParts& wanted, Task& task, Counts& counts, ExactRegion& region);

// Adds the parts of the free set, where the first solid of A is the outside of a container. With
// the border of a window, the parts of what lies in it.
void find_free_parts(const Operands& operands, const WindowBorder* border,
                     const WantedParts& wanted, Task& task, Counts& counts, ExactRegion& region);

// Adds the parts of the free set in no order. Its rings are not put together to polygons: of those
// of A, none needs to hold the others.
void find_free_boundary(const Operands& operands, const WantedParts& wanted, Task& task,
                        Counts& counts, ExactRegion& region);

}  // namespace gcv
