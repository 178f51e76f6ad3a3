// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The exact tier of the predicates, in integers. Names and meanings are as in predicates.hpp.
#pragma once

#include "point.hpp"
#include "tally.hpp"

namespace gcv::exact {

int turn(const Point& p0, const Point& p1, const Point& q0, const Point& q1, Tally& tally);
int side(const SumEdge& s, const SumPoint& point, Tally& tally);
int compare_sums(double a, double b, double c, double d, Tally& tally);
int compare_sums(double a, double b, double c, double d, double e, double f, Tally& tally);
int compare_crossings(const SumEdge& s, const SumEdge& t, const SumEdge& q, const SumEdge& r,
                      Tally& tally);

}  // namespace gcv::exact
