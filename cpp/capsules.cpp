// SPDX-License-Identifier: LGPL-3.0-or-later
#include "capsules.hpp"

#include <algorithm>
#include <cmath>

namespace gcv {

namespace {

struct Capsule {
  Point from;
  Point to;
  double radius;
};

Point operator-(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }

// The capsule along that direction, not null, that holds the points, all but for its round ends.
// The unit vector is off by 5 u, its square by 10 u, and with it the way of a point along and
// across it and back again; products and sums add less than 14 u of the extents.
Capsule capsule_along(const Point& direction, std::span<const Point> points) {
  const Point unit = unit_vector(direction);
  const Point& origin = points.front();
  Box box{0, 0, 0, 0};  // along the unit vector and across it, seen from the origin
  for (const Point& p : points.subspan(1)) {
    const Point d = p - origin;
    const double along = unit.x * d.x + unit.y * d.y;
    const double across = unit.x * d.y - unit.y * d.x;
    box = {std::min(box.x0, along), std::min(box.y0, across), std::max(box.x1, along),
           std::max(box.y1, across)};
  }
  const double middle = (box.y0 + box.y1) / 2;
  const Point foot{origin.x - middle * unit.y, origin.y + middle * unit.x};
  return {{foot.x + box.x0 * unit.x, foot.y + box.x0 * unit.y},
          {foot.x + box.x1 * unit.x, foot.y + box.x1 * unit.y},
          (box.y1 - box.y0) / 2};
}

// That of a chain: the slimmer one of those along its chord, which suits a smooth chain, and along
// its longest edge, which suits one that goes to and fro.
Capsule capsule_of_chain(std::span<const Point> points) {
  if (points.size() == 2) {
    return {points.front(), points.back(), 0};
  }
  Point longest{0, 0};
  double longest_size = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point edge = points[i] - points[i - 1];
    const double size = std::abs(edge.x) + std::abs(edge.y);
    if (size > longest_size) {
      longest_size = size;
      longest = edge;
    }
  }
  if (longest_size == 0) {  // all points are rounded to one
    return {points.front(), points.front(), 0};
  }
  const Capsule along_edge = capsule_along(longest, points);
  const Point chord = points.back() - points.front();
  if (chord == Point{0, 0}) {
    return along_edge;
  }
  const Capsule along_chord = capsule_along(chord, points);
  return along_edge.radius < along_chord.radius ? along_edge : along_chord;
}

}  // namespace

std::vector<CapsuleBlock> build_capsules(const ChainTree& tree, std::span<const Point> ring) {
  constexpr std::uint32_t width = ChainTree::width;
  const std::size_t n = ring.size() - 1;
  std::vector<CapsuleBlock> capsules(tree.blocks.size());
  std::size_t chain = 1;  // edges below a node
  for (std::size_t depth = tree.first_block.size(); depth-- > 0; chain *= width) {
    for (std::size_t node = 0; node * chain < n; ++node) {
      const std::size_t first = node * chain;
      const std::size_t edges = std::min(chain, n - first);
      const Capsule capsule = capsule_of_chain(ring.subspan(first, edges + 1));
      CapsuleBlock& block = capsules[tree.first_block[depth] + node / width];
      const std::size_t lane = node % width;
      block.x0[lane] = capsule.from.x;
      block.y0[lane] = capsule.from.y;
      block.x1[lane] = capsule.to.x;
      block.y1[lane] = capsule.to.y;
      block.radius[lane] = capsule.radius;
    }
  }
  return capsules;
}

}  // namespace gcv
