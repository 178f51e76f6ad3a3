// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Questions about polygons with many long edges side by side, upright and in no direction of the
// axes: turned and made five times as large by integers, so that all answers are those from before.
// Upright, boxes tell most edges apart; slanting, line-swept spheres do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cast.hpp"
#include "distance.hpp"
#include "near_contacts.hpp"
#include "regions.hpp"
#include "relation.hpp"

namespace gcv {
namespace {

using test::PolygonRings;

Point slanting(const Point& p) { return {4 * p.x - 3 * p.y, 3 * p.x + 4 * p.y}; }

PolygonRings slanting(PolygonRings rings) {
  for (PointVector& ring : rings) {
    std::transform(ring.begin(), ring.end(), ring.begin(),
                   [](const Point& p) { return slanting(p); });
  }
  return rings;
}

// Teeth of that width and height, every eight units, on a floor.
PointVector comb(int teeth, double width, double height) {
  PointVector ring{{0, -4}, {8.0 * (teeth - 1) + width, -4}};
  for (int k = teeth; k-- > 0;) {
    const double x = 8.0 * k;
    ring.insert(ring.end(), {{x + width, height}, {x, height}});
    if (k > 0) {
      ring.insert(ring.end(), {{x, 0}, {x - 8 + width, 0}});
    }
  }
  return ring;
}

PointVector spiral(int turns) {
  PointVector outer;
  PointVector inner;
  for (int k = 0; k < turns; ++k) {
    const double low = 4.0 * k;
    const double high = 8.0 * turns - 4 * k;
    outer.insert(outer.end(), {{low, low}, {high, low}, {high, high}, {low + 4, high}});
    inner.insert(
        inner.end(),
        {{low + 1, low + 1}, {high - 1, low + 1}, {high - 1, high - 1}, {low + 5, high - 1}});
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

struct Polygons {
  PolygonRings a;
  PolygonRings b;
};

// All that is asked, of B at a translation.
struct Answers {
  Answers(const Polygons& polygons, const Point& at, const Point& motion, double reach) {
    const RegionOperand a = test::region_operand(polygons.a, "a");
    const RegionOperand b = test::region_operand(polygons.b, "b");
    const PolygonPair pair(*a.polygon, *b.polygon);
    const PlacedPair placed(pair, at);
    Tally tally;
    Task task;
    separation = distance(placed, tally);
    impact = cast(placed, motion, tally);
    contacts = near_contacts(placed, reach, 0, task, tally);
  }

  Separation separation;
  Impact impact;
  std::vector<Contact> contacts;
};

void expect_same_features(const Contact& p, const Contact& q) {
  EXPECT_EQ(p.kind, q.kind);
  EXPECT_EQ(p.a, q.a);
  EXPECT_EQ(p.b, q.b);
  EXPECT_DOUBLE_EQ(5 * p.gap, q.gap);
}

void expect_same(const Polygons& polygons, const Point& at, const Point& motion) {
  const Answers upright(polygons, at, motion, 1);
  const Answers turned({slanting(polygons.a), slanting(polygons.b)}, slanting(at), slanting(motion),
                       5);
  EXPECT_EQ(upright.separation.relation, turned.separation.relation);
  EXPECT_DOUBLE_EQ(5 * upright.separation.distance, turned.separation.distance);
  expect_same_features(upright.separation.nearest, turned.separation.nearest);
  EXPECT_EQ(upright.impact.hit, turned.impact.hit);
  EXPECT_EQ(upright.impact.time, turned.impact.time);
  EXPECT_EQ(upright.impact.contact.a, turned.impact.contact.a);
  EXPECT_EQ(upright.impact.contact.b, turned.impact.contact.b);
  ASSERT_EQ(upright.contacts.size(), turned.contacts.size());
  for (std::size_t k = 0; k < upright.contacts.size(); ++k) {
    expect_same_features(upright.contacts[k], turned.contacts[k]);
  }
}

TEST(SlantingPairs, AreAsUprightOnes) {
  constexpr int teeth = 120;
  constexpr double height = 8 * teeth;
  const PointVector pocket = comb(teeth, 4, height);
  const Polygons in_pocket{{{{-40, -40}, {1000, -40}, {1000, 1000}, {-40, 1000}}, pocket},
                           {comb(teeth, 2, height - 8)}};
  for (const Point& at : {Point{1, 0}, Point{0.5, 0.25}, Point{2, 1}, Point{0, 0}, Point{3, 1},
                          Point{1, 9}, Point{1, -1}}) {
    expect_same(in_pocket, at, {0.75, 0.5});
    expect_same({in_pocket.b, in_pocket.a}, {-at.x, -at.y}, {-0.5, 9});
  }
  PointVector turned = comb(teeth, 3, height);
  for (Point& p : turned) {
    p = {-p.x, -p.y};
  }
  const Polygons facing{{pocket}, {turned}};
  for (const Point& at : {Point{960, 1400}, Point{959, 1921}, Point{959.5, 1000}, Point{960, 960},
                          Point{958, 2000}}) {
    expect_same(facing, at, {0.5, -700});
  }
  const Polygons spirals{{spiral(80)}, {spiral(80)}};
  for (const Point& at : {Point{1, 1}, Point{1.5, 1.25}, Point{2, 2}, Point{900, 650},
                          Point{-5000, 3000}, Point{7000, 100}}) {
    expect_same(spirals, at, {-at.x / 2, -at.y / 4});
  }
}

// A small polygon beside a large one finds it in the order of a curve, the same one with more
// vertices in that of the boundary.
TEST(SlantingPairs, AreTheSameInAnyOrder) {
  PointVector large;
  PointVector inner;
  for (int k = 0; k <= 2400; ++k) {
    const double angle = k * M_PI / 20;
    const double radius = 10 + angle;
    large.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    inner.push_back({(radius - 2) * std::cos(angle), (radius - 2) * std::sin(angle)});
  }
  large.insert(large.end(), inner.rbegin(), inner.rend());
  // Shorter than most edges; and longer than all, outside of most windings.
  for (const double side : {2.0, 300.0}) {
    const PointVector few{{0, 0}, {side, 0}, {side, side}, {0, side}};
    PointVector many;
    for (std::size_t k = 0; k < few.size(); ++k) {
      const Point& p = few[k];
      const Point& q = few[(k + 1) % few.size()];
      for (int part = 0; part < 128; ++part) {
        many.push_back({p.x + (q.x - p.x) * part / 128, p.y + (q.y - p.y) * part / 128});
      }
    }
    int apart = 0;
    for (int k = 0; k < 60; ++k) {
      const Point at =
          side == 2 ? Point{4 * k - 20.25, 15.5 + 2 * k} : Point{377.5 + 0.5 * k, 15.5 - 3 * k};
      const Point motion{3, k % 2 == 0 ? 1.0 : -2.0};
      const Answers by_curve({{large}, {few}}, at, motion, 6);
      const Answers by_boundary({{large}, {many}}, at, motion, 6);
      EXPECT_EQ(by_curve.separation.relation, by_boundary.separation.relation);
      EXPECT_EQ(by_curve.separation.distance, by_boundary.separation.distance);
      EXPECT_EQ(by_curve.impact.hit, by_boundary.impact.hit);
      EXPECT_EQ(by_curve.impact.time, by_boundary.impact.time);
      EXPECT_EQ(by_curve.contacts.empty(), by_boundary.contacts.empty());
      apart += by_curve.separation.relation == Relation::apart ? 1 : 0;
    }
    EXPECT_GT(apart, 10);
    EXPECT_LT(apart, 60);
  }
}

}  // namespace
}  // namespace gcv
