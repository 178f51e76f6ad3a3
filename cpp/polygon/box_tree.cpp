// SPDX-License-Identifier: LGPL-3.0-or-later
#include "box_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gcv {

namespace {

Box plane_if_unknown(const Box& box) {
  const bool is_known = box.x0 <= box.x1 && box.y0 <= box.y1;
  return is_known ? box : Box{-infinity, -infinity, infinity, infinity};
}

// Halves them by their middles, along the longer side of their hull. Returns how many come first.
std::size_t halve(std::span<const Box> boxes, std::span<std::uint32_t> numbers) {
  Box hull = empty_box;
  for (const std::uint32_t number : numbers) {
    hull = hull_of(hull, plane_if_unknown(boxes[number]));
  }
  const bool by_x = hull.x1 - hull.x0 >= hull.y1 - hull.y0;
  const auto middle = [&](std::uint32_t number) {
    const Box& box = boxes[number];
    const double twice = by_x ? box.x0 + box.x1 : box.y0 + box.y1;
    return std::isnan(twice) ? infinity : twice;
  };
  const std::size_t half = numbers.size() / 2;
  std::nth_element(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(half),
                   numbers.end(),
                   [&](std::uint32_t p, std::uint32_t q) { return middle(p) < middle(q); });
  return half;
}

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes) {
  std::vector<std::uint32_t> numbers(boxes.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  blocks_.reserve(boxes.size() / 2 + 1);
  if (!numbers.empty()) {
    Pace pace;
    add(boxes, numbers, pace);
  }
}

BoxTree::Lane BoxTree::add(std::span<const Box> boxes, std::span<std::uint32_t> numbers,
                           Pace& pace) {
  pace.step(4 * std::uint64_t{numbers.size()});
  const auto number = static_cast<std::uint32_t>(blocks_.size());
  blocks_.push_back({});
  Block block{};
  Box hull = empty_box;
  std::uint32_t next = 0;
  const auto put = [&](std::span<std::uint32_t> below) {
    const bool is_leaf = below.size() == 1;
    const Lane lane = is_leaf ? Lane{below.front(), plane_if_unknown(boxes[below.front()])}
                              : add(boxes, below, pace);
    block.boxes.put(next, lane.box);
    block.below[next] = lane.below;
    block.lanes |= 1U << next;
    block.leaves |= is_leaf ? 1U << next : 0;
    hull = hull_of(hull, lane.box);
    ++next;
  };
  if (numbers.size() <= SimdDouble::width) {
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      put(numbers.subspan(k, 1));
    }
  } else {
    const std::size_t half = halve(boxes, numbers);
    for (const std::span<std::uint32_t> part : {numbers.first(half), numbers.subspan(half)}) {
      const std::size_t quarter = halve(boxes, part);
      put(part.first(quarter));
      put(part.subspan(quarter));
    }
  }
  blocks_[number] = block;
  return {number, hull};
}

}  // namespace gcv
