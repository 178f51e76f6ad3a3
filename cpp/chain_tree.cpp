// SPDX-License-Identifier: LGPL-3.0-or-later
#include "chain_tree.hpp"

namespace gcv {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Box nothing{infinity, infinity, -infinity, -infinity};

Box join(const Box& a, const Box& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

Box join(const ChainTree::Block& block) {
  return join(join(block.box(0), block.box(1)), join(block.box(2), block.box(3)));
}

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

Box box_of(const Point& p, const Point& q) {
  return {std::min(p.x, q.x), std::min(p.y, q.y), std::max(p.x, q.x), std::max(p.y, q.y)};
}

ChainTree build_chain_tree(std::span<const Box> edges) {
  constexpr std::uint32_t width = ChainTree::width;
  ChainTree tree;
  std::vector<std::uint32_t> counts;  // of the blocks of each depth, from the edges up
  auto count = static_cast<std::uint32_t>(edges.size());
  do {
    count = (count + width - 1) / width;
    counts.push_back(count);
  } while (count > 1);
  std::uint32_t total = 0;
  for (std::size_t depth = counts.size(); depth-- > 0;) {
    tree.first_block.push_back(total);
    total += counts[depth];
  }
  tree.blocks.resize(total);
  const auto fill = [&](std::uint32_t first, std::uint32_t blocks, std::size_t lanes,
                        const auto& box) {
    for (std::uint32_t k = 0; k < blocks * width; ++k) {
      tree.blocks[first + k / width].put(k % width, k < lanes ? box(k) : nothing);
    }
  };
  fill(tree.first_block.back(), counts.front(), edges.size(),
       [&](std::uint32_t k) { return edges[k]; });
  for (std::size_t level = 1; level < counts.size(); ++level) {
    const std::size_t depth = counts.size() - 1 - level;
    fill(tree.first_block[depth], counts[level], counts[level - 1],
         [&](std::uint32_t k) { return join(tree.blocks[tree.first_block[depth + 1] + k]); });
  }
  tree.box = join(tree.blocks.front());
  return tree;
}

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

ChainTree build_chain_tree(std::span<const Point> ring) {
  std::vector<Box> edges;
  edges.reserve(ring.size());
  for (std::size_t k = 0; k < ring.size(); ++k) {
    edges.push_back(box_of(ring[k], ring[k + 1 == ring.size() ? 0 : k + 1]));
  }
  return build_chain_tree(edges);
}

}  // namespace gcv
