// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cmath>

#include "error.hpp"
#include "point.hpp"

namespace gcv {

// The point, with 0 in place of -0. Throws Error: not_finite, with a message that begins with
// `name`.
inline Point finite_point(const Point& point, const char* name) {
  if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
    throw Error(Status::not_finite, "%s: the %s coordinate is %g, not a finite number", name,
                std::isfinite(point.x) ? "y" : "x", std::isfinite(point.x) ? point.y : point.x);
  }
  return {point.x + 0.0, point.y + 0.0};
}

}  // namespace gcv
