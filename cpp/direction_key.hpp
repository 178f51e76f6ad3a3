// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Line directions as doubles, which most comparisons of them can do with.
#pragma once

#include <cmath>
#include <limits>

#include "point.hpp"

namespace gcv {

// dx / (|dx| + |dy|), which falls as the angle of (dx, dy) grows from 0 to half a turn, for the
// direction from p to q. With u = 2^-53: each coordinate was rounded once, by u of itself at
// most, for differences of doubles do not underflow. That moves the exact quotient f by
// 2u |f| (1 - |f|) <= u / 2, and the sum and the quotient add u |f| <= u each; where the
// quotient underflows, 2^-1075. So a key is off by less than 3u, a difference of two keys,
// rounded by 2u, by less than 8u; compare_keys() asks for 16u. What a quarter of a direction that
// overflows loses to underflow is nothing beside it.
inline double direction_key(const Point& p, const Point& q) {
  const Point d = direction(p, q);
  return d.x / (std::abs(d.x) + std::abs(d.y));
}

// The order of the angles: 1 where that of the first key is smaller, -1 where it is larger, 0 where
// the keys are too near each other to tell.
inline int compare_keys(double first, double second) {
  constexpr double tolerance = 8 * std::numeric_limits<double>::epsilon();
  const double difference = first - second;
  if (std::abs(difference) <= tolerance) {
    return 0;
  }
  return difference > 0 ? 1 : -1;
}

}  // namespace gcv
