// SPDX-License-Identifier: LGPL-3.0-or-later
#include "overlapping_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace gcv {

namespace {

// A power of two by which the extents become 1 at most, and above 1/4 unless they are next to
// nothing; 0 where they have overflowed.
double scale_to_one(double extents) {
  return std::isfinite(extents) ? std::ldexp(1.0, -std::max(std::ilogb(extents), -1000) - 1) : 0;
}

}  // namespace

// The numbers of the tree for coordinates within some bounds.
class OverlappingPairs::Frame {
 public:
  explicit Frame(const Box& bounds)
      : bounds_(bounds),
        scale_(scale_to_one(std::max(bounds.x1 - bounds.x0, bounds.y1 - bounds.y0))) {}

  [[nodiscard]] float x(double x) const { return place(x - bounds_.x0); }
  [[nodiscard]] float y(double y) const { return place(y - bounds_.y0); }

 private:
  // 0 where the extents overflow.
  [[nodiscard]] float place(double distance) const {
    return scale_ == 0 ? 0 : static_cast<float>(distance * scale_);
  }

  Box bounds_;
  double scale_;
};

// Without a branch, for edges of a ring go all ways: by p.x < q.x (1), p.y < q.y (2), q.x < p.x (4)
// and q.y < p.y (8).
OverlappingPairs::Ways OverlappingPairs::ways_of(const Point& p, const Point& q) {
  constexpr Ways on = 5;     // forwards, by x first and by y first
  constexpr Ways back = 10;  // backwards
  constexpr Ways up = 6;     // backwards by x first, forwards by y first
  constexpr Ways down = 9;
  constexpr Ways ways[] = {0, on, on, on, back, 0, up, 0, back, down, 0, 0, back};
  const PairOfDoubles from{p.x, p.y};
  const PairOfDoubles to{q.x, q.y};
  return ways[bits_of(less(from, to)) | bits_of(less(to, from)) << 2U];
}

OverlappingPairs::OverlappingPairs(std::span<const Box> boxes) : before_lanes_(FloatLanes::all) {
  Box bounds = boxes[0];
  for (const Box& box : boxes) {
    bounds = hull_of(bounds, box);
  }
  const Frame frame(bounds);
  build(boxes.size(), [&](Block& block, std::size_t first, std::uint32_t count) {
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      const Box& box = boxes[first + lane];
      block.put(lane, {frame.x(box.x0), frame.y(box.y0), frame.x(box.x1), frame.y(box.y1)});
    }
    return Ways{0};
  });
}

OverlappingPairs::OverlappingPairs(std::span<const Point> ring, const Box& bounds, Points points)
    : before_lanes_(0x80) {
  const bool are_exact = points == Points::exact;
  const float margin = are_exact ? 0 : 0x1p-20F;
  const Frame frame(bounds);
  build(ring.size(), [&](Block& block, std::size_t first, std::uint32_t count) {
    Ways ways = are_exact ? all_ways : 0;
    float x[width + 1]{};
    float y[width + 1]{};
    x[0] = frame.x(ring[first].x);
    y[0] = frame.y(ring[first].y);
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      const std::size_t k = first + lane;
      const Point& p = ring[k];
      const Point& q = ring[k + 1 == ring.size() ? 0 : k + 1];
      x[lane + 1] = frame.x(q.x);
      y[lane + 1] = frame.y(q.y);
      if (are_exact) {
        ways &= ways_of(p, q);
      }
    }
    const FloatLanes from_x = FloatLanes::load(x);
    const FloatLanes from_y = FloatLanes::load(y);
    const FloatLanes to_x = FloatLanes::load(x + 1);
    const FloatLanes to_y = FloatLanes::load(y + 1);
    (smaller(from_x, to_x) - margin).store(block.x0);
    (smaller(from_y, to_y) - margin).store(block.y0);
    (larger(from_x, to_x) + margin).store(block.x1);
    (larger(from_y, to_y) + margin).store(block.y1);
    return ways;
  });
}

template <class Fill>
void OverlappingPairs::build(std::size_t boxes, Fill fill) {
  boxes_ = static_cast<std::uint32_t>(boxes);
  first_block_[0] = 0;
  std::uint32_t count = boxes_;
  do {
    count = (count + width - 1) / width;
    first_block_[levels_ + 1] = first_block_[levels_] + count;
    ++levels_;
  } while (count > 1);
  nodes_.resize(first_block_[levels_], boost::container::default_init);

  const auto leave_out = [](Block& block, std::uint32_t first) {
    for (std::uint32_t lane = first; lane < width; ++lane) {
      block.put(lane,
                {FloatLanes::highest, FloatLanes::highest, FloatLanes::lowest, FloatLanes::lowest});
    }
  };
  for (std::uint32_t node = 0; node < first_block_[1]; ++node) {
    const std::uint32_t lanes = children(0, node);
    nodes_[node].ways = fill(nodes_[node].block, std::size_t{width} * node, lanes);
    leave_out(nodes_[node].block, lanes);
  }
  for (std::uint32_t level = 1; level < levels_; ++level) {
    for (std::uint32_t node = 0; node < nodes(level); ++node) {
      const std::uint32_t lanes = children(level, node);
      Node& parent = nodes_[first_block_[level] + node];
      parent.ways = all_ways;
      for (std::uint32_t lane = 0; lane < lanes; ++lane) {
        const std::uint32_t child = width * node + lane;
        parent.block.put(lane, block(level - 1, child).hull());
        parent.ways &= ways(level - 1, child);
      }
      leave_out(parent.block, lanes);
    }
  }
}

}  // namespace gcv
