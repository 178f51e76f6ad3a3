// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Polygons that are so far apart that their distances in doubles are all alike: the nearest
// features are those of all pairs of an edge and a vertex, and few of these are looked at.
#include "far_pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>

#include "boundary.hpp"
#include "distance.hpp"
#include "generators.hpp"
#include "polygon_pair.hpp"

namespace gcv {
namespace {

// No pair of an edge and a vertex is nearer than what was found.
void expect_nearest(const PlacedPair& placed, const Gap& found, Tally& tally) {
  for (Index i = 0; i < placed.a.boundary.size(); ++i) {
    for (Index j = 0; j < placed.b.boundary.size(); ++j) {
      for (const ContactKind kind : {ContactKind::edge_vertex, ContactKind::vertex_edge}) {
        const EdgeAndVertex pair = edge_and_vertex(placed, {kind, i, j});
        ASSERT_LE(compare_gaps(found, gap_between(pair, nearest_on(pair, tally)), tally), 0);
      }
    }
  }
}

TEST(FarPairs, HaveTheNearestFeatures) {
  test::Random random(5);
  Tally tally;
  std::size_t most_pairs = 0;
  for (int k = 0; k < 300; ++k) {
    SCOPED_TRACE(std::to_string(k));
    const Boundary a =
        make_ring(test::random_spiky_star(random, test::uniform(random, 3, 40)), "a");
    const Boundary b =
        make_ring(test::random_spiky_star(random, test::uniform(random, 3, 40)), "b");
    const PolygonPair polygons(a, b);
    const int exponent = test::uniform(random, 60, 900);
    const double x = std::ldexp(test::uniform(random, -9, 9), exponent);
    const double y = std::ldexp(test::uniform(random, 1, 9), exponent);
    const PlacedPair placed(polygons, {x, y});
    ASSERT_TRUE(are_far_apart(placed));
    most_pairs = std::max(most_pairs, nearest_of_far_pair(placed).size());
    const NearestOfPair nearest = nearest_of_pair(placed, infinity, tally);
    ASSERT_EQ(nearest.relation, Relation::apart);
    ASSERT_TRUE(nearest.features);
    expect_nearest(placed, nearest.features->gap, tally);
  }
  EXPECT_LE(most_pairs, 16U);  // of up to 3,200
}

// Squares that face each other exactly, in directions that round. All along the facing edges, u v
// is the same.
TEST(FarPairs, OfSquaresThatFaceEachOther) {
  Tally tally;
  for (const Point& way :
       {Point{3, 4}, Point{4, -3}, Point{-5, 12}, Point{-15, -8}, Point{7, 24}}) {
    for (const double aside : {0.0, 0.25, -0.5, 1.5}) {
      SCOPED_TRACE(std::to_string(way.x) + " " + std::to_string(aside));
      const auto square = [&](double shift) {
        const auto at = [&](double along, double left) {
          return Point{along * way.x - left * way.y, along * way.y + left * way.x};
        };
        return make_ring({at(0, shift), at(1, shift), at(1, shift + 1), at(0, shift + 1)},
                         "square");
      };
      const Boundary a = square(0);
      const Boundary b = square(aside);
      const PolygonPair polygons(a, b);
      const PlacedPair placed(polygons, {way.x * 0x1p70, way.y * 0x1p70});
      ASSERT_TRUE(are_far_apart(placed));
      expect_nearest(placed, nearest_of_pair(placed, infinity, tally).features->gap, tally);
    }
  }
}

TEST(FarPairs, AreMuchFartherThanLarge) {
  const Boundary a = make_ring({{0, 0}, {4, 0}, {0, 3}}, "a");
  const PolygonPair polygons(a, a);
  EXPECT_FALSE(are_far_apart(PlacedPair(polygons, {0x1p44, 0})));
  EXPECT_TRUE(are_far_apart(PlacedPair(polygons, {0, -0x1p48})));
  EXPECT_FALSE(are_far_apart(PlacedPair(polygons, {0x1.fffffffffffffp1023, 0}, {-0x1p1023, 0})));
}

}  // namespace
}  // namespace gcv
