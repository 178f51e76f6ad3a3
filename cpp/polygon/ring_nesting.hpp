// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Do the rings of a polygon lie as they may? Exactly, for all finite doubles.
#pragma once

#include <span>

#include "boundary.hpp"
#include "tally.hpp"

namespace gcv {

// Checks rings, each simple, the outer one first. Rings may touch one another in points, but not
// cross or overlap; holes lie in the outer ring and outside one another. The caller's numbers name
// the edges. O(n log n). Tells what it took.
// Throws Error: not_simple.
Tally check_nesting(std::span<const Boundary* const> rings, const char* name);

}  // namespace gcv
