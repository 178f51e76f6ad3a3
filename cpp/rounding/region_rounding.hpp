// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Rounds an exact region to the nearest doubles.
#pragma once

#include "region.hpp"
#include "tally.hpp"
#include "task.hpp"

namespace gcv {

// The region of doubles that is as near as possible. Rounds each coordinate to the nearest double.
// Rings that cross themselves or each other then are moved apart by a few units in the last place.
// Thin holes are widened. A ring that stays in the way, or whose vertices all fall on one point, is
// dropped. In the error bound a dropped ring counts with its extents. Segments whose ends fall on
// one point become points.
//
// If the first ring is an outer face, it is rounded as round_to_nearest() does, and stays as it is.
// Throws Error: range, if a coordinate is not finite.
RoundedRegion round_to_nearest(const ExactRegion& region, bool has_outer_face, Task& task,
                               Tally& tally);

}  // namespace gcv
