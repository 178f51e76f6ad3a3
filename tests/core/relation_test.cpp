// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What makes relations quick, beside what is exact: edges that are told apart in doubles, edges
// that are asked first, and sides of convex polygons in doubles.
#include "relation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "generators.hpp"
#include "region_families.hpp"
#include "regions.hpp"
#include "relative_pair.hpp"

namespace gcv {
namespace {

test::PolygonRings scaled(test::PolygonRings rings, double scale) {
  for (PointVector& ring : rings) {
    for (Point& p : ring) {
      p = {scale * p.x, scale * p.y};
    }
  }
  return rings;
}

// Calls check(pair, random, size) for polygons full of ties, of that scale, that are up to so
// large.
void for_each_pair(int cases, double scale,
                   const std::function<void(const PolygonPair&, test::Random&, double)>& check) {
  for (const test::RegionFamily& family : test::region_families()) {
    test::Random random(5);
    for (int k = 0; k < cases; ++k) {
      const test::RegionCase c = family.next_case(random);
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(k));
      const RegionOperand a = test::region_operand(scaled(c.a, scale), "a");
      const RegionOperand b = test::region_operand(scaled(c.b, scale), "b");
      const PolygonPair pair(*a.polygon, *b.polygon);
      check(pair, random, extents_of(sum_of(pair.a.boundary.bounds, pair.b.boundary.bounds)));
    }
  }
}

// Multiples of a part of the size, and now and then what is next to one.
Point translation(test::Random& random, double size) {
  const auto coordinate = [&] {
    const double multiple = size * test::uniform(random, -24, 24) / 48;
    return test::uniform(random, 0, 3) == 0 ? std::nextafter(multiple, size) : multiple;
  };
  const double x = coordinate();
  return {x, coordinate()};
}

// Do two edges have a point in common?
bool meet(const PlacedPair& placed, Index i, Index j) {
  Tally tally;
  const SumEdge p = placed.a.edge(i);
  const SumEdge q = placed.b.edge(j);
  const SumPoint p_end = placed.a.vertex(placed.a.next(i));
  const SumPoint q_end = placed.b.vertex(placed.b.next(j));
  const auto are_apart = [&](const SumEdge& s, const SumPoint& from, const SumPoint& to) {
    return side(s, from, tally) * side(s, to, tally) > 0;
  };
  return !are_apart(p, q.origin, q_end) && !are_apart(q, p.origin, p_end);
}

struct Counts {
  int meeting = 0;
  int apart = 0;
  int told_apart = 0;
};

void check_pair(const PlacedPair& placed, Counts& counts) {
  const RelativePair relative(placed);
  const Index of_a = placed.a.boundary.size();
  const Index of_b = placed.b.boundary.size();
  for (Index i = 0; i < of_a; ++i) {
    for (Index j = 0; j < of_b; ++j) {
      // As one of the edges of a block of A, and of a block of B.
      constexpr Index width = ChainTree::width;
      const auto may_cross = [&](const auto& edges, Index lane) {
        const unsigned lanes =
            relative.may_cross(relative.edges_of_a(edges), relative.edges_of_b(edges));
        return (lanes >> lane & 1U) != 0;
      };
      const bool may =
          may_cross(EdgesOfBlock<true>{placed.a.boundary.index(), i / width, j}, i % width);
      EXPECT_EQ(may_cross(EdgesOfBlock<false>{placed.b.boundary.index(), j / width, i}, j % width),
                may);
      if (meet(placed, i, j)) {
        ++counts.meeting;
        EXPECT_TRUE(may) << i << ' ' << j;
      } else {
        ++counts.apart;
        counts.told_apart += may ? 0 : 1;
      }
    }
  }
}

TEST(RelativePair, KeepsNoEdgesApartThatMeet) {
  for (const double scale : {1.0, 0x1p900, 0x1p1017, 0x1p-900, 0x1p-1062}) {
    SCOPED_TRACE(scale);
    Counts counts;
    for_each_pair(150, scale, [&](const PolygonPair& pair, test::Random& random, double size) {
      const Point moved_by = scale == 1 ? translation(random, 4 * size) : Point{0, 0};
      const Point other = translation(random, size);
      check_pair({pair, moved_by, {moved_by.x + other.x, moved_by.y + other.y}}, counts);
    });
    EXPECT_GT(counts.meeting, 200);
    // Roundings of subnormal numbers are as large as the edges. Extents of huge ones overflow.
    if (scale > 0x1p-1000 && scale < 0x1p1000) {
      EXPECT_GT(counts.told_apart, counts.apart * 3 / 4);
    }
  }
}

TEST(NearbyRelations, AreThoseOfEachTranslation) {
  int found[3] = {};
  for_each_pair(1000, 1, [&](const PolygonPair& pair, test::Random& random, double size) {
    Tally tally;
    const auto index = [&](Index size_of) {
      return static_cast<Index>(test::uniform(random, 0, static_cast<int>(size_of) - 1));
    };
    std::optional<EdgePair> edges;
    if (test::uniform(random, 0, 1) == 0) {
      edges = {index(pair.a.boundary.size()), index(pair.b.boundary.size())};
    }
    NearbyRelations relations(pair, {0, 0}, edges, tally);
    Point at = translation(random, size);
    for (int k = 0; k < 12; ++k) {
      const Relation expected = relation(PlacedPair(pair, at), tally);
      EXPECT_EQ(relations.at(at), expected) << at.x << ' ' << at.y;
      ++found[static_cast<int>(expected) + 1];
      at = k % 4 == 3 ? translation(random, size)
                      : Point{at.x, std::nextafter(at.y, k % 2 == 0 ? size : -size)};
    }
  });
  for (const int count : found) {
    EXPECT_GT(count, 500);
  }
}

// At the corners of the square that it tells of, and on its sides.
TEST(NearbyRelations, OverlapAroundWhereTheySaySo) {
  int certain = 0;
  int uncertain = 0;
  for_each_pair(1000, 1, [&](const PolygonPair& pair, test::Random& random, double size) {
    Tally tally;
    const Point moved_a = translation(random, 4 * size);
    const Point other = translation(random, size);
    const Point at{moved_a.x + other.x, moved_a.y + other.y};
    NearbyRelations relations(pair, moved_a, {}, tally);
    if (relations.at(at) != Relation::overlapping) {
      return;
    }
    for (const double moved_by : {0x1p-50 * size, 0x1p-20 * size, size / 64, size / 8}) {
      if (!relations.overlaps_around(at, moved_by)) {
        ++uncertain;
        continue;
      }
      ++certain;
      for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
          const Point near{at.x + x * moved_by, at.y + y * moved_by};
          EXPECT_EQ(relation(PlacedPair(pair, moved_a, near), tally), Relation::overlapping)
              << near.x << ' ' << near.y;
        }
      }
    }
  });
  EXPECT_GT(certain, 2000);
  EXPECT_GT(uncertain, 1000);
}

// Of edges in which another ring touches, whatever they cross.
TEST(NearbyRelations, DoNotTellWhereRingsTouch) {
  const test::PolygonRings diamonds{{{0, 0}, {4, 0}, {4, 4}, {0, 4}},
                                    {{2, 0}, {1, 1}, {2, 2}, {3, 1}}};
  const RegionOperand a = test::region_operand(diamonds, "a");
  Tally tally;
  const PolygonPair pair(*a.polygon, *a.polygon);
  for (Index i = 0; i < a.polygon->boundary().size(); ++i) {
    for (Index j = 0; j < a.polygon->boundary().size(); ++j) {
      const bool touch = !pair.a.touches.on(i).empty() || !pair.b.touches.on(j).empty();
      const NearbyRelations relations(pair, {0, 0}, EdgePair{i, j}, tally);
      for (const double y : {0.25, -0.25}) {
        EXPECT_FALSE(touch && relations.overlaps_around({0.5, y}, 0));
      }
    }
  }
}

double real(test::Random& random, double low, double high) {
  return low + (high - low) * test::uniform(random, 0, 1 << 30) * 0x1p-30;
}

// Of an ellipse: so many vertices, or fewer. Not always convex, for it is rounded.
RegionOperand random_convex(test::Random& random, int vertices, double scale) {
  constexpr double full_turn = 6.283185307179586;
  const double width = scale * real(random, 0.01, 1);
  const Point middle{scale * real(random, -4, 4), scale * real(random, -4, 4)};
  std::vector<double> angles;
  for (int k = 0; k < vertices; ++k) {
    angles.push_back(real(random, 0, full_turn));
  }
  std::sort(angles.begin(), angles.end());
  PointVector ring;
  for (const double angle : angles) {
    ring.push_back({middle.x + width * std::cos(angle), middle.y + scale * std::sin(angle)});
  }
  return test::region_operand({ring}, "convex");
}

// By all vertices beside all edges: apart if one edge has all of the other polygon strictly on its
// right.
Relation relation_by_sides(const PlacedPair& placed) {
  Tally tally;
  int least = 1;
  const auto look = [&](const PlacedPolygon& polygon, const PlacedPolygon& other) {
    for (Index i = 0; i < polygon.boundary.size(); ++i) {
      int most = -1;
      for (Index j = 0; j < other.boundary.size(); ++j) {
        most = std::max(most, side(polygon.edge(i), other.vertex(j), tally));
      }
      least = std::min(least, most);
    }
  };
  look(placed.a, placed.b);
  look(placed.b, placed.a);
  return static_cast<Relation>(-least);
}

// A vertex of B is put on an edge of A, or next to it, as near as doubles can. Mostly it is the one
// that is furthest on its left.
TEST(ConvexRelation, IsThatOfAllSides) {
  for (const double scale : {1.0, 0x1p520, 0x1p1000, 0x1p-515, 0x1p-1000}) {
    SCOPED_TRACE(scale);
    test::Random random(11);
    int found[3] = {};
    for (int k = 0; k < 1500; ++k) {
      const bool is_small_beside_large = k % 8 == 0;
      const auto size = [&](int other) {
        return is_small_beside_large ? other : test::uniform(random, 3, 24);
      };
      const RegionOperand a = random_convex(random, size(41), scale);
      const RegionOperand b = random_convex(random, size(3), scale);
      const PolygonPair pair(*a.polygon, *b.polygon);
      if (!pair.a.boundary.is_convex || !pair.b.boundary.is_convex) {
        continue;
      }
      const PointVector& of_a = pair.a.boundary.vertices;
      const PointVector& of_b = pair.b.boundary.vertices;
      const auto index = [&](const PointVector& vertices) {
        return static_cast<Index>(test::uniform(random, 0, static_cast<int>(vertices.size()) - 1));
      };
      const Index i = index(of_a);
      const Point& from = of_a[i];
      const Point& to = of_a[pair.a.boundary.next(i)];
      const Point along{(to.x - from.x) / scale, (to.y - from.y) / scale};
      const Point& leftmost =
          *std::max_element(of_b.begin(), of_b.end(), [&](const Point& p, const Point& q) {
            return along.x * (q.y - p.y) - along.y * (q.x - p.x) > 0;
          });
      const Point& vertex = test::uniform(random, 0, 3) == 0 ? of_b[index(of_b)] : leftmost;
      const double t = test::uniform(random, 0, 3) == 0 ? 0 : real(random, 0, 1);
      Point at{from.x + t * (to.x - from.x) - vertex.x, from.y + t * (to.y - from.y) - vertex.y};
      const Point moved_by = test::uniform(random, 0, 1) == 0 ? Point{0, 0} : of_b[0];
      at = {at.x + moved_by.x, at.y + moved_by.y};
      for (int step = 0; step < 4; ++step) {
        const PlacedPair placed(pair, moved_by, at);
        Tally tally;
        const Relation got = relation(placed, tally);
        EXPECT_EQ(got, relation_by_sides(placed)) << k << ' ' << step;
        ++found[static_cast<int>(got) + 1];
        at.x = std::nextafter(at.x, step % 2 == 0 ? -infinity : infinity);
        at.y = std::nextafter(at.y, step < 2 ? infinity : -infinity);
      }
    }
    EXPECT_GT(found[0], 1000);
    EXPECT_GT(found[1], 50);
    EXPECT_GT(found[2], 1000);
  }
}

}  // namespace
}  // namespace gcv
