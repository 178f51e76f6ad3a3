// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "region.hpp"
#include "tally.hpp"
#include "task.hpp"

namespace gcv {

// At least the distance of every point of A's boundary from the rings of a region of A and a small
// convex polygon, in their nearest doubles. A ring of which nothing is left counts with its
// extents.
double distance_from_region(const ExactRegion& region, Task& task, Tally& tally);

}  // namespace gcv
