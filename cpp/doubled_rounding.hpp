// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Correct rounding of points of the sum in arithmetic of twice the digits, where that is certain.
#pragma once

#include <optional>

#include "doubled.hpp"
#include "point.hpp"

namespace gcv {

struct RoundedNumber {
  double value;  // infinite where no finite double is nearest
  bool exact;
};

struct RoundedVertex {
  RoundedNumber x;
  RoundedNumber y;
};

// The doubles nearest to the coordinates of a + b + shift, ties to even; nothing where they are
// not certain.
std::optional<RoundedVertex> rounded_sum(const SumPoint& point, const Point& shift);

// The same for the crossing of s and t, which are not parallel, + shift.
std::optional<RoundedVertex> rounded_crossing(const SumEdge& s, const SumEdge& t,
                                              const Point& shift);

}  // namespace gcv
