// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Units in the last place, and sums of error bounds.
#pragma once

#include "point.hpp"

namespace gcv {

// The distance from |x| to the next double.
double unit_in_last_place(double x);

// The units in the last place of the largest x and of the largest y of the points.
Point units_in_last_place(const PointVector& points);

// At least x + y. x and y must not be negative.
double sum_bound(double x, double y);

// At least the extents of points whose rounded ones have these extents: both ends are off by the
// error, in each coordinate, if that is not negative.
double exact_extents_bound(double extents, double error);

// At least the distance of p from the segment ab. `unit` is a unit in the last place of the largest
// coordinate.
double distance_bound(Point p, Point a, Point b, double unit);

}  // namespace gcv
