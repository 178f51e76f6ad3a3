// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Puts boxes that are near each other in a row.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

#include "box.hpp"

namespace gcv {

// The place of the centre of a box on the curve of Hilbert, on a grid over bounds that hold it.
std::uint32_t place_on_curve(const Box& box, const Box& bounds);

void sort_keys(std::vector<std::uint64_t>& keys);

// The numbers of `count` boxes, in the order of their places on the curve, then of their numbers.
// box(k) is that of number k. O(n).
template <class BoxOf>
std::vector<std::uint32_t> order_on_curve(std::uint32_t count, BoxOf box) {
  Box bounds = empty_box;
  for (std::uint32_t k = 0; k < count; ++k) {
    bounds = hull_of(bounds, box(k));
  }
  std::vector<std::uint64_t> keys(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    keys[k] = std::uint64_t{place_on_curve(box(k), bounds)} << 32U | k;
  }
  sort_keys(keys);
  return {keys.begin(), keys.end()};
}

// The same for boxes that a tree is made over: trees over a few are quick in any order.
template <class BoxOf>
std::vector<std::uint32_t> order_for_tree(std::uint32_t count, BoxOf box) {
  constexpr std::uint32_t few = 64;
  if (count > few) {
    return order_on_curve(count, box);
  }
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

}  // namespace gcv
