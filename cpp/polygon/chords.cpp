// SPDX-License-Identifier: LGPL-3.0-or-later
#include "chords.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "vector.hpp"

namespace gcv {

namespace {

// The largest distance of the points from the segment between the first and the last one.
double radius_of(std::span<const Point> points) {
  const Point& from = points.front();
  const Point chord{points.back().x - from.x, points.back().y - from.y};
  const bool is_point = chord == Point{0, 0};
  const Point unit = is_point ? Point{0, 0} : unit_vector(chord);
  const double length = unit.x * chord.x + unit.y * chord.y;
  double radius = 0;
  for (const Point& p : points.subspan(1, points.size() - 2)) {
    const double dx = p.x - from.x;
    const double dy = p.y - from.y;
    const double along = unit.x * dx + unit.y * dy;
    const double beyond = along - std::min(std::max(along, 0.0), length);
    const double across = is_point ? length_bound(dx, dy) : unit.x * dy - unit.y * dx;
    radius = std::max(radius, beyond == 0 ? std::abs(across) : length_bound(beyond, across));
  }
  return radius;
}

}  // namespace

std::vector<ChordBlock> build_chords(const ChainTree& tree, const EdgeChain& chain,
                                     const RingLayout& layout) {
  constexpr std::uint32_t width = ChainTree::width;
  const std::size_t n = chain.size();
  std::vector<ChordBlock> chords(tree.blocks.size());
  std::size_t below = 1;  // edges below a node
  for (std::size_t depth = tree.first_block.size(); depth-- > 0; below *= width) {
    for (std::size_t node = 0; node * below < n; ++node) {
      const auto first = static_cast<Index>(node * below);
      const auto last = static_cast<Index>(std::min(node * below + below, n) - 1);
      const std::span<const Point> points = chain.ends(first, last - first + 1);
      const bool is_chain = layout.ring_of(first) == layout.ring_of(last);
      ChordBlock& block = chords[tree.first_block[depth] + node / width];
      const std::size_t lane = node % width;
      block.put(static_cast<std::uint32_t>(lane), points.front(), points.back());
      block.radius[lane] =
          is_chain ? radius_of(points) : std::numeric_limits<double>::infinity();
      block.length[lane] = length_bound(points.back().x - points.front().x,
                                        points.back().y - points.front().y);
    }
  }
  return chords;
}

}  // namespace gcv
