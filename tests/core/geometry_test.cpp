// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Boxes and their order on a curve, vectors, keys of directions, units in the last place and areas,
// in fractions.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "area.hpp"
#include "box.hpp"
#include "curve_order.hpp"
#include "direction_key.hpp"
#include "exact_rings.hpp"
#include "generators.hpp"
#include "numbers.hpp"
#include "units.hpp"
#include "vector.hpp"

namespace gcv {
namespace {

using invariants::Exact;
using test::exact;
using test::Random;
using test::Rational;
using test::rational;
using test::scaled;
using test::uniform;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

// ------------------------------------------------------------------------------- boxes --

void expect_box(const Box& box, const Box& expected) {
  EXPECT_EQ(box.x0, expected.x0);
  EXPECT_EQ(box.y0, expected.y0);
  EXPECT_EQ(box.x1, expected.x1);
  EXPECT_EQ(box.y1, expected.y1);
}

TEST(Box, OfPoints) {
  const PointVector points{{2, -1}, {0, 5}, {-3, 4}, {1, -largest}, {smallest, 0}};
  expect_box(box_of(points), {-3, -largest, 2, 5});
  expect_box(box_of(std::span(points).first(1)), {2, -1, 2, -1});
  expect_box(box_of(points[0], points[1]), {0, -1, 2, 5});
  expect_box(box_of(points[1], points[0]), {0, -1, 2, 5});
  expect_box(hull_of({0, 1, 2, 3}, {-1, 2, 1, 7}), {-1, 1, 2, 7});
  expect_box(hull_of(empty_box, {0, 1, 2, 3}), {0, 1, 2, 3});
  expect_box(hull_of({0, 1, 2, 3}, empty_box), {0, 1, 2, 3});
  expect_box(widened({0, 1, 2, 3}, 0.5), {-0.5, 0.5, 2.5, 3.5});
}

TEST(Box, IsApartOfOthers) {
  const Box box{0, 0, 2, 2};
  for (const Box& other :
       {Box{2, 2, 3, 3}, Box{-1, 1, 0, 1}, Box{1, 1, 1, 1}, Box{-9, -9, 9, 9}, Box{1, -5, 1, 0}}) {
    EXPECT_FALSE(are_apart(box, other));
    EXPECT_FALSE(are_apart(other, box));
  }
  for (const Box& other : {Box{2 + 0x1p-50, 0, 3, 2}, Box{-1, 0, -smallest, 2}, Box{0, 3, 2, 4},
                           Box{0, -2, 2, -1}, empty_box}) {
    EXPECT_TRUE(are_apart(box, other));
    EXPECT_TRUE(are_apart(other, box));
  }
  // What has overflowed may be anywhere.
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(are_apart(box, {nan, nan, nan, nan}));
  EXPECT_FALSE(are_apart(box, {-infinity, 0, infinity, 1}));
}

// The curve visits all squares of a row of rows, and goes from each to one beside it. `size` is
// that of the squares, on the grid of 2^16 x 2^16.
void expect_curve_through_squares(double size) {
  constexpr std::uint32_t side = 64;
  constexpr Box bounds{0, 0, 65536, 65536};
  const double area = size * size;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> squares(side * side, {side, side});
  for (std::uint32_t x = 0; x < side; ++x) {
    for (std::uint32_t y = 0; y < side; ++y) {
      const Point middle{(x + 0.5) * size, (y + 0.5) * size};
      const std::uint32_t place = place_on_curve({middle.x, middle.y, middle.x, middle.y}, bounds);
      squares.at(static_cast<std::size_t>(place / area)) = {x, y};
    }
  }
  EXPECT_EQ(squares.front(), std::pair(0U, 0U));
  for (std::size_t k = 1; k < squares.size(); ++k) {
    const auto [x0, y0] = squares[k - 1];
    const auto [x1, y1] = squares[k];
    const auto distance = [](std::uint32_t p, std::uint32_t q) { return p < q ? q - p : p - q; };
    ASSERT_LT(x1, side) << "square " << k << " is left out";
    ASSERT_EQ(distance(x0, x1) + distance(y0, y1), 1) << "square " << k;
  }
}

TEST(CurveOrder, GoesFromEachSquareToOneBesideIt) {
  for (const double size : {1.0, 2.0, 4.0, 8.0, 16.0, 256.0, 512.0, 1024.0}) {
    SCOPED_TRACE(size);
    expect_curve_through_squares(size);
  }
}

// ------------------------------------------------------------------------------ vectors --

TEST(Vector, DirectionDoesNotOverflow) {
  const auto expect = [](const Point& p, const Point& q, const Point& expected) {
    EXPECT_EQ(direction(p, q), expected);
    EXPECT_EQ(direction(q, p), (Point{-expected.x, -expected.y}));
  };
  expect({1, 2}, {4, -2}, {3, -4});
  expect({smallest, 0}, {0, smallest}, {-smallest, smallest});
  expect({-largest, 0}, {largest, largest}, {largest / 2, largest / 4});
  expect({0, 0}, {largest, largest}, {largest / 4, largest / 4});
  expect({0, 0}, {largest, 0}, {largest, 0});
}

// Within so many units of 2^-53.
bool is_about(const Rational& x, const Rational& y, int units) {
  return abs(x - y) <= y * units * rational(0x1p-53);
}

TEST(Vector, UnitVectorsHaveLengthOne) {
  Random random(1);
  for (int k = 0; k < 3000; ++k) {
    test::Attack attack(random);
    const Point d = direction(attack.point(), attack.point());
    const Point unit = unit_vector(d);
    if (d == Point{0, 0}) {
      EXPECT_TRUE(std::isnan(unit.x) && std::isnan(unit.y));
      continue;
    }
    const Exact exact_unit = exact(unit);
    const Exact exact_d = exact(d);
    ASSERT_TRUE(is_about(invariants::dot(exact_unit, exact_unit), 1, 11));
    // It points the same way: the sine is a few units at most.
    const Rational cross = invariants::cross(exact_d, exact_unit);
    ASSERT_GT(invariants::dot(exact_d, exact_unit), 0);
    ASSERT_LE(cross * cross,
              invariants::dot(exact_d, exact_d) * rational(0x1p-102) * rational(1.0001));
  }
}

TEST(Vector, NextUpIsTheNextDouble) {
  Random random(2);
  for (int k = 0; k < 1000; ++k) {
    const double x = std::abs(test::attacking_double(random));
    ASSERT_EQ(next_up(x), std::nextafter(x, infinity));
  }
  EXPECT_EQ(next_up(0.0), smallest);
  EXPECT_EQ(next_up(-0.0), smallest);
  EXPECT_EQ(next_up(largest), infinity);
  EXPECT_EQ(next_up(infinity), infinity);
}

TEST(Vector, LengthBoundsAreBounds) {
  Random random(3);
  for (int k = 0; k < 5000; ++k) {
    test::Attack attack(random);
    const double x = attack.number();
    const double y = k % 5 == 0 ? x : attack.number();
    const double bound = length_bound(x, y);
    if (!std::isfinite(bound)) {
      ASSERT_GT(std::hypot(x / 4, y / 4), largest / 4.0001);
      continue;
    }
    const Rational square = rational(x) * rational(x) + rational(y) * rational(y);
    ASSERT_GE(rational(bound) * rational(bound), square);
    // Not much more: relatively, or by two of the smallest doubles.
    const Rational less = rational(bound) * rational(1 - 0x1p-48) - 2 * rational(smallest);
    ASSERT_TRUE(less <= 0 || less * less <= square);
  }
  EXPECT_EQ(length_bound(-3, 0), 3);
  EXPECT_EQ(length_bound(0, largest), largest);
  EXPECT_EQ(length_bound(0, 0), 0);
}

// --------------------------------------------------------------------------- directions --

// Keys of directions up: whatever they tell is true.
TEST(DirectionKey, IsInOrderWhereItTells) {
  Random random(4);
  int told = 0;
  for (int k = 0; k < 20000; ++k) {
    test::Attack attack(random);
    PointVector p{attack.point(), attack.point()};
    PointVector q{attack.point(), attack.point()};
    if (k % 2 == 0) {  // nearly the same
      q = p;
      q[1].x = std::nextafter(q[1].x, uniform(random, 0, 1) == 0 ? infinity : -infinity);
    }
    if (p[0] == p[1] || q[0] == q[1] || !std::isfinite(q[1].x)) {
      continue;
    }
    for (PointVector* const way : {&p, &q}) {
      if (!points_up((*way)[0], (*way)[1])) {
        std::swap((*way)[0], (*way)[1]);
      }
    }
    const int order = compare_keys(direction_key(p[0], p[1]), direction_key(q[0], q[1]));
    EXPECT_EQ(compare_keys(direction_key(q[0], q[1]), direction_key(p[0], p[1])), -order);
    if (order != 0) {
      ++told;
      ASSERT_EQ(order, invariants::sign(invariants::cross(exact(p[1]) - exact(p[0]),
                                                          exact(q[1]) - exact(q[0]))));
    }
  }
  EXPECT_GT(told, 5000);
}

// -------------------------------------------------------------------------------- units --

TEST(Units, AreDistancesToTheNextDouble) {
  EXPECT_EQ(unit_in_last_place(1), 0x1p-52);
  EXPECT_EQ(unit_in_last_place(-1.5), 0x1p-52);
  EXPECT_EQ(unit_in_last_place(2), 0x1p-51);
  EXPECT_EQ(unit_in_last_place(0), smallest);
  EXPECT_EQ(unit_in_last_place(-0x1p-1022), smallest);
  EXPECT_EQ(unit_in_last_place(largest), 0x1p971);
  EXPECT_EQ(units_in_last_place({{1, 0}, {-4, 0.5}, {3, -0.75}}), (Point{0x1p-50, 0x1p-53}));
  EXPECT_EQ(sum_bound(0, 0.1), 0.1);
  EXPECT_EQ(sum_bound(0.1, 0), 0.1);
  EXPECT_EQ(sum_bound(largest, largest), infinity);
  Random random(5);
  for (int k = 0; k < 1000; ++k) {
    const double x = std::abs(test::attacking_double(random));
    const double y = std::abs(test::attacking_double(random));
    const double bound = sum_bound(x, y);
    ASSERT_TRUE(bound == infinity || rational(bound) >= rational(x) + rational(y));
  }
}

// The square of the distance of p from the segment ab.
Rational square_of_distance(const Exact& p, const Exact& a, const Exact& b) {
  const auto dot = [](const Exact& v, const Exact& w) { return Rational(v.x * w.x + v.y * w.y); };
  const Exact d = b - a;
  const Rational along = dot(p - a, d);
  const Rational square = dot(d, d);
  const Rational t = along <= 0 ? Rational(0) : along >= square ? Rational(1) : along / square;
  const Exact off = p - (a + t * d);
  return dot(off, off);
}

TEST(Units, BoundDistancesFromSegments) {
  Random random(6);
  int inside = 0;
  for (int k = 0; k < 4000; ++k) {
    const int exponent = k % 2 == 0 ? 0 : uniform(random, -1070, 1000);
    const auto coordinate = [&] {
      const double x = uniform(random, -30, 30);
      return std::ldexp(uniform(random, 0, 1) == 0 ? x : x / 7, exponent);
    };
    const auto point = [&] {
      const double x = coordinate();
      return Point{x, coordinate()};
    };
    const Point p = point();
    const Point a = point();
    const Point b = k % 10 == 0 ? a : point();
    const Point units = units_in_last_place({p, a, b});
    const double unit = std::max(units.x, units.y);
    const Rational bound = rational(distance_bound(p, a, b, unit));
    const Rational square = square_of_distance(exact(p), exact(a), exact(b));
    ASSERT_GE(bound * bound, square);
    const Rational rest = bound - 32 * rational(unit);
    ASSERT_TRUE(rest <= 0 || rest * rest <= square);
    inside += rest > 0 ? 1 : 0;
  }
  EXPECT_GT(inside, 3000);
}

// -------------------------------------------------------------------------------- areas --

void expect_area(const PointVector& ring) {
  const Rational area = invariants::twice_area(exact(ring)) / 2;
  ASSERT_EQ(ring_area(ring), invariants::nearest(area));
}

TEST(Area, IsNearestInTies) {
  // Next to 1, halfway between two doubles, below and above.
  const double unit = 0x1p-52;
  for (const double height : {1.0, 1 + unit, 1 + 2 * unit, 1 + 3 * unit}) {
    // Of a square without a triangle, or with one, of half a unit.
    expect_area({{0, 0}, {1, 0}, {1, height}, {0, height - unit}});
    expect_area({{0, 0}, {1, 0}, {1, height}, {0, height + unit}});
  }
  EXPECT_EQ(ring_area(PointVector{{0, 0}, {1, 0}, {1, 1}, {0, 1 + unit}}), 1);
  EXPECT_EQ(ring_area(PointVector{{0, 0}, {1, 0}, {1, 1 + unit}, {0, 1 + 2 * unit}}), 1 + 2 * unit);
}

TEST(Area, IsNearestOfAllRings) {
  Random random(6);
  for (int k = 0; k < 300; ++k) {
    PointVector ring = test::random_spiky_star(random, 3 + k % 12);
    for (Point& p : ring) {
      p = {p.x + (k % 3 == 0 ? 0x1p60 : 0), p.y - (k % 5 == 0 ? 1e9 : 0)};
    }
    expect_area(ring);
    const PointVector polygon = test::random_small_integer_polygon(random, 8, 9);
    const PointVector up = test::polygon_of(polygon)->vertices;
    expect_area(up);
    // Turned round, it is negative.
    EXPECT_EQ(ring_area(PointVector(up.rbegin(), up.rend())), -ring_area(up));
  }
}

// Sizes so far apart that their products take integers of all widths.
TEST(Area, IsNearestOfNumbersFarApart) {
  Random random(8);
  for (int apart = 0; apart < 500; ++apart) {
    const PointVector ring{{-uniform(random, 1, 9) / 7.0, uniform(random, 0, 9) / 7.0},
                           {std::ldexp(uniform(random, 1, 9) / 7.0, apart), 0},
                           {uniform(random, 1, 9) / 7.0, std::ldexp(1 / 3.0, apart)}};
    expect_area(ring);
    expect_area(scaled(ring, -apart));
  }
}

TEST(Area, UnderflowsAndOverflows) {
  Random random(7);
  for (const int exponent : {-1074, -600, -545, -542, -530, 500}) {
    for (int k = 0; k < 20; ++k) {
      expect_area(scaled(test::random_spiky_star(random, 9), exponent));
      expect_area(scaled(test::random_spiky_star(random, 9), -1060, exponent + 500));
    }
  }
  const PointVector square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(ring_area(scaled(square, 512)), infinity);
  EXPECT_EQ(ring_area(scaled(square, 1023, -1074)), 0x1p-51);
  EXPECT_EQ(ring_area(scaled(square, 511, 512)), 0x1p1023);
  EXPECT_EQ(ring_area(scaled(square, -537)), smallest);
  EXPECT_EQ(ring_area(scaled(square, -537, -538)), 0);  // half of it: a tie
  EXPECT_EQ(ring_area(PointVector{{0, 0}, {0x1p-537, 0}, {0x1p-537, 0x1.8p-538}, {0, 0x1.8p-538}}),
            smallest);
  EXPECT_EQ(ring_area(PointVector{{-largest, -largest}, {largest, -largest}, {0, largest}}),
            infinity);
}

}  // namespace
}  // namespace gcv
