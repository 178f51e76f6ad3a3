// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Snap rounding of a closed polyline that crosses itself to a simple ring. Used if no repair makes
// a rounded ring simple.
#pragma once

#include <optional>

#include "point.hpp"
#include "tally.hpp"

namespace gcv {

struct SnapRoundedRing {
  PointVector vertices;  // simple, counter-clockwise
  // The distance of any point of the ring from the polyline, at most, and of any point of the
  // polyline from the ring. What the ring leaves out counts.
  double error_bound = 0;
};

// The boundary of the unbounded face of the closed polyline, snapped to a grid. The unit of the
// grid is one unit in the last place of the largest x, and of the largest y. If the boundary has
// several parts that touch in points, the result is the largest part. Nothing if that part has no
// area.
std::optional<SnapRoundedRing> snap_round(const PointVector& polyline, Tally& tally);

}  // namespace gcv
