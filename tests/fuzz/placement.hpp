// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Bytes -> a place for a polygon of small integers among the doubles: turned, of any size,
// anywhere.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "fuzz.hpp"

namespace gcv::fuzz {

// From the grid to doubles.
struct Placement {
  int eighths = 0;  // of the tangent of half the angle of a rotation
  int exponent = 0;
  std::array<double, 2> shift{};

  static Placement read(Input& input, bool rotated, bool scaled, bool shifted) {
    Placement placement;
    if (rotated) {
      placement.eighths = input.take<std::int8_t>();
    }
    if (scaled) {
      placement.exponent = input.take<std::int16_t>() % 1080;
    }
    if (shifted) {
      const int exponent = placement.exponent + static_cast<int>(input.below(64));
      placement.shift[0] = std::ldexp(input.take<std::int8_t>(), exponent);
      placement.shift[1] = std::ldexp(input.take<std::int8_t>(), exponent);
    }
    return placement;
  }

  [[nodiscard]] std::array<double, 2> operator()(double x, double y) const {
    const double t = eighths / 8.0;
    const double cosine = (1 - t * t) / (1 + t * t);
    const double sine = 2 * t / (1 + t * t);
    return {std::ldexp(cosine * x - sine * y, exponent) + shift[0],
            std::ldexp(sine * x + cosine * y, exponent) + shift[1]};
  }
};

inline void add_ulps(Input& input, double& x) {
  const int steps = input.take<std::int8_t>() / 16;
  for (int k = 0; k < std::abs(steps); ++k) {
    x = std::nextafter(x, steps < 0 ? -HUGE_VAL : HUGE_VAL);
  }
}

}  // namespace gcv::fuzz
