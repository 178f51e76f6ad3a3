// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Convex polygons in place of discs: for clearances, and for robots that are round.
#pragma once

#include "point.hpp"
#include "polygon.hpp"
#include "simplification.hpp"

namespace gcv {

// A convex polygon whose boundary is within `tolerance` of the circle, inside and outside. Outward:
// it contains the disc. Fewer than twice as many vertices as are needed for that and for roundings,
// a power of two of them, in the directions of quarters cut in halves. So it is symmetric under
// quarter turns, but for roundings where the centre has finer digits than the radius. O(vertices).
// Throws Error: not_finite; invalid_argument for a radius or a tolerance that is not above 0, or a
// tolerance that is too small for doubles; range.
Polygon make_disc(const Point& centre, double radius, double tolerance, Rounding rounding);

}  // namespace gcv
