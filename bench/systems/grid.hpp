// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The integer grid that polygons are rounded to for systems that compute on integers: the
// same for both polygons, and all of the sum within 2^29.
#pragma once

#include <algorithm>
#include <cmath>

#include "system.hpp"

namespace gcv::bench {

class IntegerGrid {
 public:
  IntegerGrid(const Ring& a, const Ring& b) : exponent_(28 - exponent_of(a, b)) {}

  [[nodiscard]] int to_grid(double x) const {
    return static_cast<int>(std::lround(std::ldexp(x, exponent_)));
  }
  [[nodiscard]] double from_grid(double x) const { return std::ldexp(x, -exponent_); }

 private:
  // |x| < 2^exponent for all coordinates.
  static int exponent_of(const Ring& a, const Ring& b) {
    double size = 0;
    for (const Ring* ring : {&a, &b}) {
      for (const Point& p : *ring) {
        size = std::max({size, std::abs(p.x), std::abs(p.y)});
      }
    }
    return std::ilogb(size) + 1;
  }

  int exponent_;
};

}  // namespace gcv::bench
