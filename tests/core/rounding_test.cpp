// SPDX-License-Identifier: LGPL-3.0-or-later
#include "rounding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "area.hpp"
#include "double_double_rounding.hpp"
#include "error.hpp"
#include "generators.hpp"
#include "minkowski_sum.hpp"
#include "numbers.hpp"
#include "ring_predicates.hpp"
#include "simplicity.hpp"
#include "to_double.hpp"
#include "vector.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Rational;
using test::rational;
using test::Ring;

Rational power_of_two(int exponent) {
  const BigInteger power = BigInteger(1) << std::abs(exponent);
  return exponent < 0 ? Rational(1) / Rational(power) : Rational(power);
}

// Is `value` the double nearest to x, ties to even?
void expect_nearest(double value, const Rational& x) {
  const auto error = [&](double y) { return Rational(abs(rational(y) - x)); };
  for (const double neighbour :
       {std::nextafter(value, HUGE_VAL), std::nextafter(value, -HUGE_VAL)}) {
    if (std::isfinite(neighbour)) {
      ASSERT_LE(error(value), error(neighbour));
      if (error(value) == error(neighbour)) {
        ASSERT_EQ(std::bit_cast<std::uint64_t>(value) % 2, 0U);
      }
    }
  }
}

TEST(NearestDouble, IsNearest) {
  Random random(31);
  for (int k = 0; k < 60000; ++k) {
    // Quotients near ties, of all sizes, and random ones.
    std::int64_t n = static_cast<std::int64_t>(random() >> test::uniform(random, 1, 60));
    std::int64_t w = 1 + static_cast<std::int64_t>(random() >> test::uniform(random, 2, 63));
    if (k % 3 == 0) {
      w = 1;
      n = (std::int64_t{1} << 54) + 2 + test::uniform(random, -3, 3);
    }
    if (k % 2 == 0) {
      n = -n;
    }
    const int exponent =
        k % 4 == 0 ? test::uniform(random, -1140, -1000) : test::uniform(random, -200, 200);
    const Rational exact = Rational(n) / Rational(w) * power_of_two(exponent);
    const RoundedNumber by_128 = nearest_double(Int128{n}, Int128{w}, exponent);
    const RoundedNumber by_256 = nearest_double(Int256{n}, Int256{w}, exponent);
    const RoundedNumber by_big = nearest_double(BigInteger{n}, BigInteger{w}, exponent);
    ASSERT_NO_FATAL_FAILURE(expect_nearest(by_128.value, exact));
    ASSERT_EQ(by_128.exact, rational(by_128.value) == exact);
    for (const RoundedNumber& other : {by_256, by_big}) {
      ASSERT_EQ(other.value, by_128.value);
      ASSERT_EQ(other.exact, by_128.exact);
    }
  }
}

TEST(NearestDouble, OverflowsToInfinity) {
  EXPECT_EQ(nearest_double(BigInteger(1), BigInteger(1), 1024).value, HUGE_VAL);
  EXPECT_EQ(nearest_double(BigInteger(-3), BigInteger(1), 1023).value, -HUGE_VAL);
  EXPECT_EQ(nearest_double(Int128{1}, Int128{1}, 1023).value, std::ldexp(1.0, 1023));
}

// Edges of all directions, some as good as parallel, some parallel to an axis, on a grid or not.
class Crossings {
 public:
  explicit Crossings(Random& random) : random_(random) {}

  SumEdge edge(const Point& direction) {
    const SumPoint origin{{number(), number()}, {number(), number()}};
    const Point to{origin.a.x + direction.x, origin.a.y + direction.y};
    return {origin, origin.a, to, to.x - origin.a.x, to.y - origin.a.y};
  }
  Point direction() {
    const int axis = test::uniform(random_, 0, 9);
    return {axis == 0 ? 0 : number(), axis == 1 ? 0 : number()};
  }
  Point near(const Point& direction) {
    const double distance = std::ldexp(1.0, -test::uniform(random_, 0, 60));
    return {0.75 * direction.x + distance * number(), 0.75 * direction.y + distance * number()};
  }
  double number() {
    const double integer = test::uniform(random_, -1000, 1000);
    return test::uniform(random_, 0, 3) == 0 ? integer : integer / 7;
  }

 private:
  Random& random_;
};

bool are_parallel(const Grid& grid, const SumEdge& s, const SumEdge& t) {
  return sign(cross(vector_between<BigInteger>(grid, s.from, s.to),
                    vector_between<BigInteger>(grid, t.from, t.to))) == 0;
}

TEST(RoundedCrossing, IsNearestWhereItIsCertain) {
  Random random(33);
  Crossings crossings(random);
  constexpr int tries = 100000;
  int certain = 0;
  int exact = 0;
  for (int k = 0; k < tries; ++k) {
    const Point direction = crossings.direction();
    const SumEdge s = crossings.edge(direction);
    const SumEdge t =
        crossings.edge(k % 2 == 0 ? crossings.near(direction) : crossings.direction());
    const Point shift{k % 3 == 0 ? crossings.number() : 0, 0};
    const auto rounded = rounded_crossing(s, t, shift);
    Grid grid{shift};
    grid.include(s);
    grid.include(t);
    if (!rounded || are_parallel(grid, s, t)) {
      continue;
    }
    const auto p = crossing<BigInteger>(grid, s, t, shift);
    ++certain;
    exact += rounded->x.exact ? 1 : 0;
    const RoundedNumber x = nearest_double(p.x, p.w, grid.exponent());
    const RoundedNumber y = nearest_double(p.y, p.w, grid.exponent());
    ASSERT_EQ(rounded->x.value, x.value);
    ASSERT_EQ(rounded->y.value, y.value);
    ASSERT_EQ(rounded->x.exact, x.exact);
    ASSERT_EQ(rounded->y.exact, y.exact);
  }
  EXPECT_GT(certain, tries / 2);
  EXPECT_GT(exact, tries / 50);
}

TEST(RoundedCrossing, IsNotCertainWhereParametersAreOutOfRange) {
  Random random(34);
  for (int k = 0; k < 20000; ++k) {
    test::Attack attack(random);
    const SumEdge s = attack.edge();
    const SumEdge t = attack.edge();
    Grid grid;
    grid.include(s);
    grid.include(t);
    const auto rounded = rounded_crossing(s, t, {0, 0});
    if (rounded && !are_parallel(grid, s, t)) {
      const auto p = crossing<BigInteger>(grid, s, t, {0, 0});
      ASSERT_EQ(rounded->x.value, nearest_double(p.x, p.w, grid.exponent()).value);
      ASSERT_EQ(rounded->y.value, nearest_double(p.y, p.w, grid.exponent()).value);
    }
  }
}

Rational fraction(const std::string& text) { return Rational(text); }

std::pair<Rational, Rational> exact_point(const ExactRing& ring, std::size_t k) {
  const std::string text = exact_vertex(ring, k);
  const std::size_t space = text.find(' ');
  return {fraction(text.substr(0, space)), fraction(text.substr(space + 1))};
}

OuterFace sum_of(const Ring& a, const Ring& b, const Point& shift) {
  Task task;
  return minkowski_sum({std::make_shared<gcv::Boundary>(make_ring(a, "a")), "a"},
                       {std::make_shared<gcv::Boundary>(make_ring(b, "b")), "b"}, shift,
                       Rounding::nearest, task);
}

// Edges longer than the largest double, slits at the end of the range that have to be moved
// apart, and sums whose rounding errors are beyond it.
TEST(Rounding, SurvivesTheEndOfTheRange) {
  constexpr double top = 0x1p971;  // a unit in the last place of the largest doubles
  const auto scaled = [](Ring ring, double x, double y) {
    for (Point& p : ring) {
      p = {x + p.x * top, y + p.y * top};
    }
    return ring;
  };
  constexpr double largest = std::numeric_limits<double>::max();
  const std::pair<Ring, Ring> pairs[] = {
      {scaled({{-5.5, -2.5},
               {-3.5, -3.75},
               {-2.75, -3.25},
               {-2.5, -3.5},
               {-2, -2.75},
               {-2, -0.75},
               {-2.5, -1},
               {-2.75, -0.75},
               {-3.5, -1.75},
               {-5.5, -2}},
              0, 0),
       scaled({{-10, -9}, {-8, -15}, {0, -13}, {0, 0}, {-8, -5}, {-10, -4}}, largest, largest)},
      {scaled({{-11, 5},
               {-10, 6},
               {-9, 7},
               {-8, 2},
               {-3, 6},
               {0, 1},
               {0, 11},
               {-3, 9},
               {-8, 11},
               {-9, 10},
               {-10, 8},
               {-11, 14}},
              largest, 0),
       scaled({{-4.5, 0},
               {-4, 0.25},
               {-0.75, 1.75},
               {-0.5, 0},
               {-0.25, 0.75},
               {0, 0.25},
               {0, 2.5},
               {-0.25, 2.25},
               {-0.5, 2.25},
               {-0.75, 3.75},
               {-4, 2.5},
               {-4.5, 3}},
              0, 0)},
      {{{-0x1.ep+1023, -0x1.ep+1023},
        {0x1.ep+1023, -0x1.ep+1023},
        {0x1.ep+1023, 0x1.4dc949203c649p+1022},
        {0x1.04b76d17d33f4p+1022, 0x1.cdf3f7deaea4ep+1022},
        {-0x1.c8p+1023, 0x1.52722a7b01a5dp+1023},
        {-0x1.d666666666666p+1023, 0x1.5515d1f4c621cp+1023},
        {0x1.f0e00781c38e1p+1022, 0x1.a2ab4e02e59d2p+1022},
        {0x1.ep+1023, 0x1.4dc949203c654p+1022},
        {0x1.ep+1023, 0x1.ep+1023},
        {-0x1.ep+1023, 0x1.ep+1023}},
       {{0, 0},
        {0x1.f0915a7c1b0f7p+970, 0x1.33797e9ec67bcp+969},
        {0x1.c7f46442c8d8p+968, 0x1.55bf75632ee69p+970}}}};
  for (const auto& [a, b] : pairs) {
    const OuterFace face = sum_of(a, b, {0, 0});
    EXPECT_FALSE(find_conflict(face.rounded.vertices));
    EXPECT_TRUE(is_counter_clockwise(face.rounded.vertices));
    EXPECT_TRUE(std::isfinite(face.rounded.error_bound));
  }
}

TEST(Rounding, IsNearestWithACertifiedBound) {
  Random random(32);
  int inexact = 0;
  int compared = 0;
  for (int k = 0; k < 1500; ++k) {
    const Ring a = k % 2 == 0 ? test::random_small_integer_polygon(random, 8, 9)
                              : test::random_spiky_star(random, 12);
    const Ring b = test::random_spiky_star(random, 9);
    const Point shift{k % 3 == 0 ? 0.0 : test::uniform(random, -9, 9) / 7.0,
                      k % 5 == 0 ? 1e17 : 0.125};
    const OuterFace face = sum_of(a, b, shift);
    ASSERT_FALSE(find_conflict(face.rounded.vertices));
    ASSERT_TRUE(is_counter_clockwise(face.rounded.vertices));
    const Rational bound = rational(face.rounded.error_bound);
    if (face.rounded.vertices_repaired != 0 || face.rounded.vertices.size() != face.exact.size()) {
      continue;
    }
    ++compared;
    for (std::size_t i = 0; i < face.exact.size(); ++i) {
      const auto [x, y] = exact_point(face.exact, i);
      const Point& p = face.rounded.vertices[i];
      ASSERT_NO_FATAL_FAILURE(expect_nearest(p.x, x));
      ASSERT_NO_FATAL_FAILURE(expect_nearest(p.y, y));
      const Rational dx = rational(p.x) - x;
      const Rational dy = rational(p.y) - y;
      ASSERT_LE(dx * dx + dy * dy, bound * bound);
      inexact += dx != 0 ? 1 : 0;
    }
  }
  EXPECT_GT(inexact, 1000);
  EXPECT_GT(compared, 1000);
}

TEST(Rounding, IsExactOnIntegers) {
  const Ring square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const OuterFace face = sum_of(square, square, {3, -4});
  EXPECT_EQ(face.rounded.vertices, (Ring{{3, -4}, {5, -4}, {5, -2}, {3, -2}}));
  EXPECT_EQ(face.rounded.error_bound, 0);
}

TEST(Rounding, AddsTheShiftBeforeRounding) {
  // 1 + 2^-53 rounds to 1; with -1 added exactly before, 2^-53 is left.
  const double tiny = 0x1p-53;
  const Ring a{{1, 0}, {2, 0}, {1, 1}};
  const Ring b{{tiny, 0}, {1, 0}, {tiny, 1}};
  const OuterFace face = sum_of(a, b, {-1, 0});
  EXPECT_EQ(face.rounded.vertices.front().x, tiny);
}

// A slot, and the square that just goes in, turned by a rational angle. In exact numbers
// the turned square is a little too large or too small; the slit is less than an ulp wide.
OuterFace turned_slot(int m, int n) {
  const double length = static_cast<double>(m) * m + static_cast<double>(n) * n;
  const double c = (static_cast<double>(m) * m - static_cast<double>(n) * n) / length;
  const double s = 2.0 * m * n / length;
  Ring slot{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  Ring square{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}};
  for (Ring* ring : {&slot, &square}) {
    for (Point& p : *ring) {
      p = {c * p.x - s * p.y, s * p.x + c * p.y};
    }
  }
  return sum_of(slot, square, {0, 0});
}

bool nearest_places_are_simple(const ExactRing& ring) {
  Tally tally;
  Task task;
  return !find_conflict(place_nearest(ring, task, tally).places);
}

TEST(Rounding, KeepsSlitsThinnerThanAnUlpOpen) {
  int not_simple = 0;
  int repaired = 0;
  for (int m = 2; m < 60; ++m) {
    for (int n = 1; n < m; ++n) {
      const OuterFace face = turned_slot(m, n);
      ASSERT_FALSE(find_conflict(face.rounded.vertices));
      ASSERT_LE(face.rounded.error_bound, 8 * 0x1p-51);  // coordinates are below 4
      not_simple += nearest_places_are_simple(face.exact) ? 0 : 1;
      repaired += face.rounded.vertices_repaired != 0 ? 1 : 0;
    }
  }
  std::printf("1711 turned slots: %d not simple when rounded to nearest, %d repaired\n", not_simple,
              repaired);
  EXPECT_GT(not_simple, 100);
  EXPECT_GT(repaired, 100);
}

// Two saws whose teeth mesh, turned by an eighth. Of the thousands of edges that nearly lie one on
// the other, chains through closed pixels cross.
TEST(Rounding, KeepsAllOfMeshingSaws) {
  constexpr int teeth = 400;
  const double c = std::cos(std::numbers::pi / 4);
  const double s = std::sin(std::numbers::pi / 4);
  const auto turned = [&](double x, double y) { return Point{c * x - s * y, s * x + c * y}; };
  Ring lower;
  Ring upper;
  for (int k = 0; k < teeth; ++k) {
    for (const double half : {0.0, 0.5}) {
      lower.push_back(turned(k + half, 2 * half));
      upper.push_back(turned(0.5 - (k + half), 2 * half - 1));
    }
  }
  for (const Point& p : {Point{teeth, 0}, Point{teeth, -3}, Point{0, -3}}) {
    lower.push_back(turned(p.x, p.y));
  }
  for (const Point& p : {Point{teeth, 1}, Point{teeth, 3.75}, Point{0, 3.75}}) {
    upper.push_back(turned(0.5 - p.x, -p.y));
  }
  const OuterFace face = sum_of(lower, upper, {0, 0});
  EXPECT_NEAR(ring_area(face.rounded.vertices), 5799, 1e-6);
  EXPECT_LT(face.rounded.error_bound, 1e-11);
}

TEST(Rounding, LeavesTheLargestPartOfWhatIsTooFine) {
  // A star of less than an ulp on the boundary of a huge one; also where no double holds the area.
  Random random(33);
  for (int k = 0; k < 50; ++k) {
    Ring tiny = test::random_spiky_star(random, 20);
    Ring huge = test::random_spiky_star(random, 15);
    const int exponent = 700 * (k % 3 - 1);
    for (Point& p : tiny) {
      p = {std::ldexp(p.x, exponent - 30), std::ldexp(p.y, exponent - 30)};
    }
    for (Point& p : huge) {
      p = {std::ldexp(p.x, exponent + 23), std::ldexp(p.y, exponent + 23)};
    }
    const OuterFace face = sum_of(tiny, huge, {0, 0});
    ASSERT_FALSE(find_conflict(face.rounded.vertices));
    ASSERT_TRUE(is_counter_clockwise(face.rounded.vertices));
    ASSERT_LE(face.rounded.error_bound, std::ldexp(8, exponent - 23));
    ASSERT_GE(ring_area(face.rounded.vertices), ring_area(huge));
  }
}

TEST(Rounding, RefusesWhatIsTooSmallForDoubles) {
  const Ring triangle{{0, 0}, {1, 0}, {0, 1}};
  try {
    sum_of(triangle, triangle, {0x1p60, 0x1p60});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::range);
  }
}

TEST(Rounding, RefusesWhatNoDoubleHolds) {
  const Ring wide{{1e308, 0}, {1.5e308, 0}, {1e308, 1}};
  const Ring high{{0, 1e308}, {1, 1e308}, {0, 1.5e308}};
  for (const auto& [large, coordinate] :
       {std::pair(wide, "x coordinate"), std::pair(high, "y coordinate")}) {
    try {
      sum_of(large, large, {0, 0});
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), Status::range);
      EXPECT_NE(std::string(error.what()).find(coordinate), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace gcv
