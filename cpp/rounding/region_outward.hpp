// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Rounds regions to the safe side: sums outward, so that they contain the exact one, and free sets
// inward, so that they lie inside the exact one.
#pragma once

#include <functional>
#include <memory>

#include "outward.hpp"
#include "polygon.hpp"
#include "region.hpp"

namespace gcv {

// Computes the exact region of a polygon and a square round the origin. The rings of their sum, or
// those of where the square fits into the polygon.
using RegionWithSquare = std::function<ExactRegion(const std::shared_ptr<const Polygon>& polygon,
                                                   const std::shared_ptr<const Polygon>& square)>;

// The first ring is that of round_outward(). Holes lie inside the exact holes. Segments and points
// that are not exact in doubles are dropped. Throws as place_nearest.
RoundedRegion round_region_outward(const ExactRegion& region, const OuterFaceOf& outer_face_of,
                                   const RegionWithSquare& sum_with, Task& task, Tally& tally);

// The same inward. An island that is too thin for doubles is dropped. Throws Error: range, too, if
// an obstacle inside an island, or the room round it, is too thin for doubles.
RoundedRegion round_region_inward(const ExactRegion& region, const RegionWithSquare& fits_of,
                                  Task& task, Tally& tally);

}  // namespace gcv
