// SPDX-License-Identifier: LGPL-3.0-or-later
#include "curve_order.hpp"

#include <array>
#include <boost/sort/spreadsort/integer_sort.hpp>
#include <cstdint>
#include <utility>

namespace gcv {

namespace {

// Hilbert's curve through a square begins in its lower left corner. In a part of the square it is
// the same curve with x and y exchanged, or with both turned round, or both: the state of the part.
// Source: Warren, Hacker's Delight, chapter 16.
struct State {
  bool is_exchanged;
  bool is_turned;
};

// The curve through a square of 16 x 16: the place of a point of it, and the state of the square
// there.
struct Step {
  std::uint8_t place;
  std::uint8_t state;
};
using Steps = std::array<std::array<Step, 256>, 4>;  // by state, and by 16 x + y

constexpr Step step_of(std::uint32_t x, std::uint32_t y, State state) {
  if (state.is_turned) {
    x ^= 15U;
    y ^= 15U;
  }
  if (state.is_exchanged) {
    std::swap(x, y);
  }
  std::uint32_t place = 0;
  for (std::uint32_t bit = 8; bit != 0; bit >>= 1U) {
    const bool right = (x & bit) != 0;
    const bool up = (y & bit) != 0;
    place = (place << 2U) | ((right ? 3U : 0U) ^ (up ? 1U : 0U));
    if (!up) {
      if (right) {
        x = ~x;
        y = ~y;
        state.is_turned = !state.is_turned;
      }
      std::swap(x, y);
      state.is_exchanged = !state.is_exchanged;
    }
  }
  return {static_cast<std::uint8_t>(place),
          static_cast<std::uint8_t>((state.is_turned ? 2U : 0U) | (state.is_exchanged ? 1U : 0U))};
}

constexpr Steps steps = [] {
  Steps all{};
  for (std::uint32_t state = 0; state < 4; ++state) {
    for (std::uint32_t xy = 0; xy < 256; ++xy) {
      all[state][xy] = step_of(xy / 16, xy % 16, {(state & 1U) != 0, (state & 2U) != 0});
    }
  }
  return all;
}();

// The place of a point of a square of 2^16 x 2^16 on the curve: points that are near on the curve
// are near.
std::uint32_t place_on_curve(std::uint32_t x, std::uint32_t y) {
  std::uint32_t place = 0;
  std::uint32_t state = 0;
  for (std::uint32_t shift = 16; shift > 0;) {
    shift -= 4;
    const Step& step = steps[state][((x >> shift) % 16) * 16 + (y >> shift) % 16];
    place = place << 8U | step.place;
    state = step.state;
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
