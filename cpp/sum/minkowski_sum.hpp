// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The whole way from two polygons to the ring of doubles: simplification within the tolerance,
// the exact outer face of the sum, rounding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "boundary.hpp"
#include "exact_ring.hpp"
#include "rounding.hpp"
#include "simplification.hpp"
#include "superset.hpp"
#include "tally.hpp"
#include "task.hpp"

namespace gcv {

struct SumOptions {
  Rounding rounding = Rounding::nearest;
  double tolerance = 0;
};

struct Counts {
  std::uint64_t walk_steps = 0;
  std::uint64_t candidate_edges = 0;
  Tally predicates;
};

struct OuterFace {
  ExactRing exact;
  RoundedRing rounded;
  Counts counts;
};

// A guess of the steps of a sum: edges walked and vertices rounded.
std::uint64_t estimated_steps(const Boundary& a, const Boundary& b);

// The parts of that work: the vertices that the walk passes, and as many for the rounding. 0 for
// convex polygons, which nothing walks.
std::uint64_t parts_of_sum(const Boundary& a, const Boundary& b);

// A simplification that leaves more vertices saves no time.
std::size_t most_vertices_left(const Boundary& ring);

// An operand within half of the tolerance of the given polygon: the errors of both operands add
// up in the sum. The polygon itself where too many vertices would be left.
Simplified simplified_for_sum(const std::shared_ptr<const Boundary>& polygon,
                              const SumOptions& options);

// The extreme coordinates of a sum are those of vertices of its outer face. Throws Error: range, if
// one is not finite.
void check_extremes(const Boundary& a, const char* name_a, const Boundary& b, const char* name_b);

// The outer face of a + b + shift, of these operands as they are. Their error bounds count in the
// error bound of the result. Throws Error: range, cancelled, internal.
OuterFace minkowski_sum(Operand a, Operand b, const Point& shift, Rounding rounding, Task& task);

// The outer face of a + b + shift, of the operands simplified within the tolerance. The task is
// reported from its start to its end. Throws Error: range, cancelled, internal.
OuterFace minkowski_sum(const Operand& a, const Operand& b, const Point& shift,
                        const SumOptions& options, Task& task);

// The explicit superset of a + b, its sources in the callers' numbers.
std::vector<SupersetEdge> superset(const Boundary& a, const Boundary& b);

// A superset edge in doubles: each coordinate is correctly rounded.
struct RoundedSupersetEdge {
  Point from;
  Point to;
  EdgeSource source;
};

// The explicit superset in doubles. Throws Error: range.
std::vector<RoundedSupersetEdge> rounded_superset(const Boundary& a, const Boundary& b);

}  // namespace gcv
