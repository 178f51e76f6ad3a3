// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The order of a tree over edges: that of the boundary, or that of a curve.
#include "chain_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "boundary.hpp"
#include "generators.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Ring;

// The way in and out again of a spiral of so many turns, of so many edges each.
Ring spiral(int turns, int edges) {
  Ring ring;
  Ring back;
  for (int k = 0; k <= turns * edges; ++k) {
    const double angle = 2 * M_PI * k / edges;
    const double radius = 10 + angle;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    back.push_back({(radius - 2) * std::cos(angle), (radius - 2) * std::sin(angle)});
  }
  ring.insert(ring.end(), back.rbegin(), back.rend());
  return ring;
}

bool holds(const SweptSphereBlock& spheres, std::uint32_t lane, const Point& p) {
  const double dx = spheres.x1[lane] - spheres.x0[lane];
  const double dy = spheres.y1[lane] - spheres.y0[lane];
  const double length = std::hypot(dx, dy);
  const double x = p.x - spheres.x0[lane];
  const double y = p.y - spheres.y0[lane];
  constexpr double room = 1e-9;
  return std::abs(dx * y - dy * x) <= (spheres.radius[lane] + room) * length + room &&
         dx * x + dy * y >= -room * length && dx * x + dy * y <= (length + room) * length;
}

// Is each edge below each node in the sphere of the node?
void expect_spheres_hold_edges(const Boundary& polygon, const ChainIndex& index) {
  constexpr std::uint32_t width = ChainTree::width;
  const std::vector<std::uint32_t>& first_block = index.tree.first_block;
  for (Index number = 0; number < polygon.size(); ++number) {
    const Index edge = index.edge(number);
    for (std::size_t depth = 0; depth < first_block.size(); ++depth) {
      const std::uint32_t node = number >> 2 * (first_block.size() - 1 - depth);
      const SweptSphereBlock& spheres = index.spheres[first_block[depth] + node / width];
      EXPECT_TRUE(holds(spheres, node % width, polygon.relative(edge)));
      EXPECT_TRUE(holds(spheres, node % width, polygon.relative(polygon.next(edge))));
    }
  }
}

// Are spreads the extents of nodes beyond those of the longest edges below them?
void expect_spreads(const Boundary& polygon, const ChainIndex& index) {
  const std::size_t depths = index.tree.first_block.size();
  std::vector<std::vector<double>> longest(depths, std::vector<double>(polygon.size()));
  const auto node_of = [&](Index number, std::size_t depth) {
    return static_cast<std::uint32_t>(number >> 2 * (depths - 1 - depth));
  };
  for (Index number = 0; number < polygon.size(); ++number) {
    const Index edge = index.edge(number);
    const Box box = box_of(polygon.relative(edge), polygon.relative(polygon.next(edge)));
    for (std::size_t depth = 0; depth < depths; ++depth) {
      double& most = longest[depth][node_of(number, depth)];
      most = std::max(most, extents_of(box));
    }
  }
  for (Index number = 0; number < polygon.size(); ++number) {
    for (std::size_t depth = 0; depth < depths; ++depth) {
      const std::uint32_t node = node_of(number, depth);
      const std::uint32_t block = index.tree.first_block[depth] + node / ChainTree::width;
      const double extents = extents_of(index.tree.blocks[block].box(node % ChainTree::width));
      EXPECT_EQ(index.spread({static_cast<std::uint32_t>(depth) + 1, node}),
                extents - longest[depth][node]);
    }
  }
}

TEST(ChainIndex, TakesTheCurveForSpirals) {
  for (const int edges : {5, 40}) {
    const Boundary polygon = make_ring(spiral(60, edges), "spiral");
    const ChainIndex& index = polygon.search_index();
    ASSERT_EQ(index.order.size(), polygon.size());
    std::vector<Index> order = index.order;
    std::sort(order.begin(), order.end());
    for (Index k = 0; k < polygon.size(); ++k) {
      EXPECT_EQ(order[k], k);
    }
    expect_spheres_hold_edges(polygon, index);
    expect_spreads(polygon, index);
    EXPECT_TRUE(polygon.index().order.empty());
    expect_spheres_hold_edges(polygon, polygon.index());
    expect_spreads(polygon, polygon.index());
  }
}

TEST(ChainIndex, KeepsTheOrderOfTheBoundary) {
  Random random(3);
  const Ring spikes = [] {
    Ring ring;
    for (int k = 0; k < 2000; ++k) {
      const double radius = k % 2 == 0 ? 1 : 0.001;
      ring.push_back({radius * std::cos(M_PI * k / 1000), radius * std::sin(M_PI * k / 1000)});
    }
    return ring;
  }();
  for (const Ring& ring : {spikes, spiral(4, 200), test::random_histogram(random, 500, 200)}) {
    const Boundary polygon = make_ring(ring, "polygon");
    EXPECT_EQ(&polygon.search_index(), &polygon.index());
  }
}

}  // namespace
}  // namespace gcv
