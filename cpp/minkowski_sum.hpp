// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The whole way from two polygons to the ring of doubles.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "exact_ring.hpp"
#include "polygon.hpp"
#include "predicates.hpp"
#include "rounding.hpp"
#include "simplification.hpp"
#include "superset.hpp"
#include "task.hpp"

namespace gcv {

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

// The outer face of a + b + shift; the errors of a and b count in its error. Throws Error: range,
// cancelled, internal.
OuterFace minkowski_sum(const Operand& a, const Operand& b, const Point& shift, Rounding rounding,
                        Task& task);

// The explicit superset of a + b, its sources in the callers' numbers.
std::vector<SupersetEdge> superset(const Polygon& a, const Polygon& b);

}  // namespace gcv
