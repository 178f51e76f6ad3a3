// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The geometric predicates, exact for all finite doubles. Each tries double
// arithmetic with a proven error bound first (the proofs stand in predicates.cpp),
// then pairs of doubles, then integers of fixed width, then GMP's.
//
// Axioms: orientation(p, q, r) = orientation(q, r, p) = -orientation(q, p, r);
// side and compare_crossings do not change when both polygons are translated by
// vectors that the doubles can represent exactly.
#pragma once

#include <cstdint>

#include "point.hpp"

namespace gcv {

// Which tier settled how many predicates.
struct Tally {
  std::uint64_t filtered = 0;
  std::uint64_t fixed_width = 0;
  std::uint64_t rational = 0;

  Tally& operator+=(const Tally& other) {
    filtered += other.filtered;
    fixed_width += other.fixed_width;
    rational += other.rational;
    return *this;
  }
};

// The sign of (q - p) x (r - p): 1 where p, q, r turn left, -1 right, 0 collinear.
int orientation(const Point& p, const Point& q, const Point& r, Tally& tally);

// The sign of (p1 - p0) x (q1 - q0): 1 where the second direction is to the left of
// the first, by less than half a turn.
int turn(const Point& p0, const Point& p1, const Point& q0, const Point& q1, Tally& tally);

// On which side of the line of s the point lies: 1 left, -1 right, 0 on it.
int side(const SumEdge& s, const SumPoint& point, Tally& tally);

// The sign of (a + b) - (c + d).
int compare_sums(double a, double b, double c, double d, Tally& tally);

// The sign of lambda_t - lambda_r, where the line of t crosses the line of s in
// o_s + lambda_t d_s, and likewise r. Neither t nor r may be parallel to s.
int compare_crossings(const SumEdge& s, const SumEdge& t, const SumEdge& r, Tally& tally);

// Doubles that enclose lambda_t; possibly -inf, inf. No lambda leaves its interval,
// so disjoint intervals settle compare_crossings.
struct Interval {
  double lo;
  double hi;
};
Interval crossing_parameter(const SumEdge& s, const SumEdge& t);

}  // namespace gcv
