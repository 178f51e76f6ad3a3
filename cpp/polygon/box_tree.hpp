// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Finds the boxes that meet a box, or that hold it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "box.hpp"
#include "simd.hpp"
#include "task.hpp"

namespace gcv {

// A bounding volume hierarchy over boxes: those below a block are dealt out to its four lanes.
class BoxTree {
 public:
  BoxTree() = default;
  // A box with a coordinate that is not a number counts as the whole plane. O(n log n).
  explicit BoxTree(std::span<const Box> boxes);

  // Calls visit(k, its box) for each box k that meets that box.
  template <class Visit>
  void for_each_near(const Box& box, Visit visit) const {
    static_cast<void>(any([&](const Boxes& boxes) { return boxes.overlapping(box); },
                          [&](std::uint32_t k, const Box& near) {
                            visit(k, near);
                            return false;
                          }));
  }

  // Is test(k, its box) true for a box k that holds that box?
  template <class Test>
  [[nodiscard]] bool any_around(const Box& box, Test test) const {
    return any([&](const Boxes& boxes) { return boxes.around(box); }, test);
  }

 private:
  using Boxes = BoxBlock<SimdDouble, Box>;
  struct Block {
    Boxes boxes;
    std::uint32_t below[SimdDouble::width];  // the number of the box, or the block below
    unsigned lanes;                          // those that are used, as bits
    unsigned leaves;                         // those that are boxes
  };
  // Lanes of a block have a quarter of its boxes each, one more at most. So there are at most 17
  // levels, each of which leaves three lanes waiting.
  static constexpr std::size_t most_waiting = 64;

  template <class Lanes, class Test>
  [[nodiscard]] bool any(Lanes lanes_of, Test test) const {
    std::uint32_t waiting[most_waiting];
    std::size_t count = 0;
    if (!blocks_.empty()) {
      waiting[count++] = 0;
    }
    while (count > 0) {
      const Block& block = blocks_[waiting[--count]];
      const unsigned lanes = lanes_of(block.boxes) & block.lanes;
      if (any_lane(lanes & block.leaves, [&](std::uint32_t lane) {
            return test(block.below[lane], block.boxes.box(lane));
          })) {
        return true;
      }
      for_each_lane(lanes & ~block.leaves,
                    [&](std::uint32_t lane) { waiting[count++] = block.below[lane]; });
    }
    return false;
  }

  // A box, or a block, and the box of what is below.
  struct Lane {
    std::uint32_t below;
    Box box;
  };
  // Adds a block over these boxes, and all below it.
  Lane add(std::span<const Box> boxes, std::span<std::uint32_t> numbers, Pace& pace);

  std::vector<Block> blocks_;
};

}  // namespace gcv
