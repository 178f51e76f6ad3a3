// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Which superset edges the edges of the outer face come from.
#pragma once

#include <vector>

#include "exact_ring.hpp"
#include "superset.hpp"

namespace gcv {

// The superset edge that each edge of the ring lies on, in the callers' numbers: of those that
// coincide, always the same one. O(n + m), and a search for each edge where chains are repeated
// (equal_chains.hpp).
std::vector<EdgeSource> edge_sources(const ExactRing& ring);

// A source in the callers' numbers.
EdgeSource in_callers_numbers(const EdgeSource& source, const Boundary& a, const Boundary& b);

}  // namespace gcv
