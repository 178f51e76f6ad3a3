// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Chord trees against the chains that they are built over.
#include "chord_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "boundary.hpp"
#include "generators.hpp"
#include "polygon.hpp"
#include "region_families.hpp"

namespace gcv {
namespace {

class Checker {
 public:
  explicit Checker(const Boundary& boundary)
      : boundary_(boundary), tree_(boundary.cover_index().chords), seen_(boundary.size()) {}

  void check() {
    ASSERT_EQ(tree_.blocks.front().lanes, 1U);
    const Range all = edges_below(ChordTree::root, boundary_.size());
    EXPECT_EQ(all.first, 0U);
    EXPECT_EQ(all.size, boundary_.size());
    for (const int count : seen_) {
      EXPECT_EQ(count, 1);
    }
  }

 private:
  struct Range {
    Index first;
    Index size;
  };

  // Checks a node and those below it.
  Range edges_below(ChordTree::Node node, Index most) {
    Range range{0, 0};
    if (tree_.is_edge(node)) {
      range = {tree_.below(node), 1};
      ++seen_[range.first];
    } else {
      const std::uint32_t below = tree_.below(node);
      EXPECT_GT(below, node / ChordTree::width);
      EXPECT_LT(below, tree_.blocks.size());
      const unsigned lanes = tree_.blocks[below].lanes;
      EXPECT_TRUE(lanes == 3 || lanes == 7 || lanes == 15);
      for (std::uint32_t lane = 0; (lanes >> lane) != 0; ++lane) {
        const Range child = edges_below(ChordTree::node(below, lane), most);
        EXPECT_TRUE(range.size == 0 || child.first == range.first + range.size);
        range = {range.size == 0 ? child.first : range.first, range.size + child.size};
      }
    }
    check_node(node, range);
    return range;
  }

  void check_node(ChordTree::Node node, const Range& range) {
    const ChordTree::Block& block = tree_.block_of(node);
    const std::uint32_t lane = ChordTree::lane_of(node);
    const Index last = range.first + range.size - 1;
    const Point from = boundary_.relative(range.first);
    const Point to = boundary_.relative(boundary_.next(last));
    EXPECT_EQ((Point{block.x0[lane], block.y0[lane]}), from);
    EXPECT_EQ((Point{block.x1[lane], block.y1[lane]}), to);
    const Box box = block.boxes.box(lane);
    const bool is_chain = boundary_.layout.ring_of(range.first) == boundary_.layout.ring_of(last);
    const double extents =
        boundary_.bounds.x1 - boundary_.bounds.x0 + boundary_.bounds.y1 - boundary_.bounds.y0;
    for (Index i = range.first; i <= last; ++i) {
      for (const Point& p : {boundary_.relative(i), boundary_.relative(boundary_.next(i))}) {
        EXPECT_TRUE(box.x0 <= p.x && p.x <= box.x1 && box.y0 <= p.y && p.y <= box.y1);
        if (is_chain) {
          EXPECT_LE(distance(from, to, p), block.radius[lane] + 0x1p-48 * extents);
        }
      }
    }
    if (is_chain) {
      EXPECT_NEAR(block.length[lane], std::hypot(to.x - from.x, to.y - from.y), 0x1p-48 * extents);
    } else {
      EXPECT_EQ(block.radius[lane], std::numeric_limits<double>::infinity());
    }
    if (range.size == 1) {
      EXPECT_EQ(block.radius[lane], 0);
      EXPECT_LT(block.extent[lane], 0);
    } else {
      EXPECT_EQ(block.extent[lane], (box.x1 - box.x0) + (box.y1 - box.y0));
    }
  }

  static double distance(const Point& p, const Point& q, const Point& x) {
    const double dx = q.x - p.x;
    const double dy = q.y - p.y;
    const double squared = dx * dx + dy * dy;
    const double t =
        squared == 0 ? 0
                     : std::fmin(1, std::fmax(0, ((x.x - p.x) * dx + (x.y - p.y) * dy) / squared));
    return std::hypot(x.x - p.x - t * dx, x.y - p.y - t * dy);
  }

  const Boundary& boundary_;
  const ChordTree& tree_;
  std::vector<int> seen_;
};

TEST(ChordTree, HoldsAllChainsOfARing) {
  test::Random random(301);
  for (int k = 0; k < 60; ++k) {
    const test::Ring ring = k % 3 == 0   ? test::random_small_integer_polygon(random, 3 + k % 12, 6)
                            : k % 3 == 1 ? test::random_histogram(random, 1 + k, 9)
                                         : test::random_spiky_star(random, 4 + 5 * k);
    const Boundary boundary = make_ring(ring, "polygon");
    Checker(boundary).check();
  }
}

TEST(ChordTree, HoldsAllRings) {
  test::Random random(302);
  std::size_t rings = 0;
  for (int k = 0; k < 60; ++k) {
    const test::RegionCase c = test::with_holes(random);
    for (const test::Rings& operand : {c.a, c.b}) {
      const Polygon polygon = make_polygon(operand, "polygon");
      rings += polygon.ring_count() - 1;
      Checker(polygon.boundary()).check();
    }
  }
  EXPECT_GT(rings, 30U);
}

// How far the edges below a node lead, and the edge before them.
using Ways = std::vector<std::pair<double, double>>;

// Calls visit(ways, sizes of the children) for all nodes of more than one edge.
template <class Visit>
std::pair<Index, Index> for_each_chain(const Boundary& boundary, ChordTree::Node node,
                                       const Visit& visit) {
  const ChordTree& tree = boundary.cover_index().chords;
  const std::uint32_t below = tree.below(node);
  if (tree.is_edge(node)) {
    return {below, 1};
  }
  std::vector<Index> sizes;
  Index first = 0;
  Index size = 0;
  for (std::uint32_t lane = 0; (tree.blocks[below].lanes >> lane) != 0; ++lane) {
    const auto [begin, count] = for_each_chain(boundary, ChordTree::node(below, lane), visit);
    first = lane == 0 ? begin : first;
    sizes.push_back(count);
    size += count;
  }
  Ways ways;
  for (Index i = first; i < first + size; ++i) {
    const Point& p = boundary.vertices[i];
    const Point& q = boundary.vertices[boundary.next(i)];
    ways.emplace_back(q.x - p.x, q.y - p.y);
  }
  visit(ways, sizes);
  return {first, size};
}

// A comb of so many teeth, with as many holes that are combs.
Polygon comb(int teeth, int holes) {
  const auto add_teeth = [&](PointVector& ring, double y) {
    for (int k = teeth - 1; k >= 0; --k) {
      const double x = 2 * k;
      ring.insert(ring.end(), {{x + 1, y + 5}, {x, y + 5}});
      if (k > 0) {
        ring.insert(ring.end(), {{x, y}, {x - 1, y}});
      }
    }
  };
  test::Rings rings(1);
  rings[0] = {{-1, -10.0 * holes - 2}, {2.0 * teeth, -10.0 * holes - 2}};
  add_teeth(rings[0], 0);
  for (int k = 1; k <= holes; ++k) {
    PointVector ring{{0, -10.0 * k}, {2.0 * teeth - 1, -10.0 * k}};
    add_teeth(ring, -10.0 * k + 2);
    rings.emplace_back(ring.rbegin(), ring.rend());
  }
  return make_polygon(rings, "comb");
}

TEST(ChordTree, SplitsEqualChainsAlike) {
  for (const auto& [teeth, holes] : {std::pair{100, 0}, {33, 0}, {250, 0}, {40, 3}}) {
    const Polygon polygon = comb(teeth, holes);
    const Boundary& boundary = polygon.boundary();
    Checker(boundary).check();
    ASSERT_TRUE(boundary.cover_index().chords.chains_repeat);
    std::map<Ways, std::set<std::vector<Index>>> cuts;
    std::size_t nodes = 0;
    for_each_chain(boundary, ChordTree::root,
                   [&](const Ways& ways, const std::vector<Index>& sizes) {
                     cuts[ways].insert(sizes);
                     ++nodes;
                   });
    std::size_t kinds = 0;
    for (const auto& [ways, sizes] : cuts) {
      kinds += sizes.size();
    }
    EXPECT_LT(kinds, 16 + 20U * holes) << nodes;
    EXPECT_GT(nodes, 3U * kinds / 2) << kinds;
  }
  test::Random random(303);
  for (int k = 0; k < 20; ++k) {
    const Boundary boundary = make_ring(test::random_histogram(random, 60 + k, 99), "histogram");
    EXPECT_FALSE(boundary.cover_index().chords.chains_repeat);
  }
}

// A half circle is split in its middle, though most of its vertices are near one end.
TEST(ChordTree, SplitsWhereAChainIsFurthestFromItsChord) {
  const Boundary boundary = make_ring(
      {{0, 0}, {1, -1}, {2, -2}, {3, -3}, {50, -40}, {100, 0}, {50, 30}, {20, 14}}, "polygon");
  const ChordTree& tree = boundary.cover_index().chords;
  const ChordTree::Block& halves = tree.blocks[tree.below(ChordTree::root)];
  // The cut is where the halves of the root meet: between its second and third child.
  EXPECT_EQ((Point{halves.x0[2], halves.y0[2]}), (Point{100, 0}));
}

// Distances and extents are no numbers there. The tree is whole all the same.
TEST(ChordTree, OfTheLargestNumbers) {
  const double large = 1.7e308;
  const Boundary boundary = make_ring(
      {{-large, -large}, {large, -large}, {large, large}, {0, 1}, {-large, large}}, "polygon");
  const ChordTree& tree = boundary.cover_index().chords;
  std::size_t edges = 0;
  for (const ChordTree::Block& block : tree.blocks) {
    for (std::uint32_t lane = 0; lane < ChordTree::width; ++lane) {
      if ((block.lanes >> lane & 1U) != 0) {
        EXPECT_FALSE(std::isnan(block.extent[lane]));
        edges += block.extent[lane] < 0 ? 1U : 0U;
      }
    }
  }
  EXPECT_EQ(edges, boundary.size());
}

}  // namespace
}  // namespace gcv
