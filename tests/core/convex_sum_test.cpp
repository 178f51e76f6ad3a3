// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The merged edges of two convex polygons against the hull of the sums of all their vertices, in
// fractions.
#include "convex_sum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "exact_rings.hpp"
#include "generators.hpp"

namespace gcv {
namespace {

using invariants::Exact;
using test::exact;
using test::Random;
using test::scaled;
using test::uniform;

using PolygonPointer = decltype(test::polygon_of({}));

invariants::Ring hull_of_sums(const PointVector& a, const PointVector& b) {
  invariants::Ring sums;
  for (const Exact& p : exact(a)) {
    for (const Exact& q : exact(b)) {
      sums.push_back(p + q);
    }
  }
  return invariants::hull(sums);
}

struct ExactEdge {
  Exact from;
  Exact to;
};

ExactEdge exact_edge(const PolygonPointer& a, const PolygonPointer& b, const EdgeName& name) {
  const SumEdge edge = coordinates(*a, *b, name);
  const Exact from = exact(edge.origin.a) + exact(edge.origin.b);
  return {from, from + (exact(edge.to) - exact(edge.from))};
}

bool is_same_direction(const Exact& d, const Exact& e) {
  return invariants::cross(d, e) == 0 && invariants::dot(d, e) > 0;
}

void expect_sum(const PolygonPointer& a, const PolygonPointer& b) {
  ASSERT_TRUE(a->is_convex);
  ASSERT_TRUE(b->is_convex);
  Tally tally;
  const Walk walk = merge_convex(*a, *b, tally);
  const invariants::Ring expected = hull_of_sums(a->vertices, b->vertices);
  ASSERT_EQ(walk.vertices.size(), expected.size());
  EXPECT_EQ(walk.steps, expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const RingVertex& v = walk.vertices[k];
    ASSERT_TRUE(v.is_sum());
    ASSERT_EQ(exact(a->vertices[v.i()]) + exact(b->vertices[v.j()]), expected[k]);
    const ExactEdge leaving = exact_edge(a, b, v.leaving());
    const ExactEdge arriving = exact_edge(a, b, v.arriving());
    ASSERT_EQ(leaving.from, expected[k]);
    ASSERT_EQ(arriving.to, expected[k]);
    ASSERT_TRUE(
        is_same_direction(leaving.to - leaving.from, invariants::next(expected, k) - expected[k]));
    ASSERT_TRUE(is_same_direction(arriving.to - arriving.from,
                                  expected[k] - invariants::previous(expected, k)));
  }
}

void expect_sum(const PointVector& a, const PointVector& b) {
  const auto polygon_a = test::polygon_of(a);
  const auto polygon_b = test::polygon_of(b);
  expect_sum(polygon_a, polygon_b);
  expect_sum(polygon_b, polygon_a);
  // Their smallest vertices are not their first ones.
  expect_sum(std::make_shared<const gcv::Boundary>(gcv::Boundary::reflected(polygon_a)), polygon_b);
}

// The hull of some points of a grid, each moved by a unit in the last place now and then.
PointVector random_convex(Random& random, int extent, bool nudge) {
  while (true) {
    invariants::Ring points;
    for (int k = uniform(random, 3, 20); k > 0; --k) {
      Point p{1.0 + uniform(random, 0, extent), 1.0 + uniform(random, 0, extent)};
      if (nudge) {
        p.x += uniform(random, -1, 1) * std::ldexp(1, std::ilogb(p.x) - 52);
        p.y += uniform(random, -1, 1) * std::ldexp(1, std::ilogb(p.y) - 52);
      }
      points.push_back(exact(p));
    }
    const invariants::Ring hull = invariants::hull(points);
    PointVector ring;
    for (const Exact& p : hull) {
      ring.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
    }
    if (ring.size() >= 3) {
      return ring;
    }
  }
}

const PointVector triangle{{0, 0}, {4, 1}, {2, 5}};
const PointVector square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(ConvexSum, OfAPolygonWithItself) {
  expect_sum(triangle, triangle);
  expect_sum(square, square);
  const auto polygon = test::polygon_of(triangle);
  Tally tally;
  const Walk walk = merge_convex(*polygon, *polygon, tally);
  ASSERT_EQ(walk.vertices.size(), 3U);
  for (Index k = 0; k < 3; ++k) {
    EXPECT_EQ(walk.vertices[k].i(), k);
    EXPECT_EQ(walk.vertices[k].j(), k);
  }
}

TEST(ConvexSum, OfAPolygonWithItsReflection) {
  const auto polygon = test::polygon_of(triangle);
  const auto reflection = test::polygon_of(test::negated(triangle));
  expect_sum(triangle, test::negated(triangle));
  Tally tally;
  EXPECT_EQ(merge_convex(*polygon, *reflection, tally).vertices.size(), 6U);
}

TEST(ConvexSum, OfGridPolygonsWithManyParallelEdges) {
  Random random(1);
  for (int k = 0; k < 300; ++k) {
    expect_sum(random_convex(random, 6, false), random_convex(random, k % 2 == 0 ? 6 : 40, false));
  }
}

TEST(ConvexSum, OfPolygonsWithNearlyParallelEdges) {
  Random random(2);
  for (int k = 0; k < 150; ++k) {
    const PointVector a = random_convex(random, 6, true);
    const PointVector b = random_convex(random, 6, true);
    expect_sum(a, b);
    expect_sum(a, test::negated(a));
    expect_sum(a, scaled(b, k - 75));
  }
}

TEST(ConvexSum, OfPolygonsOfAllMagnitudes) {
  Random random(3);
  for (const int x : {-1070, -500, 0, 500, 1015}) {
    for (const int y : {-1070, 0, 1015}) {
      const PointVector a = random_convex(random, 30, false);
      const PointVector b = random_convex(random, 30, false);
      expect_sum(scaled(a, x, y), scaled(b, x, y));
      expect_sum(scaled(a, x), scaled(b, y));
    }
  }
}

}  // namespace
}  // namespace gcv
