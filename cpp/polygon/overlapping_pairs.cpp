// SPDX-License-Identifier: LGPL-3.0-or-later
#include "overlapping_pairs.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace gcv {

namespace {

// A power of two that scales the extents to at most 1, and to more than 1/4 unless they are next to
// nothing. 0 if the extents have overflowed.
double scale_to_one(double extents) {
  return std::isfinite(extents) ? std::ldexp(1.0, -std::max(std::ilogb(extents), -1000) - 1) : 0;
}

}  // namespace

// Maps coordinates within the given bounds to the numbers of the tree. Only if the bounds are
// finite.
class OverlappingPairs::Frame {
 public:
  explicit Frame(const Box& bounds)
      : origin_{bounds.x0, bounds.y0},
        scale_(scale_to_one(std::max(bounds.x1 - bounds.x0, bounds.y1 - bounds.y0))) {}

  [[nodiscard]] bool is_finite() const { return scale_ != 0; }

  // Returns doubles. The caller rounds them to floats.
  [[nodiscard]] PairOfDoubles place(const PairOfDoubles& point) const {
    return (point - origin_) * PairOfDoubles{scale_, scale_};
  }

 private:
  PairOfDoubles origin_;
  double scale_;
};

// Has no branch, because the edges of a ring go all ways. The bits of the index are p.x < q.x (1),
// p.y < q.y (2), q.x < p.x (4) and q.y < p.y (8).
OverlappingPairs::Ways OverlappingPairs::ways_of(const PairOfDoubles& from,
                                                 const PairOfDoubles& to) {
  constexpr Ways on = 5;     // forwards, by x first and by y first
  constexpr Ways back = 10;  // backwards
  constexpr Ways up = 6;     // backwards by x first, forwards by y first
  constexpr Ways down = 9;
  constexpr Ways ways[] = {0, on, on, on, back, 0, up, 0, back, down, 0, 0, back};
  return ways[bits_of(less(from, to)) | bits_of(less(to, from)) << 2U];
}

OverlappingPairs::OverlappingPairs(std::span<const Box> boxes) : before_lanes_(SimdFloat::all) {
  Box bounds = boxes[0];
  for (const Box& box : boxes) {
    bounds = hull_of(bounds, box);
  }
  const Frame frame(bounds);
  if (!frame.is_finite()) {
    build_as_one(boxes.size());
    return;
  }
  build(boxes.size(), [&](Block& block, std::size_t first, std::uint32_t count) {
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      const Box& box = boxes[first + lane];
      const FourFloats placed = rounded(frame.place(PairOfDoubles{box.x0, box.y0}),
                                        frame.place(PairOfDoubles{box.x1, box.y1}));
      block.put(lane, {placed[0], placed[1], placed[2], placed[3]});
    }
    return Ways{0};
  });
}

OverlappingPairs::OverlappingPairs(std::span<const Point> ring, const Box& bounds, Points points)
    : before_lanes_(0x80) {
  const bool are_exact = points == Points::exact;
  const float margin = are_exact ? 0 : 0x1p-20F;
  const Frame frame(bounds);
  if (!frame.is_finite()) {
    build_as_one(ring.size());
    return;
  }
  build(ring.size(), [&](Block& block, std::size_t first, std::uint32_t count) {
    PairOfDoubles ends[width + 1];
    for (std::uint32_t k = 0; k <= width; ++k) {
      const Point& p = ring[first + k < ring.size() ? first + k : 0];
      ends[k] = PairOfDoubles{p.x, p.y};
    }
    Ways ways = are_exact ? all_ways : 0;
    for (std::uint32_t lane = 0; are_exact && lane < count; ++lane) {
      ways &= ways_of(ends[lane], ends[lane + 1]);
    }
    // The order of the four floats is x, y, x, y.
    const auto two = [&](const PairOfDoubles& p, const PairOfDoubles& q) {
      return rounded(frame.place(p), frame.place(q));
    };
    const FourFloats p0 = two(ends[0], ends[1]);
    const FourFloats p2 = two(ends[2], ends[3]);
    const FourFloats p4 = two(ends[4], ends[5]);
    const FourFloats p6 = two(ends[6], ends[7]);
    const FourFloats p8 = two(ends[8], ends[8]);
    const SimdFloat from_x{shuffled<0, 2, 4, 6>(p0, p2), shuffled<0, 2, 4, 6>(p4, p6)};
    const SimdFloat from_y{shuffled<1, 3, 5, 7>(p0, p2), shuffled<1, 3, 5, 7>(p4, p6)};
    const SimdFloat to_x{from<1>(from_x.low, from_x.high), from<1>(from_x.high, p8)};
    const SimdFloat to_y{from<1>(from_y.low, from_y.high),
                         from<1>(from_y.high, shuffled<1, 1, 1, 1>(p8, p8))};
    (smaller(from_x, to_x) - margin).store(block.x0);
    (smaller(from_y, to_y) - margin).store(block.y0);
    (larger(from_x, to_x) + margin).store(block.x1);
    (larger(from_y, to_y) + margin).store(block.y1);
    return ways;
  });
}

template <class Fill>
void OverlappingPairs::build(std::size_t boxes, Fill fill) {
  assert(boxes > 0 && boxes <= std::numeric_limits<std::uint32_t>::max());
  boxes_ = static_cast<std::uint32_t>(boxes);
  first_block_[0] = 0;
  std::uint32_t count = boxes_;
  do {
    count = (count + width - 1) / width;
    first_block_[levels_ + 1] = first_block_[levels_] + count;
    ++levels_;
  } while (count > 1);
  assert(levels_ <= most_levels && nodes(last_level()) == 1);
  nodes_.resize(first_block_[levels_], boost::container::default_init);

  const auto leave_out = [](Block& block, std::uint32_t first) {
    for (std::uint32_t lane = first; lane < width; ++lane) {
      block.put(lane,
                {SimdFloat::highest, SimdFloat::highest, SimdFloat::lowest, SimdFloat::lowest});
    }
  };
  Pace pace;
  for (std::uint32_t node = 0; node < first_block_[1]; ++node) {
    pace.step(width);
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

void OverlappingPairs::build_as_one(std::size_t boxes) {
  build(boxes, [](Block& block, std::size_t /*first*/, std::uint32_t count) {
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      block.put(lane, {0, 0, 0, 0});
    }
    return Ways{0};
  });
}

}  // namespace gcv
