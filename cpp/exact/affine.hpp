// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "point.hpp"

namespace gcv {

// (x, y) becomes (xx x + xy y + x0, yx x + yy y + y0).
struct AffineMap {
  double xx, xy, x0;
  double yx, yy, y0;
};

// The image of a point, each coordinate correctly rounded, ties to even; infinite where it is
// beyond the largest double. All numbers are finite.
Point mapped(const AffineMap& map, const Point& p);

}  // namespace gcv
