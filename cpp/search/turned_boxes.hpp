// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Boxes in a frame along the long edges. Those along the axes of coordinates are wide where teeth,
// slits and bars slant.
#pragma once

#include <cstdint>
#include <vector>

#include "box.hpp"
#include "chord_tree.hpp"
#include "point.hpp"
#include "simd.hpp"

namespace gcv {

class TurnedBoxes {
 public:
  using Boxes = BoxBlock<SimdDouble, Box>;

  // Of the nodes of both trees, if most edges, by their lengths, are along the longest one or at
  // right angles to it, in many rows, and that slants: else none. O(n + m).
  TurnedBoxes(const ChordTree& a, const ChordTree& b);

  [[nodiscard]] bool empty() const { return a_.empty(); }
  // A point, or a vector, in the frame: off by three roundings.
  [[nodiscard]] Point turned(const Point& p) const {
    return {axis_.x * p.x + axis_.y * p.y, axis_.x * p.y - axis_.y * p.x};
  }
  // Those of a block of the tree of A, or of B.
  [[nodiscard]] const Boxes& of_block(bool is_of_a, std::uint32_t number) const {
    return is_of_a ? a_[number] : b_[number];
  }

 private:
  [[nodiscard]] std::vector<Boxes> boxes_of(const ChordTree& tree) const;

  Point axis_{};  // a unit vector
  std::vector<Boxes> a_;
  std::vector<Boxes> b_;
};

}  // namespace gcv
