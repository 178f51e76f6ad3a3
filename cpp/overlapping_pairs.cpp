// SPDX-License-Identifier: LGPL-3.0-or-later
#include "overlapping_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace gcv {

namespace {

Box hull_of(const Box& p, const Box& q) {
  return {std::min(p.x0, q.x0), std::min(p.y0, q.y0), std::max(p.x1, q.x1), std::max(p.y1, q.y1)};
}

// A power of two by which the extents become 1 at most, and above 1/4 unless they are next to
// nothing; 0 where they have overflowed.
double scale_to_one(double extents) {
  return std::isfinite(extents) ? std::ldexp(1.0, -std::max(std::ilogb(extents), -1000) - 1) : 0;
}

}  // namespace

// The numbers of the tree for coordinates within some bounds.
class OverlappingPairs::Frame {
 public:
  struct Place {
    float x;
    float y;
  };

  explicit Frame(const Box& bounds)
      : bounds_(bounds),
        scale_(scale_to_one(std::max(bounds.x1 - bounds.x0, bounds.y1 - bounds.y0))) {}

  [[nodiscard]] Place place(double x, double y) const {
    if (scale_ == 0) {  // the extents overflow
      return {0, 0};
    }
    return {static_cast<float>((x - bounds_.x0) * scale_),
            static_cast<float>((y - bounds_.y0) * scale_)};
  }

 private:
  Box bounds_;
  double scale_;
};

OverlappingPairs::OverlappingPairs(std::span<const Box> boxes) : after_first_(~1U) {
  Box bounds = boxes[0];
  for (const Box& box : boxes) {
    bounds = hull_of(bounds, box);
  }
  const Frame frame(bounds);
  const auto box_of = [&](std::size_t k) {
    const auto low = frame.place(boxes[k].x0, boxes[k].y0);
    const auto high = frame.place(boxes[k].x1, boxes[k].y1);
    return NodeBox{low.x, low.y, high.x, high.y};
  };
  build(boxes.size(), box_of, [](std::size_t) { return Ways{0}; });
}

OverlappingPairs::OverlappingPairs(std::span<const Point> ring) : after_first_(~3U) {
  Box bounds = box_of(ring[0], ring[0]);
  for (const Point& p : ring) {
    bounds = hull_of(bounds, box_of(p, p));
  }
  const Frame frame(bounds);
  const auto end = [&](std::size_t k) { return ring[k + 1 == ring.size() ? 0 : k + 1]; };
  auto to = frame.place(ring[0].x, ring[0].y);
  const auto box_of_edge = [&](std::size_t k) {
    const auto from = to;
    const Point next = end(k);
    to = frame.place(next.x, next.y);
    return NodeBox{std::min(from.x, to.x), std::min(from.y, to.y), std::max(from.x, to.x),
                   std::max(from.y, to.y)};
  };
  build(ring.size(), box_of_edge, [&](std::size_t k) {
    const Point& p = ring[k];
    const Point q = end(k);
    if (p == q) {
      return Ways{0};
    }
    const bool by_x = lexicographically_less(p, q);
    const bool by_y = p.y < q.y || (p.y == q.y && p.x < q.x);
    return static_cast<Ways>((by_x ? 1U : 2U) | (by_y ? 4U : 8U));
  });
}

template <class BoxOf, class WaysOf>
void OverlappingPairs::build(std::size_t boxes, BoxOf box_of, WaysOf ways_of) {
  boxes_ = static_cast<std::uint32_t>(boxes);
  first_block_[0] = 0;
  std::uint32_t count = boxes_;
  do {
    count = (count + width - 1) / width;
    first_block_[levels_ + 1] = first_block_[levels_] + count;
    ++levels_;
  } while (count > 1);
  blocks_.resize(first_block_[levels_]);
  ways_.assign(blocks_.size(), all_ways);

  constexpr NodeBox nothing{FloatLanes::highest, FloatLanes::highest, FloatLanes::lowest,
                            FloatLanes::lowest};
  for (std::uint32_t k = 0; k < boxes_; ++k) {
    put(0, k, box_of(k));
    ways_[k / width] &= ways_of(k);
  }
  for (std::uint32_t k = boxes_; k % width != 0; ++k) {
    put(0, k, nothing);
  }
  for (std::uint32_t level = 1; level < levels_; ++level) {
    const std::uint32_t below = nodes(level - 1);
    for (std::uint32_t node = 0; node < below; ++node) {
      put(level, node, block(level - 1, node).hull());
      ways_[first_block_[level] + node / width] &= ways(level - 1, node);
    }
    for (std::uint32_t node = below; node % width != 0; ++node) {
      put(level, node, nothing);
    }
  }
}

}  // namespace gcv
