// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Mapped coordinates against fractions: each is the double nearest to the exact one, ties to even.
#include "affine.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "double_double_rounding.hpp"
#include "numbers.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Rational;
using test::rational;
using test::uniform;

constexpr double largest = std::numeric_limits<double>::max();

Rational exact(double xx, double xy, double x0, const Point& p) {
  return rational(xx) * rational(p.x) + rational(xy) * rational(p.y) + rational(x0);
}

bool is_even(double x) { return std::bit_cast<std::uint64_t>(x) % 2 == 0; }

// Is x nearest to the exact value, of finite doubles and of 2^1024, which stands for infinity?
bool is_nearest(double x, const Rational& value) {
  const auto as_rational = [](double y) {
    return std::isfinite(y)
               ? rational(y)
               : Rational(y < 0 ? -1 : 1) * (rational(largest) + rational(0x1p970) * 2);
  };
  const Rational error = abs(as_rational(x) - value);
  for (const double towards : {-HUGE_VAL, HUGE_VAL}) {
    const double neighbour = std::nextafter(x, towards);
    if (neighbour == x || std::isnan(neighbour)) {
      if (std::isfinite(x)) {
        return false;
      }
      // Beyond infinity there is nothing nearer.
      continue;
    }
    const Rational other = abs(as_rational(neighbour) - value);
    if (other < error || (other == error && !is_even(x))) {
      return false;
    }
  }
  return !std::isinf(x) || (x < 0) == (value < 0);
}

TEST(Reference, KnowsTheFirstCases) {
  EXPECT_TRUE(is_nearest(1, rational(1)));
  EXPECT_FALSE(is_nearest(1 + 0x1p-52, rational(1)));
  EXPECT_TRUE(is_nearest(0x1p53, rational(0x1p53) + 1));
  EXPECT_FALSE(is_nearest(0x1p53 + 2, rational(0x1p53) + 1));
  EXPECT_TRUE(is_nearest(0x1p53 + 4, rational(0x1p53) + 3));
  EXPECT_TRUE(is_nearest(0, rational(0x1p-1074) / 2));
  EXPECT_TRUE(is_nearest(0x1p-1073, rational(0x1p-1074) * 3 / 2));
  EXPECT_TRUE(is_nearest(largest, rational(largest) + rational(0x1p969)));
  EXPECT_TRUE(is_nearest(HUGE_VAL, rational(largest) + rational(0x1p970)));
  EXPECT_FALSE(is_nearest(largest, rational(largest) + rational(0x1p970)));
  EXPECT_TRUE(is_nearest(-HUGE_VAL, -rational(largest) * 1000));
  EXPECT_FALSE(is_nearest(HUGE_VAL, -rational(largest) * 1000));
}

// Both coordinates, by swapped rows too.
::testing::AssertionResult is_right(const AffineMap& map, const Point& p) {
  const Point image = mapped(map, p);
  const Point swapped = mapped({map.yx, map.yy, map.y0, map.xx, map.xy, map.x0}, p);
  if (is_nearest(image.x, exact(map.xx, map.xy, map.x0, p)) &&
      is_nearest(image.y, exact(map.yx, map.yy, map.y0, p)) && swapped.x == image.y &&
      swapped.y == image.x && !(image.x == 0 && std::signbit(image.x))) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure()
         << std::hexfloat << map.xx << " " << map.xy << " " << map.x0 << " " << map.yx << " "
         << map.yy << " " << map.y0 << " of " << p.x << " " << p.y << " gave " << image.x << " "
         << image.y;
}

TEST(Affine, OfNumbersOfAllSizesIsCorrectlyRounded) {
  Random random(31);
  for (int k = 0; k < 60000; ++k) {
    const auto number = [&] { return test::attacking_double(random); };
    ASSERT_TRUE(is_right({number(), number(), number(), number(), number(), number()},
                         {number(), number()}));
  }
}

TEST(Affine, OfNumbersOfOneSizeIsCorrectlyRounded) {
  Random random(32);
  for (int k = 0; k < 60000; ++k) {
    test::Attack factors(random);
    test::Attack places(random);
    const auto factor = [&] { return factors.number(); };
    ASSERT_TRUE(is_right({factor(), factor(), factor(), factor(), factor(), places.number()},
                         places.point()));
  }
}

// A number whose sum with the products is a tie, or just off one.
TEST(Affine, GoesToEvenAtTies) {
  Random random(33);
  int ties = 0;
  for (int k = 0; k < 60000; ++k) {
    const int scale = uniform(random, -1074 / 2 + 60, 400);
    const auto integer = [&] { return std::ldexp(uniform(random, -8, 8), scale); };
    const Point p{integer(), integer()};
    const double xx = integer();
    const double xy = integer();
    const double unit = std::ldexp(1.0, 2 * scale);
    // Products are multiples of the unit; those of 2 units are doubles there.
    const double mantissa = 0x1p53 + 2 * static_cast<double>(random() >> 12);
    double x0 = (uniform(random, 0, 1) == 0 ? 1 : -1) * mantissa * unit;
    double off = 0;
    if (uniform(random, 0, 1) == 0) {
      off = (uniform(random, 0, 1) == 0 ? 1 : -1) *
            std::ldexp(1.0, std::max(uniform(random, -1074, 2 * scale - 2), -1074));
    }
    // As the second product, or as a part of the first: both ways have to see it.
    const Rational value = exact(xx, xy, x0, p);
    const Rational halves = value / rational(unit);
    ties += numerator(halves) % 2 != 0 && abs(halves) > rational(0x1p53) ? 1 : 0;
    ASSERT_TRUE(is_right({xx, xy, x0, off, 1, 0}, p));
    ASSERT_TRUE(is_right({xx, off, x0, off, xx, -x0}, {p.x, uniform(random, -1, 1) / 1.0}));
  }
  EXPECT_GT(ties, 10000);
}

// Two products that take each other away, but for little.
TEST(Affine, IsCorrectlyRoundedWhereAlmostAllIsTakenAway) {
  Random random(34);
  for (int k = 0; k < 60000; ++k) {
    const auto number = [&](int least, int most) {
      return std::ldexp(1 + std::ldexp(static_cast<double>(random() >> 12), -52),
                        uniform(random, least, most));
    };
    const int range = k % 3 == 0 ? 300 : 5;
    const double xx = number(-range, range);
    const double x = number(-range, range);
    const double xy = number(-range, range);
    const double y = -(xx * x) / xy;  // rounded
    const double rest = xx * x + xy * y;
    ASSERT_TRUE(is_right({xx, xy, 0, xx, xy, -rest}, {x, y}));
    ASSERT_TRUE(is_right({xx, 0, -(xx * x), 0, xy, -(xy * y)}, {x, y}));
    ASSERT_TRUE(is_right({xx, xy, std::ldexp(1.0, uniform(random, -1074, 0)), x, y, 1}, {x, y}));
  }
}

// The error of one product makes a tie, and that of the other one, which is lost where both errors
// are added up, decides it.
TEST(Affine, SeesTheErrorsOfBothProducts) {
  Random random(37);
  const auto above_one = [](int k) { return 1 + std::ldexp(1.0, -k); };
  for (int k = 0; k < 40000; ++k) {
    const int scale = uniform(random, 0, 20);
    const int a = uniform(random, 2, 52);
    const double xx = std::ldexp(above_one(a), scale);
    const double x = above_one(54 - a);  // the error is 2^(scale - 54)
    const int b = uniform(random, 27, 52);
    const double xy = uniform(random, 0, 1) == 0 ? above_one(b) : -above_one(b);
    const double y = 1 - std::ldexp(1.0, -b);  // the product is 1, the error 2^-2b
    const double sum = std::ldexp(0.5 + std::ldexp(uniform(random, 0, 1 << 20), -21), scale);
    const double x0 = sum - xx * x - xy * y;
    ASSERT_TRUE(is_right({xx, xy, x0, -xx, -xy, -x0}, {x, y}));
    ASSERT_TRUE(is_right({xy, xx, x0, xy, xx, 0}, {y, x}));
  }
}

// Around the largest and the smallest doubles.
TEST(Affine, IsCorrectlyRoundedAtBothEnds) {
  Random random(35);
  int infinite = 0;
  int finite = 0;
  for (int k = 0; k < 60000; ++k) {
    const auto sign = [&] { return uniform(random, 0, 1) == 0 ? 1.0 : -1.0; };
    const double near_half = largest / 2 * (1 + uniform(random, -4, 4) * 0x1p-52);
    const AffineMap large{sign() * (1 + uniform(random, -2, 2) * 0x1p-53),
                          sign(),
                          sign() * uniform(random, 0, 3) * 0x1p969,
                          sign(),
                          0.5,
                          sign() * std::ldexp(1.0, uniform(random, 900, 1023))};
    const Point p{sign() * near_half, sign() * largest / 2};
    ASSERT_TRUE(is_right(large, p));
    (std::isinf(mapped(large, p).x) ? infinite : finite)++;
    const AffineMap small{sign() * uniform(random, 0, 9) / 8,
                          sign() * uniform(random, 0, 9) / 4,
                          sign() * uniform(random, 0, 2) * 0x1p-1074,
                          sign() * 0x1p-600 * uniform(random, 0, 9),
                          sign() * 0x1p-500,
                          0};
    const Point q{sign() * uniform(random, 0, 9) * 0x1p-1074, uniform(random, 0, 9) * 0x1p-574};
    ASSERT_TRUE(is_right(small, q));
  }
  EXPECT_GT(infinite, 1000);
  EXPECT_GT(finite, 1000);
}

// Where rounding is certain in pairs of doubles, it is right; and it mostly is certain.
TEST(Affine, OfOrdinaryNumbersTakesNoIntegers) {
  Random random(36);
  int certain = 0;
  for (int k = 0; k < 20000; ++k) {
    const auto number = [&] {
      return std::ldexp(static_cast<double>(random() >> 11), -53) * 2000 - 1000;
    };
    const Point p{number(), number()};
    const double xx = number();
    const double xy = number();
    const double x0 = number();
    const auto rounded = rounded_affine(xx, xy, x0, p);
    certain += rounded ? 1 : 0;
    ASSERT_TRUE(!rounded || is_nearest(rounded->value, exact(xx, xy, x0, p)));
  }
  EXPECT_GT(certain, 19900);
}

}  // namespace
}  // namespace gcv
