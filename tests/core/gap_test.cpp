// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Distances against rationals, also along the axes, where there are quicker ways.
#include "gap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "numbers.hpp"

namespace gcv {
namespace {

using test::Attack;
using test::Random;
using test::Rational;
using test::rational;
using test::RationalPoint;

constexpr int attacks = 20000;

Rational square_of(const Gap& gap) {
  const RationalPoint p = rational(gap.point);
  const RationalPoint o = rational(gap.edge.origin);
  const Rational x = p.x - o.x;
  const Rational y = p.y - o.y;
  if (!gap.is_to_line) {
    return x * x + y * y;
  }
  const Rational dx = rational(gap.edge.to.x) - rational(gap.edge.from.x);
  const Rational dy = rational(gap.edge.to.y) - rational(gap.edge.from.y);
  const Rational cross = dx * y - dy * x;
  return cross * cross / (dx * dx + dy * dy);
}

enum class Along { any, x, y };

SumEdge edge_along(Attack& attack, Along along) {
  SumEdge edge = attack.edge();
  if (along == Along::x) {
    edge.to.y = edge.from.y;
  } else if (along == Along::y) {
    edge.to.x = edge.from.x;
  }
  edge.dx = edge.to.x - edge.from.x;
  edge.dy = edge.to.y - edge.from.y;
  return edge;
}

bool is_edge(const SumEdge& edge) { return !(edge.from == edge.to); }

Gap gap_along(Attack& attack, Random& random, Along along) {
  Gap gap{edge_along(attack, along), attack.sum_point(), test::uniform(random, 0, 1) == 0};
  if (test::uniform(random, 0, 2) == 0) {
    gap.point.c = attack.point();
    gap.edge.origin.c = test::uniform(random, 0, 1) == 0 ? gap.point.c : attack.point();
  }
  if (!gap.is_to_line && along == Along::x) {
    gap.point.a.y = gap.edge.origin.b.y;
    gap.point.b.y = gap.edge.origin.a.y;
    gap.point.c.y = gap.edge.origin.c.y;
  } else if (!gap.is_to_line && along == Along::y) {
    gap.point.a.x = gap.edge.origin.c.x;
    gap.point.b.x = gap.edge.origin.b.x;
    gap.point.c.x = gap.edge.origin.a.x;
  }
  return gap;
}

TEST(Gap, OrderIsExact) {
  Random random(421);
  Tally tally;
  int ties = 0;
  int along_axes = 0;
  for (int k = 0; k < attacks; ++k) {
    Attack attack(random);
    const auto along = [&] { return static_cast<Along>(test::uniform(random, 0, 2)); };
    const Along first = along();
    const Along second = along();
    const Gap p = gap_along(attack, random, first);
    Gap q = gap_along(attack, random, second);
    if (k % 7 == 0 && first != Along::any) {
      // The other way round: the same distance.
      q = p;
      std::swap(q.point, q.edge.origin);
    }
    if (!is_edge(p.edge) || !is_edge(q.edge)) {
      continue;
    }
    const int order = Rational(square_of(p) - square_of(q)).sign();
    ASSERT_EQ(compare_gaps(p, q, tally), order);
    ASSERT_EQ(compare_gaps(q, p, tally), -order);
    ties += order == 0 ? 1 : 0;
    along_axes += first != Along::any && second != Along::any ? 1 : 0;
  }
  EXPECT_GT(ties, 500);
  EXPECT_GT(along_axes, attacks / 4);
}

// Is it the double nearest to a number?
testing::AssertionResult is_nearest(double x, const Rational& number) {
  if (!std::isfinite(x)) {
    return abs(number) > rational(std::numeric_limits<double>::max())
               ? testing::AssertionSuccess()
               : testing::AssertionFailure() << x;
  }
  for (const double way :
       {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}) {
    const double next = std::nextafter(x, way);
    if (std::isfinite(next) &&
        abs(Rational(rational(next) - number)) < abs(Rational(rational(x) - number))) {
      return testing::AssertionFailure() << next << " is nearer than " << x;
    }
  }
  return testing::AssertionSuccess();
}

TEST(Gap, CrossingsAlongAxesAreNearest) {
  Random random(422);
  Tally tally;
  int tested = 0;
  for (int k = 0; k < attacks; ++k) {
    Attack attack(random);
    SumEdge s = edge_along(attack, Along::x);
    SumEdge t = edge_along(attack, Along::y);
    if (!is_edge(s) || !is_edge(t)) {
      continue;
    }
    if (k % 3 == 0) {
      s.origin.c = attack.point();
    }
    const Point shift = k % 2 == 0 ? Point{0, 0} : attack.point();
    const RationalPoint p = rational(s.origin);
    const RationalPoint q = rational(t.origin);
    for (const bool exchanged : {false, true}) {
      const Point crossing =
          exchanged ? nearest_crossing(t, s, tally, shift) : nearest_crossing(s, t, tally, shift);
      ASSERT_TRUE(is_nearest(crossing.x, q.x + rational(shift.x)));
      ASSERT_TRUE(is_nearest(crossing.y, p.y + rational(shift.y)));
    }
    ++tested;
  }
  EXPECT_GT(tested, attacks / 2);
}

TEST(Gap, DistancesAreNearest) {
  Random random(423);
  Tally tally;
  int equal = 0;
  for (int k = 0; k < attacks; ++k) {
    Attack attack(random);
    const Gap gap = gap_along(attack, random, static_cast<Along>(test::uniform(random, 0, 2)));
    if (!is_edge(gap.edge)) {
      continue;
    }
    const Rational square = square_of(gap);
    const double nearest = nearest_gap(gap, tally);
    ASSERT_TRUE(test::is_nearest_root(nearest, square));
    ASSERT_EQ(is_zero(gap, tally), square == 0);
    for (const double distance :
         {nearest, std::nextafter(nearest, 0.0), std::abs(attack.number())}) {
      if (std::isfinite(distance)) {
        const int order = Rational(square - rational(distance) * rational(distance)).sign();
        ASSERT_EQ(compare_gap(gap, distance, tally), order);
        equal += order == 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(equal, attacks / 10);
}

// The largest double that is not above the parameter, which is often one itself.
TEST(Gap, ParametersAreRoundedDown) {
  Random random(424);
  Tally tally;
  int exact = 0;
  for (int k = 0; k < attacks; ++k) {
    Attack attack(random);
    const SumEdge s = attack.edge();
    SumEdge t = attack.edge();
    if (k % 16 == 0) {
      t.origin = s.origin;
    }
    const auto cross_with_t = [&](const Rational& x, const Rational& y) {
      return Rational(x * (rational(t.to.y) - rational(t.from.y)) -
                      y * (rational(t.to.x) - rational(t.from.x)));
    };
    const RationalPoint from = rational(s.origin);
    const RationalPoint to = rational(t.origin);
    const Rational d =
        cross_with_t(rational(s.to.x) - rational(s.from.x), rational(s.to.y) - rational(s.from.y));
    const Rational n = cross_with_t(to.x - from.x, to.y - from.y);
    if (d == 0 || n.sign() * d.sign() < 0 ||
        abs(n) > abs(d) * rational(std::numeric_limits<double>::max())) {
      continue;
    }
    const Rational lambda = n / d;
    const double below = parameter_below(s, t, tally);
    ASSERT_LE(rational(below), lambda);
    const double next = std::nextafter(below, std::numeric_limits<double>::infinity());
    ASSERT_TRUE(!std::isfinite(next) || rational(next) > lambda);
    exact += rational(below) == lambda ? 1 : 0;
  }
  EXPECT_GT(exact, attacks / 20);
}

TEST(Gap, UnitVectorsAreWithinAnUlp) {
  Random random(425);
  Tally tally;
  for (int k = 0; k < attacks; ++k) {
    Attack attack(random);
    const SumPoint from = attack.sum_point();
    SumPoint to = attack.sum_point();
    if (k % 3 == 0) {
      to.c = attack.point();
    }
    const RationalPoint p = rational(from);
    const RationalPoint q = rational(to);
    const Rational x = q.x - p.x;
    const Rational y = q.y - p.y;
    if (x == 0 && y == 0) {
      continue;
    }
    const auto is_within_an_ulp = [&](double unit, const Rational& coordinate) {
      const double size = std::abs(unit);
      const Rational square = coordinate * coordinate / (x * x + y * y);
      const Rational below = rational(std::nextafter(size, 0.0));
      const Rational above = rational(std::nextafter(size, 2.0));
      return unit * coordinate.sign() >= 0 && below * below <= square && square <= above * above;
    };
    const Point unit = nearest_unit_vector(from, to, tally);
    ASSERT_TRUE(is_within_an_ulp(unit.x, x));
    ASSERT_TRUE(is_within_an_ulp(unit.y, y));
  }
}

TEST(Gap, UnitVectorsAlongAxes) {
  Tally tally;
  for (const double size : {5e-324, 1e-200, 0.1, 3.0, 1.7e308}) {
    const SumPoint origin{{0.5, 0.25}, {-0.5, -0.25}};
    const auto way_to = [&](double x, double y) {
      return nearest_unit_vector(origin, {{x, 0}, {0, y}}, tally);
    };
    EXPECT_TRUE((way_to(size, 0) == Point{1, 0}));
    EXPECT_TRUE((way_to(-size, 0) == Point{-1, 0}));
    EXPECT_TRUE((way_to(0, size) == Point{0, 1}));
    EXPECT_TRUE((way_to(0, -size) == Point{0, -1}));
  }
}

// A turned edge, and points within roundings of it.
TEST(Gap, NearTouchesTakeNoIntegers) {
  Random random(20261129);
  Tally tally;
  for (int k = 0; k < 1000; ++k) {
    const auto number = [&] { return test::uniform(random, 1, 1000000) / 3e5; };
    const Point from{number(), number()};
    const Point to{from.x + number(), from.y + number()};
    const Point at{number(), number()};
    const double along = number() / 4;
    const SumEdge edge{{from, at}, from, to, to.x - from.x, to.y - from.y};
    const auto near = [&](double part) {
      return SumPoint{{from.x + part * edge.dx, from.y + part * edge.dy}, at};
    };
    const Gap p{edge, near(along), true};
    const Gap q{edge, near(along / 3), true};
    if (square_of(p) != square_of(q) && !is_zero(p, tally)) {
      const Tally before = tally;
      EXPECT_EQ(compare_gaps(p, q, tally), square_of(p) < square_of(q) ? -1 : 1);
      EXPECT_TRUE(test::is_nearest_root(nearest_gap(p, tally), square_of(p)));
      EXPECT_EQ(tally.fixed_width, before.fixed_width);
      EXPECT_EQ(tally.rational, before.rational);
    }
  }
  EXPECT_GT(tally.filtered, 1000U);
}

}  // namespace
}  // namespace gcv
