// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Discs, certified in fractions: every vertex is at most radius + tolerance from the centre, and
// every edge at least radius - tolerance, or the radius itself where the disc must be inside.
#include "disc.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "error.hpp"
#include "numbers.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Rational;
using test::rational;
using test::uniform;

struct Disc {
  Point centre;
  double radius;
  double tolerance;
  Rounding rounding;
};

std::ostream& operator<<(std::ostream& out, const Disc& disc) {
  return out << std::hexfloat << "centre " << disc.centre.x << " " << disc.centre.y << ", radius "
             << disc.radius << ", tolerance " << disc.tolerance << ", rounding "
             << static_cast<int>(disc.rounding);
}

struct Vector {
  Rational x;
  Rational y;
};
Rational square(const Rational& x) { return x * x; }
Rational squared_length(const Vector& v) { return square(v.x) + square(v.y); }

// Convex, round the centre, and as near to the circle as it must be.
::testing::AssertionResult is_right(const Disc& disc, const Boundary& ring) {
  const auto from_centre = [&](const Point& p) {
    return Vector{rational(p.x) - rational(disc.centre.x), rational(p.y) - rational(disc.centre.y)};
  };
  const Rational most = rational(disc.radius) + rational(disc.tolerance);
  const Rational least = disc.rounding == Rounding::outward
                             ? rational(disc.radius)
                             : rational(disc.radius) - rational(disc.tolerance);
  for (Index i = 0; i < ring.size(); ++i) {
    const Vector p = from_centre(ring.vertices[i]);
    const Vector q = from_centre(ring.vertices[ring.next(i)]);
    const Rational turn = p.x * q.y - p.y * q.x;
    if (turn <= 0) {
      return ::testing::AssertionFailure() << "edge " << i << " does not go round the centre";
    }
    if (squared_length(p) > square(most)) {
      return ::testing::AssertionFailure() << "vertex " << i << " is too far from the centre";
    }
    if (least > 0 && square(turn) < square(least) * squared_length({q.x - p.x, q.y - p.y})) {
      return ::testing::AssertionFailure() << "edge " << i << " is too near to the centre";
    }
  }
  return ring.is_convex ? ::testing::AssertionSuccess()
                        : ::testing::AssertionFailure() << "not convex";
}

// The largest unit in the last place of a coordinate, about.
double unit_of(const Disc& disc) {
  const double largest =
      std::max(std::abs(disc.centre.x), std::abs(disc.centre.y)) + 2 * disc.radius;
  return std::max(largest * std::numeric_limits<double>::epsilon(),
                  std::numeric_limits<double>::denorm_min());
}

void expect_right(const Disc& disc) {
  const Polygon polygon = make_disc(disc.centre, disc.radius, disc.tolerance, disc.rounding);
  ASSERT_TRUE(is_right(disc, polygon.outer)) << disc;
  ASSERT_EQ(polygon.ring_count(), 1U);
  ASSERT_EQ(polygon.outer.size() % 4, 0U) << disc;
}

double mantissa(Random& random) { return 1 + std::ldexp(static_cast<double>(random() >> 12), -52); }

Rounding any_rounding(Random& random) {
  return uniform(random, 0, 1) == 0 ? Rounding::nearest : Rounding::outward;
}

TEST(Disc, OfOrdinaryNumbersIsWithinItsTolerance) {
  Random random(41);
  for (int k = 0; k < 600; ++k) {
    const double radius = std::ldexp(mantissa(random), uniform(random, -12, 12));
    const auto coordinate = [&] {
      return uniform(random, 0, 3) == 0
                 ? 0.0
                 : std::ldexp(mantissa(random) - 1.5, uniform(random, -12, 20));
    };
    const double tolerance = radius * std::ldexp(mantissa(random), uniform(random, -13, 2));
    ASSERT_NO_FATAL_FAILURE(
        expect_right({{coordinate(), coordinate()}, radius, tolerance, any_rounding(random)}));
  }
}

// With large exponents, and so that the tolerance is some units in the last place.
TEST(Disc, OfAllSizesIsWithinItsTolerance) {
  Random random(42);
  int by_units = 0;
  for (int k = 0; k < 1500; ++k) {
    const int exponent = uniform(random, -1070, 1018);
    Disc disc{{0, 0}, std::ldexp(mantissa(random), exponent), 0, any_rounding(random)};
    const auto coordinate = [&] {
      return std::ldexp(mantissa(random) - 1.5,
                        std::min(exponent + uniform(random, -60, 60), 1021));
    };
    disc.centre = {coordinate(), coordinate()};
    const double unit = unit_of(disc);
    disc.tolerance = std::max(disc.radius * std::ldexp(mantissa(random), -uniform(random, 0, 11)),
                              unit * uniform(random, 8, 30));
    by_units += disc.tolerance < 32 * unit ? 1 : 0;
    ASSERT_NO_FATAL_FAILURE(expect_right(disc));
  }
  EXPECT_GT(by_units, 300);
}

// A tolerance just above what so many vertices take, and just below: the doubles around it.
TEST(Disc, IsRightWhereOneMoreHalvingIsNeeded) {
  for (const Rounding rounding : {Rounding::nearest, Rounding::outward}) {
    for (int n = 4; n <= 256; n *= 2) {
      const double cosine = std::cos(std::acos(-1) / n);
      const double radius = 1;
      double tolerance = rounding == Rounding::outward ? radius / cosine - radius
                                                       : radius * (1 - cosine) / (1 + cosine);
      // Some units for roundings: they are made of coordinates of about 1.
      for (int step = -60; step <= 160; step += 4) {
        const Disc disc{{0, 0}, radius, tolerance + step * 0x1p-53, rounding};
        ASSERT_NO_FATAL_FAILURE(expect_right(disc));
        const Index size = make_disc(disc.centre, radius, disc.tolerance, rounding).outer.size();
        ASSERT_TRUE(static_cast<int>(size) == n || static_cast<int>(size) == 2 * n) << disc;
        ASSERT_TRUE(step > -8 || static_cast<int>(size) == 2 * n) << disc;
        ASSERT_TRUE(step < 140 || static_cast<int>(size) == n) << disc;
      }
    }
  }
}

// However few units the tolerance has, there is an answer soon, and the polygon is right.
TEST(Disc, OfTooFewUnitsIsRefused) {
  Random random(43);
  int made = 0;
  int refused = 0;
  for (int k = 0; k < 3000; ++k) {
    const double unit = k % 2 == 0 ? 0x1p-1074 : 0x1p8;
    const double far = k % 2 == 0 ? 0 : 0x1p60;
    const Disc disc{{far, 0},
                    unit * std::ldexp(mantissa(random), uniform(random, 0, 8)),
                    unit * (uniform(random, 1, 40) / 8.0),
                    any_rounding(random)};
    if (disc.tolerance == 0) {
      continue;
    }
    try {
      ASSERT_TRUE(
          is_right(disc, make_disc(disc.centre, disc.radius, disc.tolerance, disc.rounding).outer))
          << disc;
      ++made;
    } catch (const Error& error) {
      ASSERT_EQ(error.status(), Status::invalid_argument) << error.what();
      ASSERT_LT(disc.tolerance, 8 * unit) << disc;
      ++refused;
    }
  }
  EXPECT_GT(made, 500);
  EXPECT_GT(refused, 500);
}

// From the centre, where it has no finer digits than the radius: the same after quarter turns.
TEST(Disc, IsTheSameAfterQuarterTurns) {
  Random random(44);
  for (int k = 0; k < 200; ++k) {
    const double radius = std::ldexp(mantissa(random), uniform(random, -3, 3));
    const Point centre{1.0 * uniform(random, -64, 64), 1.0 * uniform(random, -64, 64)};
    const Polygon polygon = make_disc(centre, radius, radius * 1e-3, any_rounding(random));
    std::vector<Point> seen;
    for (const Point& p : polygon.outer.vertices) {
      seen.push_back({p.x - centre.x, p.y - centre.y});  // exact
    }
    const std::size_t quarter = seen.size() / 4;
    const auto by_place = [](const Point& p, const Point& q) {
      return lexicographically_less(p, q);
    };
    std::vector<Point> turned;
    for (const Point& p : seen) {
      turned.push_back({0.0 - p.y, p.x});
    }
    ASSERT_EQ(seen.size(), 4 * quarter);
    std::sort(seen.begin(), seen.end(), by_place);
    std::sort(turned.begin(), turned.end(), by_place);
    ASSERT_EQ(seen, turned);
  }
}

}  // namespace
}  // namespace gcv
