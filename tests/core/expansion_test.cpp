// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Exact sums of doubles and of products against rationals.
#include "expansion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "numbers.hpp"

namespace gcv {
namespace {

using test::attacking_double;
using test::Random;
using test::Rational;
using test::rational;

constexpr int attacks = 20000;

template <std::size_t capacity>
void expect_sum(const Expansion<capacity>& sum, const Rational& wanted) {
  ASSERT_TRUE(sum.is_finite());
  EXPECT_EQ(sum.sign(), wanted > 0 ? 1 : wanted < 0 ? -1 : 0);
  const Ball leading = sum.leading();
  EXPECT_EQ(leading.hi, leading.hi + leading.lo);
  const Rational left_out = abs(Rational(wanted - rational(leading.hi) - rational(leading.lo)));
  EXPECT_LE(left_out, rational(leading.error));
  EXPECT_LE(rational(leading.error), rational(0x1p-104) * abs(wanted));
}

// Numbers of one size, and differences of neighbours, so that much is cancelled.
double number(Random& random, double last) {
  switch (test::uniform(random, 0, 3)) {
    case 0:
      return -last;
    case 1:
      return -std::nextafter(last, 0.0);
    case 2:
      return std::ldexp(last, test::uniform(random, -60, 0));
    default:
      return attacking_double(random);
  }
}

TEST(Expansion, HasSums) {
  Random random(20261127);
  int zeros = 0;
  for (int k = 0; k < attacks; ++k) {
    std::array<double, 6> numbers;
    Rational wanted(0);
    double last = attacking_double(random);
    for (double& x : numbers) {
      x = last;
      wanted += rational(x);
      last = number(random, last);
    }
    const Expansion<6> sum(numbers);
    if (sum.is_finite()) {
      expect_sum(sum, wanted);
      zeros += wanted == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(zeros, 100);
}

TEST(Expansion, HasSumsOfProducts) {
  Random random(20261128);
  int decided = 0;
  for (int k = 0; k < attacks; ++k) {
    std::array<Rational, 4> wanted;
    std::array<Expansion<3>, 4> sums;
    double last = attacking_double(random);
    for (std::size_t n = 0; n < 4; ++n) {
      for (int part = 0; part < 3; ++part) {
        wanted[n] += rational(last);
        sums[n].add(last);
        last = number(random, last);
      }
    }
    const auto has_products = [](const Expansion<3>& sum) {
      return sum.is_finite() && sum.has_exact_products();
    };
    if (!std::all_of(sums.begin(), sums.end(), has_products)) {
      continue;
    }
    ++decided;
    Expansion<36> cross;
    cross.add_product(sums[0], sums[1]);
    cross.subtract_product(sums[2], sums[3]);
    expect_sum(cross, Rational(wanted[0] * wanted[1] - wanted[2] * wanted[3]));
    Expansion<3> negated;
    negated.add_product(-1.0, sums[0]);
    expect_sum(negated, Rational(-wanted[0]));
  }
  EXPECT_GT(decided, attacks / 4);
}

TEST(Expansion, KnowsItsRange) {
  const auto has = [](double x) { return Expansion<1>({x}).has_exact_products(); };
  EXPECT_TRUE(has(0) && has(1) && has(0x1p-400) && has(-0x1p400));
  EXPECT_FALSE(has(0x1p-401) || has(0x1p401));
  constexpr double largest = std::numeric_limits<double>::max();
  EXPECT_TRUE(Expansion<2>({largest, -largest}).is_finite());
  EXPECT_FALSE(Expansion<2>({largest, largest}).is_finite());
  EXPECT_FALSE(Expansion<3>({largest, largest, -largest}).is_finite());
}

}  // namespace
}  // namespace gcv
