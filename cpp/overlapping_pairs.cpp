// SPDX-License-Identifier: LGPL-3.0-or-later
#include "overlapping_pairs.hpp"

#include <algorithm>

namespace gcv {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

}  // namespace

OverlappingPairs::OverlappingPairs(std::span<const Box> boxes) : after_first_(~1U) {
  build(boxes.size(), [&](std::size_t k) { return boxes[k]; });
}

OverlappingPairs::OverlappingPairs(std::span<const Point> ring) : after_first_(~3U) {
  build(ring.size(),
        [&](std::size_t k) { return box_of(ring[k], ring[k + 1 == ring.size() ? 0 : k + 1]); });
}

template <class BoxOf>
void OverlappingPairs::build(std::size_t boxes, BoxOf box_of) {
  boxes_ = static_cast<std::uint32_t>(boxes);
  first_block_[0] = 0;
  std::uint32_t count = boxes_;
  do {
    count = (count + width - 1) / width;
    first_block_[levels_ + 1] = first_block_[levels_] + count;
    ++levels_;
  } while (count > 1);
  blocks_.resize(first_block_[levels_]);

  Box bounds = box_of(0);
  for (std::size_t k = 1; k < boxes; ++k) {
    const Box box = box_of(k);
    bounds = {std::min(bounds.x0, box.x0), std::min(bounds.y0, box.y0), std::max(bounds.x1, box.x1),
              std::max(bounds.y1, box.y1)};
  }
  const double scale = scale_to_one(std::max(bounds.x1 - bounds.x0, bounds.y1 - bounds.y0));
  const auto place = [&](double x, double origin) {
    return static_cast<float>((x - origin) * scale);
  };
  for (std::uint32_t k = 0; k < boxes_; ++k) {
    const Box box = box_of(k);
    blocks_[k / width].put(
        k % width, scale == 0 ? FloatBox{-infinity, -infinity, infinity, infinity}
                              : FloatBox{place(box.x0, bounds.x0), place(box.y0, bounds.y0),
                                         place(box.x1, bounds.x0), place(box.y1, bounds.y0)});
  }
  for (std::uint32_t level = 1; level < levels_; ++level) {
    for (std::uint32_t node = 0; node < nodes(level - 1); ++node) {
      const Block& below = block(level - 1, node);
      FloatBox box{infinity, infinity, -infinity, -infinity};
      for (std::uint32_t lane = 0; lane < children(level - 1, node); ++lane) {
        box = {std::min(box.x0, below.x0[lane]), std::min(box.y0, below.y0[lane]),
               std::max(box.x1, below.x1[lane]), std::max(box.y1, below.y1[lane])};
      }
      blocks_[first_block_[level] + node / width].put(node % width, box);
    }
  }
}

}  // namespace gcv
