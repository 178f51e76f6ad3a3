// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Finds the boxes that meet a box.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "box.hpp"

namespace gcv {

// A bounding volume hierarchy over boxes: each node holds two halves of its boxes.
class BoxTree {
 public:
  BoxTree() = default;
  // A box with a coordinate that is not a number counts as the whole plane. O(n log n).
  explicit BoxTree(std::span<const Box> boxes);

  // Calls visit(k, its box) for each box k that meets that box.
  template <class Visit>
  void for_each_near(const Box& box, Visit visit) const {
    std::size_t node = 0;
    while (node < nodes_.size()) {
      const Node& here = nodes_[node];
      const bool is_near = !are_apart(here.box, box);
      if (is_near && here.behind == node + 1) {
        visit(here.number, here.box);
      }
      node = is_near ? node + 1 : here.behind;
    }
  }

 private:
  // Those below a node follow it.
  struct Node {
    Box box;
    std::uint32_t number;  // of the box, of a leaf
    std::uint32_t behind;  // the first node that is not below
  };

  // Adds a node over these boxes, and all below it.
  void add(std::span<const Box> boxes, std::span<std::uint32_t> numbers);

  std::vector<Node> nodes_;
};

}  // namespace gcv
