// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The reference for two polygons on cases that can be seen by eye.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "contact_reference.hpp"
#include "correct_rounding.hpp"
#include "motion_reference.hpp"
#include "region_families.hpp"
#include "solid_sectors.hpp"

namespace gcv::reference {
namespace {

invariants::Polygon box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Solid square() { return make_solid({box(0, 0, 2, 2)}); }

// A frame, 1 thick, round a hole of 2 x 2.
Solid frame() { return make_solid({box(-1, -1, 3, 3), box(0, 0, 2, 2)}); }

Solid solid_of(const test::Rings& rings) {
  Rings result;
  for (const test::Ring& ring : rings) {
    invariants::Polygon& polygon = result.emplace_back();
    for (const gcv::Point& p : ring) {
      polygon.push_back({p.x, p.y});
    }
  }
  return make_solid(result);
}

Exact place(double x, double y) { return invariants::exact(invariants::Point{x, y}); }

int relation_at(const Solid& a, const Solid& b, double x, double y) {
  return relation(a, moved(b, place(x, y)));
}

std::string names(const std::vector<Contact>& contacts) {
  std::string text;
  for (const Contact& c : contacts) {
    text += std::to_string(c.feature.kind) + ":" + std::to_string(c.feature.a) + "," +
            std::to_string(c.feature.b) + " ";
  }
  return text;
}

// A room of 4 x 4 with a pillar in a corner, where it touches both walls' ends, and one beside it.
Solid room() {
  return complement(make_solid({box(0, 0, 4, 4), {{0, 0}, {1, 0.5}, {0.5, 1}}, box(2, 1, 3, 2)}));
}

TEST(Complements, AreAllOutsideAndTheHoles) {
  const Solid solid = room();
  const auto location_at = [&](double x, double y) { return location(solid, place(x, y)); };
  EXPECT_EQ(location_at(-1, 2), 1);
  EXPECT_EQ(location_at(9, 9), 1);
  EXPECT_EQ(location_at(0, 2), 0);
  EXPECT_EQ(location_at(0.5, 2), -1);
  EXPECT_EQ(location_at(2.5, 1.5), 1);
  EXPECT_EQ(location_at(2, 1), 0);
  EXPECT_EQ(location_at(0.5, 0.5), 1);
  for (const Exact& p : solid.inner_points) {
    EXPECT_EQ(location(solid, p), 1);
  }
}

TEST(Complements, KeepNumbersAndHaveTheSolidOnTheirLeft) {
  const Solid polygon = frame();
  const Solid solid = complement(polygon);
  ASSERT_EQ(solid.edges.size(), polygon.edges.size());
  for (std::size_t k = 0; k < solid.edges.size(); ++k) {
    const Edge& edge = solid.edges[k];
    const Corner& corner = solid.corners[k];
    EXPECT_EQ(edge.from, corner.place);
    EXPECT_EQ(edge.to, corner.after);
    const auto same = std::find_if(polygon.edges.begin(), polygon.edges.end(),
                                   [&](const Edge& e) { return e.number == edge.number; });
    EXPECT_TRUE(same->from == edge.to && same->to == edge.from);
    const auto there = std::find_if(polygon.corners.begin(), polygon.corners.end(),
                                    [&](const Corner& c) { return c.number == corner.number; });
    EXPECT_TRUE(there->place == corner.place && there->before == corner.after);
    EXPECT_NE(there->is_convex(), corner.is_convex());
  }
}

TEST(Complements, HoldWhatIsInThem) {
  const Solid b = make_solid({box(0, 0, 1, 1)});
  EXPECT_EQ(relation_at(room(), b, 0.5, 2.5), apart);
  EXPECT_EQ(relation_at(room(), b, 0, 2.5), touching);
  EXPECT_EQ(relation_at(room(), b, 1, 2), touching);
  EXPECT_EQ(relation_at(room(), b, -0.5, 2.5), overlapping);
  EXPECT_EQ(relation_at(room(), b, -1, 2.5), overlapping);
  EXPECT_EQ(relation_at(room(), b, 7, 7), overlapping);
  EXPECT_EQ(relation_at(room(), b, 2, 1), overlapping);
  EXPECT_EQ(separation(room(), moved(b, place(0.75, 1.5))).squared_distance, Rational(1, 16));
  EXPECT_EQ(names(contacts(room(), moved(b, place(3, 3)), 0, 0)), "1:1,1 1:1,2 1:2,2 1:2,3 ");
  const Impact impact = reference::impact(room(), moved(b, place(1.5, 3)), place(4, 0));
  EXPECT_TRUE(impact.hit);
  EXPECT_EQ(impact.time, Rational(3, 8));
  EXPECT_EQ(names(impact.entered.contacts), "1:1,1 3:2,2 ");
}

TEST(Solids, HaveTheCallersNumbers) {
  // Clockwise, with a repeated vertex, a collinear one and a closing one.
  const Solid solid = make_solid({{{0, 0}, {0, 2}, {0, 2}, {1, 2}, {2, 2}, {2, 0}, {0, 0}}});
  std::string text;
  for (std::size_t k = 0; k < solid.edges.size(); ++k) {
    text +=
        std::to_string(solid.corners[k].number) + "/" + std::to_string(solid.edges[k].number) + " ";
  }
  EXPECT_EQ(text, "5/4 4/3 2/0 0/5 ");
  // A hole goes clockwise.
  EXPECT_EQ(frame().corners.back().number, 4U);
  EXPECT_EQ(frame().edges.back().number, 7U);
}

TEST(Solids, KnowWhereTheirInnerPointsAre) {
  // A hole that cuts the inside in two.
  const Solid apart_inside =
      make_solid({box(0, 0, 4, 2), {{2, 0}, {3, 1}, {2, 2}, {1, 1}}, box(3, 0.5, 3.5, 1.5)});
  for (const Solid& solid : {square(), frame(), apart_inside}) {
    EXPECT_EQ(solid.inner_points.size(), solid.edges.size());
    for (const Exact& x : solid.inner_points) {
      EXPECT_EQ(location(solid, x), 1);
    }
  }
}

TEST(Relation, OfBoxes) {
  EXPECT_EQ(relation_at(square(), square(), 0, 0), overlapping);
  EXPECT_EQ(relation_at(square(), square(), 1, 1), overlapping);
  EXPECT_EQ(relation_at(square(), square(), 2, 1), touching);
  EXPECT_EQ(relation_at(square(), square(), 2, 2), touching);
  EXPECT_EQ(relation_at(square(), square(), 2, -2.5), apart);
  const Solid small = make_solid({box(0, 0, 1, 1)});
  EXPECT_EQ(relation_at(square(), small, 0.5, 0.5), overlapping);
  EXPECT_EQ(relation_at(small, square(), -0.5, -0.5), overlapping);
}

TEST(Relation, InHoles) {
  const Solid small = make_solid({box(0, 0, 1, 1)});
  EXPECT_EQ(relation_at(frame(), small, 0.5, 0.5), apart);
  EXPECT_EQ(relation_at(frame(), small, 0, 0.5), touching);
  EXPECT_EQ(relation_at(frame(), square(), 0, 0), touching);
  EXPECT_EQ(relation_at(frame(), square(), 0, std::ldexp(1.0, -60)), overlapping);
  EXPECT_EQ(relation_at(frame(), frame(), 0, 0), overlapping);
  EXPECT_EQ(relation_at(frame(), make_solid({box(-1, -1, 3, 3)}), 0, 0), overlapping);
}

TEST(Relation, WhereAnInteriorFallsApart) {
  // The hole leaves a triangle in each corner.
  const invariants::Polygon hole{{1, 0}, {2, 1}, {1, 2}, {0, 1}};
  const Solid triangles = make_solid({box(0, 0, 2, 2), hole});
  EXPECT_EQ(relation(triangles, triangles), overlapping);
  EXPECT_EQ(relation(triangles, square()), overlapping);
  EXPECT_EQ(relation(triangles, make_solid({hole})), touching);
  EXPECT_EQ(relation(triangles, make_solid({{{0, 0}, {1, 0}, {0, 1}}})), overlapping);
  EXPECT_EQ(relation(triangles, make_solid({{{1, 0.5}, {1.5, 1.5}, {1, 1.5}}})), touching);
  EXPECT_EQ(relation(triangles, make_solid({{{1, 0.5}, {1.25, 1}, {1, 1.5}}})), apart);
}

TEST(Distance, NamesTheSmallestFeature) {
  const Separation side = separation(square(), moved(square(), place(5, 0)));
  EXPECT_EQ(side.relation, apart);
  EXPECT_EQ(side.squared_distance, 9);
  // The edges are opposite each other: only vertices have their feet inside none.
  EXPECT_EQ(side.nearest->feature, (Feature{vertex_vertex, 1, 0}));
  const Separation shifted = separation(square(), moved(square(), place(5, 1)));
  EXPECT_EQ(shifted.nearest->feature, (Feature{edge_vertex, 1, 0}));
  EXPECT_EQ(shifted.nearest->on_a, place(2, 1));
  EXPECT_EQ(shifted.nearest->on_b, place(5, 1));
  EXPECT_EQ(sign(shifted.nearest->normal.x), 1);
  const Separation diagonal = separation(square(), moved(square(), place(5, 6)));
  EXPECT_EQ(diagonal.squared_distance, 25);
  EXPECT_EQ(diagonal.nearest->normal, place(3, 4));
  const Separation inside = separation(frame(), make_solid({{{1, 0.5}, {1.5, 1}, {1, 1.5}}}));
  EXPECT_EQ(inside.squared_distance, Rational(1, 4));
  EXPECT_EQ(inside.nearest->feature.kind, edge_vertex);
  const Separation corner = separation(make_solid({{{0, 0}, {-1, 1}, {-1, -1}}}), square());
  EXPECT_EQ(corner.relation, touching);
  EXPECT_FALSE(corner.nearest);
}

TEST(Cast, StopsAtAnEdge) {
  const Impact hit = impact(square(), moved(square(), place(5, 1)), place(-6, 0));
  EXPECT_TRUE(hit.hit);
  EXPECT_EQ(hit.time, Rational(1, 2));
  EXPECT_EQ(names(hit.entered.contacts), "1:1,0 2:2,3 ");
}

TEST(Cast, SlidesAndGrazes) {
  EXPECT_FALSE(impact(square(), moved(square(), place(2, -5)), place(0, 10)).hit);
  EXPECT_FALSE(impact(square(), moved(square(), place(2, -2)), place(1, 1)).hit);
  // Corner to corner, diagonally past each other.
  EXPECT_FALSE(impact(square(), moved(square(), place(1, 3)), place(2, -2)).hit);
  EXPECT_TRUE(impact(square(), moved(square(), place(1, 3)), place(2, -2.5)).hit);
  // Touching at the end.
  EXPECT_FALSE(impact(square(), moved(square(), place(4, 0)), place(-2, 0)).hit);
  EXPECT_EQ(impact(square(), moved(square(), place(4, 0)), place(-2, 0)).time, 1);
  EXPECT_FALSE(impact(square(), moved(square(), place(2, 0)), place(0, 0)).hit);
}

TEST(Cast, StartsInTheOther) {
  const Impact inside = impact(square(), square(), place(9, 9));
  EXPECT_TRUE(inside.hit);
  EXPECT_EQ(inside.time, 0);
  EXPECT_TRUE(inside.entered.empty());
  EXPECT_TRUE(impact(square(), square(), place(0, 0)).hit);
  const Impact touch = impact(square(), moved(square(), place(2, 0)), place(-1, 0));
  EXPECT_EQ(touch.time, 0);
  EXPECT_EQ(names(touch.entered.contacts), "3:1,0 3:2,3 ");
}

TEST(Cast, EntersAndLeavesSlots) {
  // A slot as wide as what goes in.
  const Solid block =
      make_solid({{{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}});
  const Impact down = impact(block, moved(square(), place(2, 6)), place(0, -8));
  EXPECT_TRUE(down.hit);
  EXPECT_EQ(down.time, Rational(1, 2));
  EXPECT_EQ(names(down.entered.contacts), "3:4,1 3:5,0 ");
  EXPECT_FALSE(impact(block, moved(square(), place(2, 2)), place(0, 8)).hit);
  const Impact beside = impact(block, moved(square(), place(2.5, 6)), place(0, -8));
  EXPECT_EQ(beside.time, Rational(1, 4));
  EXPECT_EQ(names(beside.entered.contacts), "1:2,1 2:3,0 ");
}

TEST(Cast, EntersSectorsWhereRingsTouch) {
  // Two lenses that meet in (0, 2) and (0, -2). b has a part between them and a part round the
  // right one, which meet in the same points.
  const Solid a =
      make_solid({{{-3, 0}, {0, -2}, {3, 0}, {0, 2}}, {{-1, 0}, {0, 2}, {1, 0}, {0, -2}}});
  const Solid b = make_solid({{{0, 2}, {-0.5, 0}, {0, -2}, {-1, -5}, {8, -5}, {8, 5}, {-1, 5}},
                              {{0, 2}, {0.5, 0}, {0, -2}, {1, -4}, {7, -4}, {7, 4}, {1, 4}}});
  EXPECT_EQ(relation(a, b), touching);
  EXPECT_EQ(sectors_at(a, place(0, 2)).size(), 2U);
  EXPECT_EQ(sectors_at(b, place(0, 2)).size(), 2U);
  for (const double x : {-1.0, 1.0}) {
    const Impact hit = impact(a, b, place(x, 0));
    EXPECT_TRUE(hit.hit);
    EXPECT_EQ(hit.time, 0);
    EXPECT_TRUE(hit.entered.contacts.empty());
    ASSERT_FALSE(hit.entered.empty());
    EXPECT_EQ(hit.entered.where_rings_touch.front().front().feature,
              (Feature{vertex_vertex, 1, 2}));
  }
}

TEST(Escape, TakesTheShortestWay) {
  EXPECT_EQ(escape(square(), moved(square(), place(0.5, 0))), place(1.5, 0));
  EXPECT_EQ(escape(square(), square()), place(-2, 0));
  EXPECT_EQ(escape(square(), moved(square(), place(2, 0))), place(0, 0));
  // Into the hole, where it just fits.
  EXPECT_EQ(escape(frame(), moved(square(), place(0.25, 0.5))), place(-0.25, -0.5));
}

TEST(Escape, IsFreeAndNothingNearerIs) {
  test::Random random(1);
  for (int k = 0; k < 20; ++k) {
    const test::RegionCase c = test::with_holes(random);
    const Solid a = solid_of(c.a);
    const Solid b = solid_of(test::negated(c.b));
    const Exact t = place(test::uniform(random, 0, 32) / 8.0, test::uniform(random, 0, 32) / 8.0);
    const Exact v = escape(a, moved(b, t));
    EXPECT_FALSE(overlap(a, moved(b, t + v)));
    for (int x = -4; x <= 4; ++x) {
      for (int y = -4; y <= 4; ++y) {
        const Exact w{v.x * x / 4 + v.y * y / 4, v.y * x / 4 - v.x * y / 4};
        EXPECT_TRUE(overlap(a, moved(b, t + w)) || dot(w, w) >= dot(v, v));
      }
    }
  }
}

TEST(Contacts, OfBoxesSideBySide) {
  const Solid b = moved(square(), place(2.5, 0.5));
  EXPECT_EQ(names(contacts(square(), b, Rational(1, 2), 0)), "1:1,0 2:2,3 ");
  // At its ends an edge is as far as its vertex.
  EXPECT_EQ(names(contacts(square(), moved(square(), place(2.5, 0)), Rational(1, 2), 0)),
            "1:1,0 1:1,3 2:1,3 2:2,3 3:1,0 3:2,3 ");
  const std::vector<Contact> deep = contacts(square(), moved(square(), place(1.75, 0.5)), 1, 0);
  ASSERT_FALSE(deep.empty());
  EXPECT_EQ(deep.front().feature, (Feature{edge_vertex, 1, 0}));
  EXPECT_TRUE(deep.front().is_deep);
}

TEST(Contacts, OfFacesThatAreNearlyParallel) {
  // The lower edge of b is turned by 1/64: its right end is higher.
  const Solid b = make_solid({{{0.5, 2}, {1.5, 2.015625}, {1, 3}}});
  EXPECT_EQ(names(contacts(square(), b, Rational(1, 8), 0)), "1:2,0 ");
  EXPECT_EQ(names(contacts(square(), b, Rational(1, 8), Rational(1, 64))), "1:2,0 1:2,1 ");
  EXPECT_EQ(names(contacts(square(), b, Rational(1, 8), Rational(1, 65))), "1:2,0 ");
}

TEST(Rounding, IsShownByMiddles) {
  using invariants::is_nearest;
  using invariants::is_nearest_root;
  const double tiny = std::numeric_limits<double>::denorm_min();
  const double largest = std::numeric_limits<double>::max();
  EXPECT_TRUE(is_nearest_root(std::sqrt(2.0), 2));
  EXPECT_FALSE(is_nearest_root(std::nextafter(std::sqrt(2.0), 0), 2));
  EXPECT_FALSE(is_nearest_root(std::nextafter(std::sqrt(2.0), 2), 2));
  EXPECT_TRUE(is_nearest_root(0, Rational(tiny) * Rational(tiny) / 4));  // a tie, to even
  EXPECT_FALSE(is_nearest_root(tiny, Rational(tiny) * Rational(tiny) / 4));
  EXPECT_TRUE(is_nearest_root(tiny, Rational(tiny) * Rational(tiny) / 3));
  EXPECT_TRUE(is_nearest_root(largest, Rational(largest) * Rational(largest)));
  EXPECT_TRUE(invariants::root_overflows(Rational(largest) * Rational(largest) * 2));
  const Rational half_ulp = Rational(std::ldexp(1.0, -53));
  EXPECT_TRUE(is_nearest(1, 1 + half_ulp));
  EXPECT_FALSE(is_nearest(1 + std::ldexp(1.0, -52), 1 + half_ulp));
  EXPECT_TRUE(is_nearest(1 + std::ldexp(1.0, -51), 1 + 3 * half_ulp));
  EXPECT_FALSE(is_nearest(-0.0, 0));
  EXPECT_FALSE(invariants::overflows(Rational(largest)));
  EXPECT_TRUE(invariants::overflows(Rational(largest) * 2));
  EXPECT_TRUE(invariants::is_rounded_down(1.0 / 3, Rational(1, 3)));
  EXPECT_FALSE(invariants::is_rounded_down(std::nextafter(1.0 / 3, 1), Rational(1, 3)));
  EXPECT_TRUE(invariants::is_near_quotient(0.6, 3, 25));
  EXPECT_FALSE(invariants::is_near_quotient(0.6 + std::ldexp(3.0, -53), 3, 25));
  EXPECT_FALSE(invariants::is_near_quotient(-0.6, 3, 25));
}

}  // namespace
}  // namespace gcv::reference
