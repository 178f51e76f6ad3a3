// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The exact tier of the predicates: integers of a fixed width where they suffice, else GMP's.
// The names and meanings are those of predicates.hpp.
#pragma once

#include "predicates.hpp"

namespace gcv::exact {

int turn(const Point& p0, const Point& p1, const Point& q0, const Point& q1, Tally& tally);
int side(const SumEdge& s, const SumPoint& point, Tally& tally);
int compare_sums(double a, double b, double c, double d, Tally& tally);
int compare_crossings(const SumEdge& s, const SumEdge& t, const SumEdge& r, Tally& tally);

}  // namespace gcv::exact
