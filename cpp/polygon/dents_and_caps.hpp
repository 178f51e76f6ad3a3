// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Fewer vertices for a boundary that may grow outward: dents are filled, and runs of convex
// vertices are replaced by one vertex. Second step of the simplification outward (see
// simplification.cpp).
#pragma once

#include "shortcuts.hpp"

namespace gcv {

// The boundary without the reflex vertices that a segment within the tolerance can be drawn over.
// Expects a boundary of Shortcuts.
NewBoundary without_dents(const Shortcuts& shortcuts, const NewBoundary& boundary);

// The boundary with one new vertex for each run of convex vertices, where the tolerance allows it.
// The new vertex is where the edges before and behind the run meet.
NewBoundary with_caps(const ScaledRing& ring, const NewBoundary& boundary);

}  // namespace gcv
