// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Distances of points from points and lines: compared exactly, rounded correctly. A distance is the
// root of a fraction of integers.
#pragma once

#include "point.hpp"
#include "tally.hpp"

namespace gcv {

// The distance of a point from the line of an edge, or from the start of the edge.
struct Gap {
  SumEdge edge;
  SumPoint point;
  bool is_to_line;
};

bool is_zero(const Gap& gap, Tally& tally);
// The sign of p - q.
int compare_gaps(const Gap& p, const Gap& q, Tally& tally);
// The sign of p - distance. The distance must be finite and not negative.
int compare_gap(const Gap& p, double distance, Tally& tally);
// The double nearest to the distance, ties to even; infinite if that is not finite.
double nearest_gap(const Gap& gap, Tally& tally);

// The unit vector in the direction from one point to another. Each coordinate is within an ulp. The
// points must be distinct.
Point nearest_unit_vector(const SumPoint& from, const SumPoint& to, Tally& tally);

// The line through the point, at a right angle to that of the edge, seen to the left of it.
SumEdge perpendicular(const SumEdge& edge, const SumPoint& point);

// The largest double that is at most lambda, where the line of t crosses that of s in o_s + lambda
// d_s. lambda must be from 0 on, and s and t not parallel.
double parameter_below(const SumEdge& s, const SumEdge& t, Tally& tally);

// The point a + b, and the crossing of the lines of two edges that are not parallel, plus a shift:
// each coordinate is the nearest double, ties to even; infinite if that is not finite.
Point nearest_point(const SumPoint& point, Tally& tally, const Point& shift = {0, 0});
Point nearest_crossing(const SumEdge& s, const SumEdge& t, Tally& tally,
                       const Point& shift = {0, 0});

}  // namespace gcv
