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

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes) {
  std::vector<std::uint32_t> numbers(boxes.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  nodes_.reserve(2 * boxes.size());
  if (!numbers.empty()) {
    add(boxes, numbers);
  }
}

// Halves the boxes by their middles, along the longer side of the node.
void BoxTree::add(std::span<const Box> boxes, std::span<std::uint32_t> numbers) {
  const std::size_t node = nodes_.size();
  Box hull = plane_if_unknown(boxes[numbers.front()]);
  for (const std::uint32_t number : numbers.subspan(1)) {
    hull = hull_of(hull, plane_if_unknown(boxes[number]));
  }
  nodes_.push_back({hull, numbers.front(), 0});
  if (numbers.size() > 1) {
    const bool by_x = hull.x1 - hull.x0 >= hull.y1 - hull.y0;
    const auto middle = [&](std::uint32_t number) {
      const Box& box = boxes[number];
      const double twice = by_x ? box.x0 + box.x1 : box.y0 + box.y1;
      return std::isnan(twice) ? infinity : twice;
    };
    const auto half = static_cast<std::ptrdiff_t>(numbers.size() / 2);
    std::nth_element(numbers.begin(), numbers.begin() + half, numbers.end(),
                     [&](std::uint32_t p, std::uint32_t q) { return middle(p) < middle(q); });
    add(boxes, numbers.first(static_cast<std::size_t>(half)));
    add(boxes, numbers.subspan(static_cast<std::size_t>(half)));
  }
  nodes_[node].behind = static_cast<std::uint32_t>(nodes_.size());
}

}  // namespace gcv
