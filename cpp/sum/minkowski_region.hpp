// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The whole way from two polygons to the region of their sum in doubles: simplification within the
// tolerance, the exact boundary, rounding.
#pragma once

#include <cstdint>
#include <memory>

#include "minkowski_sum.hpp"
#include "polygon.hpp"
#include "region.hpp"
#include "task.hpp"

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

// Where `shift` goes if the polygon that `reflected` reflects moves inside the container. Throws
// Error: range, cancelled, internal.
Region inner_fit_region(const RegionOperand& container, const RegionOperand& reflected,
                        const Point& shift, const RegionOptions& options, Task& task);

}  // namespace gcv
