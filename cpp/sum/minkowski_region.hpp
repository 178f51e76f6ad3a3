// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The whole way from two polygons to the region of their sum in doubles: simplification within the
// tolerance, the exact boundary, rounding.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "minkowski_sum.hpp"
#include "polygon.hpp"
#include "region.hpp"
#include "task.hpp"
#include "window_border.hpp"

namespace gcv {

struct RegionOptions : SumOptions {
  bool leave_out_holes = false;
  bool leave_out_fits = false;
};

// A polygon, and its name in messages. `error_bound` is the distance of its boundary from that of
// the polygon that it replaces, at most.
struct RegionOperand {
  std::shared_ptr<const Polygon> polygon;
  const char* name;
  double error_bound = 0;
};

struct Region {
  ExactRegion exact;
  RoundedRegion rounded;
  Counts counts;
  // Of a scene: the solid that each ring of A belongs to. 0 for the border of a window. Else empty.
  std::vector<std::uint64_t> owners;

  // That of the edge that leaves an exact vertex. 0 without a scene.
  [[nodiscard]] std::uint64_t owner(std::size_t vertex) const {
    return owners.empty()
               ? 0
               : owners[exact.a.ring->layout.ring_of(exact.vertices[vertex].leaving().i)];
  }
};

// An operand within half of the tolerance of the given polygon.
RegionOperand simplified_for_sum(const RegionOperand& operand, const SumOptions& options);

// A guess of the steps of a sum.
std::uint64_t estimated_steps(const Polygon& a, const Polygon& b, const RegionOptions& options);

// The sum of operands as they are, as a part of a task. Their errors are added to its bound. Throws
// Error: range, cancelled, internal.
Region sum_region(const RegionOperand& a, const RegionOperand& b, const Point& shift,
                  const RegionOptions& options, Task& task);

// The closed sum a + b + shift, and the exact fits in it. Throws Error: range, cancelled, internal.
Region minkowski_sum_region(const RegionOperand& a, const RegionOperand& b, const Point& shift,
                            const RegionOptions& options, Task& task);

// Where a polygon overlaps no solid: the free set. The first solid is the outside of a container.
// With the border of a window, what lies in that. Throws Error: range, cancelled, internal.
Region free_region(const Operand& solids, const WindowBorder* border,
                   const RegionOperand& reflected, const Point& shift, const RegionOptions& options,
                   Task& task);

// Where `shift` goes if the polygon that `reflected` reflects moves inside the container. Throws
// Error: range, cancelled, internal.
Region inner_fit_region(const RegionOperand& container, const RegionOperand& reflected,
                        const Point& shift, const RegionOptions& options, Task& task);

}  // namespace gcv
