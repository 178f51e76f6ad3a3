// SPDX-License-Identifier: LGPL-3.0-or-later
#include "capsules.hpp"

#include <algorithm>

namespace gcv {

namespace {

// At least the distance of p from the segment from..to: it is that to a point of the segment.
// The roundings, some units in the last place of the coordinates, are made good where the
// radius is used.
double distance_bound(const Point& p, const Point& from, const Point& to) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double x = p.x - from.x;
  const double y = p.y - from.y;
  const double foot = (x * dx + y * dy) / (dx * dx + dy * dy);
  const double t = foot > 0 ? std::min(foot, 1.0) : 0.0;
  return length_bound(x - t * dx, y - t * dy);
}

}  // namespace

std::vector<CapsuleBlock> build_capsules(const ChainTree& tree, std::span<const Point> ring) {
  constexpr std::uint32_t width = ChainTree::width;
  const std::size_t n = ring.size();
  std::vector<CapsuleBlock> capsules(tree.blocks.size());
  std::size_t chain = 1;  // edges below a node
  for (std::size_t depth = tree.first_block.size(); depth-- > 0; chain *= width) {
    std::size_t first = 0;
    for (std::size_t k = tree.first_block[depth]; first < n; ++k) {
      CapsuleBlock& block = capsules[k];
      const auto put_end = [&](std::uint32_t end, const Point& p) {
        block.x[end] = p.x;
        block.y[end] = p.y;
      };
      put_end(0, ring[first]);
      for (std::uint32_t lane = 0; lane < width; ++lane) {
        const std::size_t last = std::min(first + chain, n);
        const Point& from = ring[first];
        const Point& to = ring[last == n ? 0 : last];
        double radius = 0;
        for (std::size_t i = first + 1; i < last; ++i) {
          radius = std::max(radius, distance_bound(ring[i], from, to));
        }
        put_end(lane + 1, to);
        block.radius[lane] = radius;
        first = last;
        if (first == n) {
          break;
        }
      }
    }
  }
  return capsules;
}

}  // namespace gcv
