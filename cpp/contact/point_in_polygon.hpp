// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "polygon_pair.hpp"

namespace gcv {

// Does the interior of a polygon hold a point, which does not lie on its boundary? `relative` is
// the point, seen from the first vertex of the polygon, within `slack`. O(log n) where the boxes of
// few chains hold the point.
bool holds(const PlacedPolygon& polygon, const SumPoint& point, const Point& relative, double slack,
           Tally& tally);

}  // namespace gcv
