// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The walk along the outer face of the sum (the paper, section 4.3, way 1), over the
// implicit superset. Every decision is exact.
#pragma once

#include "boundary.hpp"
#include "tally.hpp"
#include "task.hpp"
#include "walk.hpp"

namespace gcv {

Walk walk_outer_face(const Boundary& a, const Boundary& b, Task& task, Tally& tally);

}  // namespace gcv
