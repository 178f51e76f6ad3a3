// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Points that need not have coordinates in doubles: compared exactly, rounded correctly.
#pragma once

#include "point.hpp"
#include "tally.hpp"

namespace gcv {

// A sum of two points, or the crossing of the lines of two edges that are not parallel.
struct ExactPoint {
  bool is_sum;
  SumPoint sum;
  SumEdge s;
  SumEdge t;

  static ExactPoint of_sum(const SumPoint& sum) { return {true, sum, {}, {}}; }
  static ExactPoint of_crossing(const SumEdge& s, const SumEdge& t) { return {false, {}, s, t}; }

  // Are they given in the same way? Others can be the same point, too.
  friend bool operator==(const ExactPoint& p, const ExactPoint& q) {
    return p.is_sum == q.is_sum && (p.is_sum ? p.sum == q.sum : p.s == q.s && p.t == q.t);
  }
};

// Each coordinate of p + shift to the nearest double, ties to even; infinite if that is not finite.
Point nearest_point(const ExactPoint& p, const Point& shift, Tally& tally);

// The sign of a coordinate of p + shift minus a double.
int compare_x(const ExactPoint& p, const Point& shift, double x, Tally& tally);
int compare_y(const ExactPoint& p, const Point& shift, double y, Tally& tally);

// The side of the line of s on which the point lies: 1 left, -1 right, 0 on the line.
int side(const SumEdge& s, const ExactPoint& p, Tally& tally);

// The sign of the distance of p from a point minus that of q.
int compare_distances(const ExactPoint& p, const ExactPoint& q, const Point& from, Tally& tally);
// The sign of how much further p is in a direction than q.
int compare_along(const Point& direction, const ExactPoint& p, const ExactPoint& q, Tally& tally);
// -1 if p comes before q, first by x, then by y.
int compare_lexicographically(const ExactPoint& p, const ExactPoint& q, Tally& tally);

// The double nearest to the distance of p from a point, ties to even; infinite if that is not
// finite.
double nearest_distance(const ExactPoint& p, const Point& from, Tally& tally);

}  // namespace gcv
