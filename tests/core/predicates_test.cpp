// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Every predicate against rationals, on operands that are tied, tiny, huge and mixed; and
// every tier of integers against the next.
#include "predicates.hpp"

#include <gtest/gtest.h>

#include "exact_numbers.hpp"
#include "numbers.hpp"
#include "slope.hpp"

namespace gcv {
namespace {

using test::Attack;
using test::Random;
using test::Rational;
using test::rational;
using test::RationalPoint;

constexpr int attacks = 40000;

template <class P>
RationalPoint between(const P& p, const P& q) {
  return test::between(rational(p), rational(q));
}

class Predicates : public ::testing::Test {
 protected:
  Random random_{20261121};
  Tally tally_;
};

TEST_F(Predicates, OrientationIsExact) {
  for (int k = 0; k < attacks; ++k) {
    Attack attack(random_);
    const Point p = attack.point();
    const Point q = attack.point();
    const Point r = attack.point();
    ASSERT_EQ(orientation(p, q, r, tally_), cross(between(p, q), between(p, r)).sign());
    ASSERT_EQ(orientation(p, q, r, tally_), orientation(q, r, p, tally_));
    ASSERT_EQ(orientation(p, q, r, tally_), -orientation(q, p, r, tally_));
  }
}

TEST_F(Predicates, TurnIsExact) {
  for (int k = 0; k < attacks; ++k) {
    Attack attack(random_);
    const Point p0 = attack.point();
    const Point p1 = attack.point();
    const Point q0 = attack.point();
    const Point q1 = attack.point();
    ASSERT_EQ(turn(p0, p1, q0, q1, tally_), cross(between(p0, p1), between(q0, q1)).sign());
  }
}

TEST_F(Predicates, SideIsExact) {
  for (int k = 0; k < attacks; ++k) {
    Attack attack(random_);
    const SumEdge s = attack.edge();
    const SumPoint p = attack.sum_point();
    ASSERT_EQ(side(s, p, tally_), cross(between(s.from, s.to), between(s.origin, p)).sign());
  }
}

TEST_F(Predicates, CompareSumsIsExact) {
  for (int k = 0; k < attacks; ++k) {
    Attack attack(random_);
    const double a = attack.number();
    const double b = attack.number();
    const double c = attack.number();
    const double d = attack.number();
    const Rational difference = rational(a) + rational(b) - rational(c) - rational(d);
    ASSERT_EQ(compare_sums(a, b, c, d, tally_), difference.sign());
  }
}

TEST_F(Predicates, CompareSumsOfThreeIsExact) {
  int equal = 0;
  for (int k = 0; k < attacks; ++k) {
    Attack attack(random_);
    double x[6];
    for (double& number : x) {
      number = attack.number();
    }
    if (k % 3 == 0) {  // what is left cancels, but for roundings
      x[5] = ((x[0] - x[3]) + (x[1] - x[4])) + x[2];
      x[5] = std::isfinite(x[5]) ? x[5] : x[2];
    }
    const Rational difference = rational(x[0]) + rational(x[1]) + rational(x[2]) - rational(x[3]) -
                                rational(x[4]) - rational(x[5]);
    ASSERT_EQ(compare_sums(x[0], x[1], x[2], x[3], x[4], x[5], tally_), difference.sign());
    equal += difference == 0 ? 1 : 0;
  }
  EXPECT_GT(equal, attacks / 10);
}

TEST_F(Predicates, CompareSumsIsExactAtTheEndOfTheRange) {
  constexpr double largest = std::numeric_limits<double>::max();
  constexpr double unit = 0x1p971;
  EXPECT_EQ(compare_sums(-1.5 * unit, largest, -unit, largest, tally_), -1);
  EXPECT_EQ(compare_sums(-unit, largest, -1.5 * unit, largest, tally_), 1);
  EXPECT_EQ(compare_sums(unit, -largest, 1.5 * unit, -largest, tally_), -1);
}

TEST_F(Predicates, CrossingsAreExactAndEnclosed) {
  int compared = 0;
  int narrow = 0;
  for (int k = 0; k < attacks; ++k) {
    Attack attack(random_);
    const SumEdge s = attack.edge();
    const SumEdge t = attack.edge();
    const SumEdge r = attack.edge();
    const auto ds = between(s.from, s.to);
    const auto dt = between(t.from, t.to);
    const auto dr = between(r.from, r.to);
    const Rational det = cross(ds, dt);
    const Rational der = cross(ds, dr);
    if (det == 0 || der == 0) {
      continue;
    }
    const Rational lt = cross(between(s.origin, t.origin), dt) / det;
    const Rational lr = cross(between(s.origin, r.origin), dr) / der;
    ASSERT_EQ(compare_crossings(s, t, r, tally_), Rational(lt - lr).sign());
    const Interval interval = crossing_parameter(s, t);
    if (std::isfinite(interval.lo)) {
      ++narrow;
      ASSERT_LE(rational(interval.lo), lt);
    }
    if (std::isfinite(interval.hi)) {
      ASSERT_GE(rational(interval.hi), lt);
    }
    ++compared;
  }
  EXPECT_GT(compared, attacks / 4);
  EXPECT_GT(narrow, attacks / 10);
}

// Crossings of the x axis at quotients of Fibonacci numbers in a row, whose fractions are doubles:
// the nearest ones are 2^-105 apart.
TEST_F(Predicates, CrossingsAtNeighbouringFractions) {
  const SumEdge axis{{{0, 0}, {0, 0}}, {0, 0}, {1, 0}, 1, 0};
  // From (0, -1), or to it.
  const auto through = [](double numerator, double denominator, bool upwards) {
    const Point low{0, -1};
    const Point high{numerator, denominator - 1};
    const Point& from = upwards ? low : high;
    const Point& to = upwards ? high : low;
    return SumEdge{{from, {0, 0}}, from, to, to.x - from.x, to.y - from.y};
  };
  double last = 1;
  double here = 1;
  while (here + last < 0x1p53) {
    const double next = here + last;
    for (const bool first_is_upwards : {true, false}) {
      for (const bool second_is_upwards : {true, false}) {
        const SumEdge t = through(last, here, first_is_upwards);
        const SumEdge r = through(here, next, second_is_upwards);
        const int order =
            Rational(rational(last) * rational(next) - rational(here) * rational(here)).sign();
        ASSERT_EQ(compare_crossings(axis, t, r, tally_), order);
        ASSERT_EQ(compare_crossings(axis, r, t, tally_), -order);
        ASSERT_EQ(compare_crossings(axis, t, t, tally_), 0);
      }
    }
    last = here;
    here = next;
  }
}

TEST_F(Predicates, SlopesAreComparedExactly) {
  int equal = 0;
  for (int k = 0; k < attacks; ++k) {
    Attack attack(random_);
    const Point p0 = attack.point();
    const Point p1 = attack.point();
    const Point q0 = attack.point();
    const Point q1 = attack.point();
    const auto v = between(p0, p1);
    const auto w = between(q0, q1);
    const Rational along = v.x * w.x + v.y * w.y;
    const Rational across = abs(cross(v, w));
    double slope = std::abs(attack.number());
    if (k % 2 == 0 && along > 0 && across < along * rational(0x1p1000)) {
      slope = Rational(across / along).convert_to<double>();
    }
    const Rational rest = rational(slope) * along - across;
    ASSERT_EQ(is_within_slope(p0, p1, q0, q1, slope, tally_), along > 0 && rest >= 0);
    equal += along > 0 && rest == 0 ? 1 : 0;
  }
  EXPECT_GT(equal, attacks / 40);
}

TEST_F(Predicates, AllTiersAreUsed) {
  for (int k = 0; k < attacks; ++k) {
    Attack attack(random_);
    const SumEdge s = attack.edge();
    side(s, attack.sum_point(), tally_);
  }
  EXPECT_GT(tally_.filtered, 0U);
  EXPECT_GT(tally_.fixed_width, 0U);
  EXPECT_GT(tally_.rational, 0U);
}

// The widths that the predicates ask for are enough: operands that fill b bits to the
// last give the same sign with the narrowest integers allowed as with unlimited ones.
template <class Integer>
void expect_width_is_enough(int magnitude_bits, Random& random) {
  const int side_bits = (magnitude_bits - 4) / 2;
  const auto extreme = [&](int bits) {
    const double top = std::ldexp(1.0, bits);
    const double low = test::uniform(random, 0, 2);
    const double value = bits <= 53 ? top - 1 - low : std::nextafter(top, 0.0);
    return test::uniform(random, 0, 1) == 0 ? value : -value;
  };
  for (int k = 0; k < 20000; ++k) {
    const auto point = [&] {
      // One coordinate on the unit grid keeps the grid's exponent at 0.
      return Point{extreme(side_bits), test::uniform(random, 0, 1) == 0 ? extreme(side_bits) : 1.0};
    };
    const SumEdge s{{point(), point()}, point(), point(), 0, 0};
    const SumPoint p{point(), point()};
    Grid grid{p.a, p.b};
    grid.include(s);
    ASSERT_LE(2 * grid.bits() + 4, magnitude_bits);
    const auto value = [&]<class I>() {
      return sign(
          gcv::cross(vector_between<I>(grid, s.from, s.to), vector_between<I>(grid, s.origin, p)));
    };
    ASSERT_EQ(value.template operator()<Integer>(), value.template operator()<BigInteger>());
  }
}

TEST_F(Predicates, Int128IsWideEnough) { expect_width_is_enough<Int128>(127, random_); }
TEST_F(Predicates, Int256IsWideEnough) { expect_width_is_enough<Int256>(256, random_); }
TEST_F(Predicates, Int512IsWideEnough) { expect_width_is_enough<Int512>(512, random_); }

TEST_F(Predicates, CrossingsAgreeBetweenTiers) {
  for (int k = 0; k < attacks; ++k) {
    const auto coordinate = [&] {
      return static_cast<double>(test::uniform(random_, -(1 << 28), 1 << 28));
    };
    const auto point = [&] { return Point{coordinate(), coordinate()}; };
    const auto edge = [&] { return SumEdge{{point(), point()}, point(), point(), 0, 0}; };
    const SumEdge s = edge();
    const SumEdge t = edge();
    Grid grid{Point{1, 1}};
    grid.include(s);
    grid.include(t);
    ASSERT_LE(crossing_bits(grid.bits()), 127);
    const auto p = crossing<Int128>(grid, s, t, {0, 0});
    const auto q = crossing<Int256>(grid, s, t, {0, 0});
    const auto r = crossing<BigInteger>(grid, s, t, {0, 0});
    ASSERT_EQ(q.x.str(), r.x.str());
    ASSERT_EQ(q.y.str(), r.y.str());
    ASSERT_EQ(q.w.str(), r.w.str());
    ASSERT_EQ(static_cast<double>(p.x), static_cast<double>(q.x));
    ASSERT_EQ(static_cast<double>(p.w), static_cast<double>(q.w));
  }
}

TEST(Decomposition, IsExact) {
  Random random(7);
  for (int k = 0; k < attacks; ++k) {
    const double x = test::attacking_double(random);
    const Decomposed d = decompose(x);
    ASSERT_EQ(std::ldexp(static_cast<double>(d.mantissa), d.exponent), x);
    ASSERT_TRUE(d.mantissa % 2 != 0 || d.mantissa == 0);
  }
}

}  // namespace
}  // namespace gcv
