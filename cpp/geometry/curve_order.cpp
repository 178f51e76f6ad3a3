// SPDX-License-Identifier: LGPL-3.0-or-later
#include "curve_order.hpp"

#include <boost/sort/spreadsort/integer_sort.hpp>
#include <utility>

namespace gcv {

namespace {

// The place of a point of a square of 2^16 x 2^16 on the curve of Hilbert: points that are near on
// the curve are near. Source: Warren, Hacker's Delight, chapter 16.
std::uint32_t place_on_curve(std::uint32_t x, std::uint32_t y) {
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

std::uint32_t on_grid(double low, double high, double first, double last) {
  const double share = (low / 2 + high / 2 - first) / (last - first);
  // Where extents overflow, the order does not matter.
  return share >= 0 && share <= 1 ? static_cast<std::uint32_t>(share * 65535) : 0;
}

}  // namespace

std::uint32_t place_on_curve(const Box& box, const Box& bounds) {
  return place_on_curve(on_grid(box.x0, box.x1, bounds.x0, bounds.x1),
                        on_grid(box.y0, box.y1, bounds.y0, bounds.y1));
}

void sort_keys(std::vector<std::uint64_t>& keys) {
  boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());
}

}  // namespace gcv
