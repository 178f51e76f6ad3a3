// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What snap rounding promises, in fractions: of polylines that cross, touch and overlap
// themselves, at all magnitudes.
#include "snap_rounding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "exact_rings.hpp"
#include "generators.hpp"
#include "units.hpp"

namespace gcv {
namespace {

using invariants::Exact;
using invariants::Rational;
using test::exact;
using test::Random;
using test::scaled;
using test::uniform;

std::optional<SnapRoundedRing> snapped(const PointVector& polyline) {
  Tally tally;
  return snap_round(polyline, tally);
}

// A unit that has a half.
Point unit_of(const PointVector& polyline) {
  const Point unit = units_in_last_place(polyline);
  return {std::max(unit.x, 0x1p-1073), std::max(unit.y, 0x1p-1073)};
}

bool is_on_grid(const PointVector& ring, const Point& unit) {
  return std::all_of(ring.begin(), ring.end(), [&](const Point& p) {
    return std::fmod(p.x, unit.x) == 0 && std::fmod(p.y, unit.y) == 0;
  });
}

void expect_promises(const PointVector& polyline) {
  const auto result = snapped(polyline);
  ASSERT_TRUE(result);
  const Point unit = unit_of(polyline);
  const invariants::Ring ring = exact(result->vertices);
  const invariants::Ring line = exact(polyline);
  EXPECT_TRUE(test::is_simple_and_counter_clockwise(ring));
  EXPECT_TRUE(is_on_grid(result->vertices, unit));
  EXPECT_TRUE(test::are_within(ring, line, result->error_bound));
  // Of the polyline, much may be left out; the ring adds nothing.
  EXPECT_TRUE(invariants::all_edges_near(ring, line, std::hypot(unit.x, unit.y), ring.size()));
}

// The vertices, and bounds on the error: at least as far as something is left out, and four units
// more at most.
void expect_ring(const PointVector& polyline, const PointVector& ring, double left_out) {
  const auto result = snapped(polyline);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->vertices, ring);
  EXPECT_GE(result->error_bound, left_out);
  const Point unit = unit_of(polyline);
  EXPECT_LE(result->error_bound, left_out + 4 * (unit.x + unit.y));
  expect_promises(polyline);
}

const PointVector square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

// The unit is 1, and many segments pass corners of four pixels that are hot: two that cross there,
// as do the diagonals of the first polyline, and more.
TEST(SnapRounding, TellsPixelsAtCornersApart) {
  const Point right{0x1p52, 1};
  const Point above{1, 0x1p52};
  expect_promises({right, above, {-0.25, -0.25}, {1.25, 1.25}, {1.25, -0.25}, {-0.25, 1.25}});
  Random random(7);
  for (int k = 0; k < 2000; ++k) {
    PointVector polyline{right, above};
    while (polyline.size() < 10) {
      const Point p{uniform(random, -4, 12) / 4.0, uniform(random, -4, 12) / 4.0};
      if (!(p == polyline.back())) {
        polyline.push_back(p);
      }
    }
    SCOPED_TRACE(k);
    expect_promises(polyline);
  }
}

TEST(SnapRounding, LeavesSimpleRingsAsTheyAre) {
  expect_ring(square, square, 0);
  const PointVector clockwise(square.rbegin(), square.rend());
  expect_ring(clockwise, square, 0);
  Random random(1);
  for (int k = 0; k < 20; ++k) {
    const PointVector ring = test::random_small_integer_polygon(random, 12, 9);
    const auto result = snapped(ring);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->vertices.size(), ring.size());
    EXPECT_EQ(abs(invariants::twice_area(exact(ring))),
              invariants::twice_area(exact(result->vertices)));
    expect_promises(ring);
  }
}

TEST(SnapRounding, TakesTheLargerLobeOfAnEight) {
  expect_ring({{0, 0}, {6, 6}, {6, -2}, {0, 4}}, {{2, 2}, {6, -2}, {6, 6}}, std::sqrt(8.0));
  expect_ring({{-6, 6}, {-6, -2}, {0, 4}, {0, 0}}, {{-6, -2}, {-2, 2}, {-6, 6}}, std::sqrt(8.0));
}

// Areas that no double holds.
TEST(SnapRounding, TakesTheLargerLobeAtAllMagnitudes) {
  const PointVector eight{{0, 0}, {6, 6}, {6, -2}, {0, 4}};
  const PointVector lobe{{2, 2}, {6, -2}, {6, 6}};
  for (const int x : {-1073, -600, 0, 600, 1021}) {
    for (const int y : {-1073, -600, 0, 600, 1021}) {
      SCOPED_TRACE(testing::Message() << x << ", " << y);
      const auto result = snapped(scaled(eight, x, y));
      ASSERT_TRUE(result);
      EXPECT_EQ(result->vertices, scaled(lobe, x, y));
      const auto turned = snapped(test::negated(scaled(eight, x, y)));
      ASSERT_TRUE(turned);
      EXPECT_EQ(turned->vertices, test::negated(scaled({{6, 6}, {2, 2}, {6, -2}}, x, y)));
    }
  }
}

// A crossing of edges of few bits, in a ring so long that its pixels are much longer than they are.
TEST(SnapRounding, FindsTheCrossingOfTinyEdgesInHugePixels) {
  constexpr double u = 0x1p-60;
  constexpr double far = 0x1p120;
  expect_ring({{0, 0}, {6 * u, 6 * u}, {0, 4 * u}, {6 * u, -2 * u}, {6 * u, far}, {0, far}},
              {{0, 0}, {2 * u, 0}, {6 * u, 0}, {6 * u, far}, {0, far}}, 0);
  expect_ring({{0, 0}, {6 * u, 6 * u}, {4 * u, 0}, {-2 * u, 6 * u}, {far, 6 * u}, {far, 0}},
              {{0, 0}, {far, 0}, {far, 6 * u}, {0, 6 * u}, {0, 2 * u}}, 0);
}

TEST(SnapRounding, LeavesOutWhatRunsForthAndBack) {
  // Outside, inside, and both along an edge.
  expect_ring({{0, 0}, {4, 0}, {8, 0}, {4, 0}, {4, 4}, {0, 4}}, square, 4);
  expect_ring({{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 1}, {2, 4}, {0, 4}},
              {{0, 0}, {4, 0}, {4, 4}, {2, 4}, {0, 4}}, 3);
  expect_ring({{0, 0}, {3, 0}, {1, 0}, {4, 0}, {4, 4}, {0, 4}},
              {{0, 0}, {1, 0}, {3, 0}, {4, 0}, {4, 4}, {0, 4}}, 0);
}

TEST(SnapRounding, GoesOnceRoundWhatIsPassedTwice) {
  PointVector twice = square;
  twice.insert(twice.end(), square.begin(), square.end());
  expect_ring(twice, square, 0);
  // Two rectangles with a part of an edge in common, one clockwise.
  expect_ring({{0, 0}, {0, 4}, {4, 4}, {4, 1}, {4, 3}, {6, 3}, {6, 1}, {4, 1}, {4, 0}},
              {{0, 0}, {4, 0}, {4, 1}, {6, 1}, {6, 3}, {4, 3}, {4, 4}, {0, 4}}, 2);
}

TEST(SnapRounding, TakesTheLargestOfLoopsThatTouch) {
  // In corners: 2, 4 and 3 wide.
  expect_ring({{0, 0},
               {2, 0},
               {2, 2},
               {6, 2},
               {6, 6},
               {9, 6},
               {9, 9},
               {6, 9},
               {6, 6},
               {2, 6},
               {2, 2},
               {0, 2}},
              {{2, 2}, {6, 2}, {6, 6}, {2, 6}}, std::sqrt(18.0));
  // One inside the other.
  expect_ring({{0, 0}, {1, 2}, {2, 1}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}, square, std::sqrt(5.0));
}

TEST(SnapRounding, IsNothingWhereThereIsNoArea) {
  EXPECT_FALSE(snapped({}));
  EXPECT_FALSE(snapped({{1, 1}}));
  EXPECT_FALSE(snapped({{1, 1}, {2, 2}}));
  EXPECT_FALSE(snapped({{0, 0}, {2, 2}, {1, 1}}));
  EXPECT_FALSE(snapped({{0, 0}, {3, 5}, {0, 0}, {-5, 3}}));
  EXPECT_FALSE(snapped({{5, 5}, {5, 5}, {5, 5}}));
  // Less than half a unit high.
  EXPECT_FALSE(snapped({{0, 0}, {4, 0}, {4, 0x1p-60}, {0, 0x1p-60}, {-1, 0x1p10}, {0, 0}}));
  EXPECT_FALSE(snapped({{0, 0}, {0x1p-1074, 0}, {0, 0x1p-1074}, {0, 0}}));
}

// In tenths, so that crossings lie anywhere; moved by a few units in the last place, so that
// edges nearly coincide; in another place.
PointVector random_polyline(Random& random, int vertices, int extent) {
  PointVector polyline;
  const double origin = uniform(random, 0, 1) * 1000;
  while (static_cast<int>(polyline.size()) < vertices) {
    const auto coordinate = [&] {
      const double x = origin + uniform(random, 0, extent) / 10.0;
      return x + uniform(random, -1, 1) * 0x1p-52 * x;
    };
    const Point p{coordinate(), coordinate()};
    if (polyline.empty() || !(p == polyline.back() || p == polyline.front())) {
      polyline.push_back(p);
    }
  }
  return polyline;
}

TEST(SnapRounding, KeepsItsPromises) {
  Random random(2);
  for (int k = 0; k < 150; ++k) {
    SCOPED_TRACE(k);
    expect_promises(random_polyline(random, uniform(random, 5, 16), k % 3 == 0 ? 100 : 4));
  }
}

TEST(SnapRounding, KeepsItsPromisesAtAllMagnitudes) {
  Random random(3);
  for (const int x : {-1072, -1050, -1000, 0, 1000}) {
    for (const int y : {-1072, -1050, -1000, 0, 1000}) {
      for (int k = 0; k < 3; ++k) {
        SCOPED_TRACE(testing::Message() << x << ", " << y << ", " << k);
        PointVector polyline = scaled(random_polyline(random, 9, 90), x, y);
        polyline.erase(std::unique(polyline.begin(), polyline.end()), polyline.end());
        expect_promises(polyline);
      }
    }
  }
  constexpr double largest = std::numeric_limits<double>::max();
  const auto edge =
      snapped({{-largest, -largest}, {largest, largest}, {largest, -1}, {1, largest}});
  ASSERT_TRUE(edge);
  EXPECT_TRUE(test::is_simple_and_counter_clockwise(exact(edge->vertices)));
}

// Round the origin several times, always in the same sense: what is left is the outline.
TEST(SnapRounding, KeepsTheOutlineOfStars) {
  Random random(4);
  for (int k = 0; k < 40; ++k) {
    SCOPED_TRACE(k);
    const int vertices = 2 * uniform(random, 3, 12) + 1;
    PointVector star;
    for (int i = 0; i < vertices; ++i) {
      const double angle = 2 * std::numbers::pi * i * (vertices / 2) / vertices;
      const double radius = 1 + uniform(random, 0, 99) / 1000.0;
      star.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    const auto result = snapped(star);
    ASSERT_TRUE(result);
    expect_promises(star);
    const Point unit = unit_of(star);
    const invariants::Ring ring = exact(result->vertices);
    for (const Exact& p : exact(star)) {
      EXPECT_TRUE(invariants::location(ring, p) >= 0 ||
                  invariants::all_near({p}, ring, 2 * std::hypot(unit.x, unit.y)));
    }
  }
}

// How often the polyline goes round the point, which is not on it.
int winding_number(const invariants::Ring& polyline, const Exact& x) {
  int number = 0;
  for (std::size_t k = 0; k < polyline.size(); ++k) {
    const Exact& p = polyline[k];
    const Exact& q = invariants::next(polyline, k);
    if ((p.y <= x.y) != (q.y <= x.y) && (invariants::orientation(p, q, x) > 0) == (p.y < q.y)) {
      number += p.y < q.y ? 1 : -1;
    }
  }
  return number;
}

// Just outside of each edge, the polyline goes round nothing; just inside of some, it does.
TEST(SnapRounding, IsTheBoundaryOfTheUnboundedFace) {
  Random random(5);
  for (int k = 0; k < 100; ++k) {
    SCOPED_TRACE(k);
    PointVector polyline;
    for (int i = uniform(random, 5, 12); i > 0; --i) {
      polyline.push_back({static_cast<double>(uniform(random, 0, 9)),
                          static_cast<double>(2 * uniform(random, 0, 9) + i % 2)});
    }
    const invariants::Ring line = exact(polyline);
    const auto result = snapped(polyline);
    ASSERT_TRUE(result);
    const invariants::Ring ring = exact(result->vertices);
    int inside = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Exact along = invariants::next(ring, i) - ring[i];
      const Exact middle = ring[i] + Rational(0.5) * along;
      const Exact outwards = Rational(0x1p-30) * Exact{along.y, -along.x};
      EXPECT_EQ(winding_number(line, middle + outwards), 0);
      inside += winding_number(line, middle - outwards) != 0 ? 1 : 0;
    }
    EXPECT_GT(inside, 0);
  }
}

TEST(SnapRounding, DoesNotDependOnTheOrderOfTheEdges) {
  Random random(6);
  for (int k = 0; k < 30; ++k) {
    PointVector polyline = random_polyline(random, 14, 20);
    const auto first = snapped(polyline);
    ASSERT_TRUE(first);
    for (int turn = 0; turn < 3; ++turn) {
      std::rotate(polyline.begin(), polyline.begin() + 5, polyline.end());
      std::reverse(polyline.begin(), polyline.end());
      const auto again = snapped(polyline);
      ASSERT_TRUE(again);
      EXPECT_EQ(again->vertices, first->vertices);
      EXPECT_EQ(again->error_bound, first->error_bound);
    }
  }
}

}  // namespace
}  // namespace gcv
