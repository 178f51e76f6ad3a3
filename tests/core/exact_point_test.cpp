// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Sums of points and crossings of lines against rationals.
#include "exact_point.hpp"

#include <gtest/gtest.h>

#include "numbers.hpp"

namespace gcv {
namespace {

using test::Attack;
using test::Random;
using test::Rational;
using test::rational;
using test::RationalPoint;

constexpr int attacks = 6000;

RationalPoint direction(const SumEdge& s) { return between(rational(s.from), rational(s.to)); }

RationalPoint rational(const ExactPoint& p) {
  if (p.is_sum) {
    return rational(p.sum);
  }
  const RationalPoint origin = rational(p.s.origin);
  const RationalPoint d = direction(p.s);
  const RationalPoint e = direction(p.t);
  const Rational lambda = cross(between(origin, rational(p.t.origin)), e) / cross(d, e);
  return {origin.x + lambda * d.x, origin.y + lambda * d.y};
}

// A sum or a crossing, by attacking numbers; some crossings lie in vertices of their edges.
ExactPoint exact_point(Attack& attack, Random& random) {
  while (test::uniform(random, 0, 2) != 0) {
    SumEdge s = attack.edge();
    SumEdge t = attack.edge();
    if (test::uniform(random, 0, 3) == 0) {
      t.origin = s.origin;
    }
    if (test::uniform(random, 0, 3) == 0) {
      s.origin.c = attack.point();
    }
    if (cross(direction(s), direction(t)) != 0) {
      return ExactPoint::of_crossing(s, t);
    }
  }
  return ExactPoint::of_sum(attack.sum_point());
}

class ExactPoints : public ::testing::Test {
 protected:
  // Calls check(p, q, attack) for many points. Some are the same by other names.
  template <class Check>
  void attack(Check check) {
    for (int k = 0; k < attacks; ++k) {
      Attack attack(random_);
      const ExactPoint p = exact_point(attack, random_);
      ExactPoint q = exact_point(attack, random_);
      if (!p.is_sum && k % 5 == 0) {
        q = ExactPoint::of_crossing(p.t, p.s);
      }
      check(p, q, attack);
    }
  }

  Random random_{451};
  Tally tally_;
};

TEST_F(ExactPoints, AreComparedWithDoubles) {
  attack([&](const ExactPoint& p, const ExactPoint&, Attack& attack) {
    const Point shift = test::uniform(random_, 0, 1) == 0 ? Point{0, 0} : attack.point();
    const RationalPoint place = rational(p);
    Point q = attack.point();
    if (const Point near = nearest_point(p, shift, tally_);
        test::uniform(random_, 0, 1) == 0 && std::isfinite(near.x) && std::isfinite(near.y)) {
      q = near;
    }
    const Rational x = place.x + rational(shift.x) - rational(q.x);
    const Rational y = place.y + rational(shift.y) - rational(q.y);
    ASSERT_EQ(compare_x(p, shift, q.x, tally_), x.sign());
    ASSERT_EQ(compare_y(p, shift, q.y, tally_), y.sign());
  });
}

TEST_F(ExactPoints, LieOnSidesOfLines) {
  attack([&](const ExactPoint& p, const ExactPoint& q, Attack& attack) {
    const SumEdge s = q.is_sum ? attack.edge() : q.t;
    const Rational side_of_p = cross(direction(s), between(rational(s.origin), rational(p)));
    ASSERT_EQ(side(s, p, tally_), side_of_p.sign());
  });
}

TEST_F(ExactPoints, AreInLexicographicOrder) {
  attack([&](const ExactPoint& p, const ExactPoint& q, Attack& /*attack*/) {
    const RationalPoint way = between(rational(q), rational(p));
    const int order = way.x != 0 ? way.x.sign() : way.y.sign();
    ASSERT_EQ(compare_lexicographically(p, q, tally_), order);
    ASSERT_EQ(compare_lexicographically(q, p, tally_), -order);
  });
}

TEST_F(ExactPoints, AreInTheOrderAlongADirection) {
  attack([&](const ExactPoint& p, const ExactPoint& q, Attack& attack) {
    const Point d = attack.point();
    ASSERT_EQ(compare_along(d, p, q, tally_),
              dot(rational(d), between(rational(q), rational(p))).sign());
  });
}

TEST_F(ExactPoints, HaveDistancesFromAPoint) {
  attack([&](const ExactPoint& p, const ExactPoint& q, Attack& attack) {
    const Point from = attack.point();
    const RationalPoint to_p = between(rational(from), rational(p));
    const RationalPoint to_q = between(rational(from), rational(q));
    ASSERT_EQ(compare_distances(p, q, from, tally_),
              Rational(dot(to_p, to_p) - dot(to_q, to_q)).sign());
    ASSERT_TRUE(test::is_nearest_root(nearest_distance(p, from, tally_), dot(to_p, to_p)));
  });
}

}  // namespace
}  // namespace gcv
