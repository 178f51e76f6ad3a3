// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>

#include "box.hpp"

namespace gcv {

// The place of a point of a square of 2^16 x 2^16 on the curve of Hilbert: points that are near on
// the curve are near. Source: Warren, Hacker's Delight, chapter 16.
inline std::uint32_t place_on_curve(std::uint32_t x, std::uint32_t y) {
  std::uint32_t place = 0;
  for (std::uint32_t bit = 1U << 15U; bit != 0; bit >>= 1U) {
    const bool right = (x & bit) != 0;
    const bool up = (y & bit) != 0;
    place = (place << 2U) | ((right ? 3U : 0U) ^ (up ? 1U : 0U));
    if (!up) {
      if (right) {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return place;
}

// The order of the centres of boxes on the curve, on a grid over a box that holds all of them.
class CurveOrder {
 public:
  explicit CurveOrder(const Box& bounds) : bounds_(bounds) {}

  [[nodiscard]] std::uint32_t place(const Box& box) const {
    return place_on_curve(on_grid(box.x0, box.x1, bounds_.x0, bounds_.x1),
                          on_grid(box.y0, box.y1, bounds_.y0, bounds_.y1));
  }

 private:
  static std::uint32_t on_grid(double low, double high, double first, double last) {
    const double share = (low / 2 + high / 2 - first) / (last - first);
    // Where extents overflow, the order does not matter.
    return share >= 0 && share <= 1 ? static_cast<std::uint32_t>(share * 65535) : 0;
  }

  Box bounds_;
};

}  // namespace gcv
