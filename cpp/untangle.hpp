// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The last resort of rounding: a simple ring from a closed polyline that crosses itself.
#pragma once

#include <optional>
#include <vector>

#include "point.hpp"
#include "predicates.hpp"

namespace gcv {

struct UntangledRing {
  PointVector vertices;  // simple, counter-clockwise
  // No point of the ring is further than this from the polyline, and the other way round:
  // what the ring leaves out counts.
  double error_bound = 0;
};

// The boundary of the unbounded face of the closed polyline, snapped to a grid of one unit
// in the last place of its largest x and of its largest y; of several parts that touch in points,
// the largest. Nothing where that has no area.
std::optional<UntangledRing> untangle(const PointVector& polyline, Tally& tally);

}  // namespace gcv
