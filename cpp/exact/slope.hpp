// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "point.hpp"
#include "tally.hpp"

namespace gcv {

// Is the angle between the directions from p0 to p1 and from q0 to q1 below a right angle, and its
// tangent at most `slope`, either way? Exact. The slope must be finite and not negative.
bool is_within_slope(const Point& p0, const Point& p1, const Point& q0, const Point& q1,
                     double slope, Tally& tally);

}  // namespace gcv
