// SPDX-License-Identifier: LGPL-3.0-or-later
#include "relative_pair.hpp"

#include <algorithm>
#include <cmath>

#include "vector.hpp"

namespace gcv {

double RelativePair::gap_between(const ChainTree::Node& of_a, const ChainTree::Node& of_b,
                                 const Point& motion) const {
  if (of_a.depth == 0 || of_b.depth == 0 || !(reach() < 0x1p400)) {
    return 0;
  }
  const Sphere p = sphere_of(index_a_, of_a, {0, 0});
  const Sphere q = sphere_of(index_b_, of_b, offset_);
  const Point shift{scale_ * motion.x, scale_ * motion.y};
  const double rounding = 0x1p-48 * (std::abs(shift.x) + std::abs(shift.y));
  return std::max(gap_seen_from(p, q, shift), gap_seen_from(q, p, {-shift.x, -shift.y})) -
         (4 * slack_ + rounding);
}

RelativePair::Sphere RelativePair::sphere_of(const ChainIndex& index, const ChainTree::Node& node,
                                             const Point& offset) const {
  const SweptSphereBlock& block =
      index.spheres[index.tree.first_block[node.depth - 1] + node.index / ChainTree::width];
  const std::uint32_t lane = node.index % ChainTree::width;
  return {scaled({block.x0[lane], block.y0[lane]}, {block.x1[lane], block.y1[lane]}, offset),
          scale_ * block.radius[lane]};
}

// q is shifted by up to that.
double RelativePair::gap_seen_from(const Sphere& p, const Sphere& q, const Point& shift) {
  const Point way{p.segment.to_x - p.segment.from_x, p.segment.to_y - p.segment.from_y};
  if (way == Point{0, 0}) {
    return 0;
  }
  const Point unit = unit_vector(way);
  const auto beyond = [&](double first, double last, double from, double to, double moved) {
    const double low = std::min(from, to) + std::min(moved, 0.0);
    const double high = std::max(from, to) + std::max(moved, 0.0);
    return std::max(first - high, low - last) - q.radius;
  };
  const auto along_unit = [&](double x, double y) { return unit.x * x + unit.y * y; };
  const auto left_of_unit = [&](double x, double y) { return unit.x * y - unit.y * x; };
  const Point from{q.segment.from_x - p.segment.from_x, q.segment.from_y - p.segment.from_y};
  const Point to{q.segment.to_x - p.segment.from_x, q.segment.to_y - p.segment.from_y};
  const double along = beyond(0, along_unit(way.x, way.y), along_unit(from.x, from.y),
                              along_unit(to.x, to.y), along_unit(shift.x, shift.y));
  const double across = beyond(-p.radius, p.radius, left_of_unit(from.x, from.y),
                               left_of_unit(to.x, to.y), left_of_unit(shift.x, shift.y));
  return along > 0 && across > 0 ? std::sqrt(along * along + across * across)
                                 : std::max(along, across);
}

}  // namespace gcv
