// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Correct rounding of points of the sum in double-double arithmetic, where that is certain.
#pragma once

#include <optional>

#include "point.hpp"

namespace gcv {

struct RoundedNumber {
  double value;  // infinite if the nearest double is not finite
  bool exact;
};

struct RoundedVertex {
  RoundedNumber x;
  RoundedNumber y;
};

struct Ball;

// The double nearest to the number, ties to even. Nothing if it is not certain.
std::optional<RoundedNumber> rounded(const Ball& ball);

// The doubles nearest to the coordinates of a + b + shift, ties to even. Nothing if they are not
// certain.
std::optional<RoundedVertex> rounded_sum(const SumPoint& point, const Point& shift);

// The same for the crossing of s and t, plus `shift`. s and t must not be parallel.
std::optional<RoundedVertex> rounded_crossing(const SumEdge& s, const SumEdge& t,
                                              const Point& shift);

// The double nearest to xx x + xy y + x0 with p = (x, y), ties to even. Nothing if it is not
// certain.
std::optional<RoundedNumber> rounded_affine(double xx, double xy, double x0, const Point& p);

}  // namespace gcv
