// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Line directions as doubles. They decide most comparisons of line directions.
#pragma once

#include <cmath>
#include <limits>

#include "point.hpp"
#include "vector.hpp"

namespace gcv {

// dx / (|dx| + |dy|) for the direction (dx, dy) from p to q. It falls as the angle grows from 0 to
// half a turn.
//
// Error bound, with u = 2^-53. Each coordinate is a difference, which does not underflow, so it is
// off by at most u of itself. That moves the exact quotient f by 2u |f| (1 - |f|) <= u / 2. The sum
// and the quotient add u |f| <= u each. A quotient that underflows is off by 2^-1075. So a key is
// off by less than 3u. The difference of two keys is rounded by at most 2u, and off by less than
// 8u. compare_keys() asks for 16u. If a direction overflows, a quarter of it is taken; what that
// loses to underflow is far below these errors.
inline double direction_key(const Point& p, const Point& q) {
  const Point d = direction(p, q);
  return d.x / (std::abs(d.x) + std::abs(d.y));
}

// Compares angles by their keys: 1 if the first angle is smaller, -1 if it is larger, 0 if the keys
// cannot tell.
inline int compare_keys(double first, double second) {
  constexpr double tolerance = 8 * std::numeric_limits<double>::epsilon();
  const double difference = first - second;
  if (std::abs(difference) <= tolerance) {
    return 0;
  }
  return difference > 0 ? 1 : -1;
}

}  // namespace gcv
