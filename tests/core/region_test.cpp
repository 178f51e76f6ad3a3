// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What holds for every region: its first ring is the outer face, roundings are on their sides,
// points are located as fractions say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "error.hpp"
#include "generators.hpp"
#include "locate.hpp"
#include "minkowski_sum.hpp"
#include "region_families.hpp"
#include "regions.hpp"

namespace gcv {
namespace {

using test::PolygonRings;

Region region_of(const test::RegionCase& c, const RegionOptions& options = {}) {
  return c.inner_fit ? test::fit_region(c.a, c.b, c.shift, options)
                     : test::sum_region(c.a, c.b, c.shift, options);
}

template <class Visit>
void for_each_case(int count, Visit visit) {
  for (const test::RegionFamily& family : test::region_families()) {
    test::Random random(7);
    for (int k = 0; k < count; ++k) {
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(k));
      visit(family.next_case(random));
    }
  }
}

std::vector<RegionPart> rings_of(const std::vector<RegionPart>& parts) {
  std::vector<RegionPart> rings;
  std::copy_if(parts.begin(), parts.end(), std::back_inserter(rings),
               [](const RegionPart& part) { return part.is_ring(); });
  return rings;
}

TEST(Region, BeginsWithTheOuterFace) {
  for_each_case(40, [](const test::RegionCase& c) {
    if (c.inner_fit) {
      return;
    }
    for (const Rounding rounding : {Rounding::nearest, Rounding::outward}) {
      RegionOptions options;
      options.rounding = rounding;
      const Region region = region_of(c, options);
      Task task;
      const auto a = std::make_shared<const Polygon>(make_polygon(c.a, "a"));
      const auto b = std::make_shared<const Polygon>(make_polygon(c.b, "b"));
      const OuterFace face =
          minkowski_sum({outer_ring(a), "a"}, {outer_ring(b), "b"}, c.shift, options, task);
      const RegionPart& first = region.rounded.parts.front();
      ASSERT_EQ(first.size, face.rounded.vertices.size());
      ASSERT_TRUE(std::equal(face.rounded.vertices.begin(), face.rounded.vertices.end(),
                             region.rounded.vertices.begin()));
    }
  });
}

TEST(Region, LeavesOutWhatItIsToldTo) {
  for_each_case(40, [](const test::RegionCase& c) {
    RegionOptions options;
    options.leave_out_fits = true;
    const Region whole = region_of(c);
    const Region without_fits = region_of(c, options);
    ASSERT_EQ(without_fits.exact.parts.size(), rings_of(whole.exact.parts).size());
    if (!c.inner_fit) {
      options.leave_out_holes = true;
      ASSERT_EQ(region_of(c, options).exact.parts.size(), 1U);
    }
  });
}

TEST(Region, IsRoundedToTheSafeSide) {
  std::size_t rounded_rings = 0;
  for_each_case(60, [&](const test::RegionCase& c) {
    RegionOptions options;
    options.rounding = Rounding::outward;
    const Region region = region_of(c, options);
    ASSERT_NO_THROW(static_cast<void>(test::rounded_polygons(region.rounded)));
    const RegionLocator locator(region.exact);
    for (const RegionPart& part : rings_of(region.rounded.parts)) {
      ++rounded_rings;
      for (std::size_t k = part.first; k < part.end(); ++k) {
        const int where = locator.locate(region.rounded.vertices[k]);
        ASSERT_TRUE(c.inner_fit ? where >= 0 : where <= 0);
      }
    }
    for (std::size_t k = 0; k < region.rounded.vertices.size(); ++k) {
      ASSERT_LT(region.rounded.exact_indices[k], region.exact.size());
    }
  });
  EXPECT_GT(rounded_rings, 500U);
}

// All superset edges of the hole meet in the one place where it fits.
TEST(Region, HasThePointOfAFitInAHoleOfItsOwnShape) {
  PolygonRings plate{{{-4, -4}, {4, -4}, {4, 4}, {-4, 4}}, {}};
  PolygonRings peg{{}};
  constexpr int spikes = 100;
  for (int k = 0; k < 2 * spikes; ++k) {
    const double radius = k % 2 == 0 ? 2 : 1.5;
    const double angle = 3.141592653589793 * k / spikes;
    plate[1].push_back({radius * std::cos(angle), radius * std::sin(angle)});
    peg[0].push_back({-plate[1].back().x, -plate[1].back().y});
  }
  std::reverse(plate[1].begin(), plate[1].end());
  const Region region = test::sum_region(plate, peg);
  ASSERT_EQ(region.exact.parts.size(), 2U);
  EXPECT_EQ(region.exact.parts.back().kind, PartKind::point);
  EXPECT_EQ(region.rounded.vertices.back(), (Point{0, 0}));
}

// Obstacle and container are some units in the last place large. What is free has no room for its
// doubles without the obstacle.
TEST(Region, InwardKeepsObstacles) {
  const double far = 0x1p52;
  const PolygonRings container{{{far - 2, far + 13}, {far - 12, far - 9}, {far + 13, far - 6}},
                               {{far, far}, {far - 1, far - 1}, {far + 1, far - 1}}};
  const PolygonRings part{{{0, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}};
  RegionOptions options;
  options.rounding = Rounding::outward;
  const Region region = test::fit_region(container, part, {0, 0}, options);
  ASSERT_EQ(region.exact.parts.size(), 2U);
  EXPECT_NE(region.rounded.parts.size(), 1U);
}

// A pocket behind a slit of two units in the last place, and a hole whose corners are thirds. The
// slit stays open in the outer ring.
TEST(Region, OutwardHasNoHolesOutside) {
  const double slit = 4 + 0x1p-50;
  const PolygonRings a{{{0, 0},
                        {12, 0},
                        {12, 7},
                        {0, 7},
                        {0, slit},
                        {1, slit},
                        {1, 6},
                        {4, 6},
                        {4, 1},
                        {1, 1},
                        {1, 3},
                        {0, 3}},
                       {{6, 1}, {10, 2}, {7, 6}}};
  const PolygonRings square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  RegionOptions options;
  options.rounding = Rounding::outward;
  const Region region = test::sum_region(a, square, {0, 0}, options);
  EXPECT_EQ(region.rounded.parts.size(), 2U);
  EXPECT_EQ(region.rounded.parts.front().size, 12U);
  EXPECT_NO_THROW(static_cast<void>(test::rounded_polygons(region.rounded)));
}

// The middles of edges are on them, up to rounding; a corner of a ring is on the boundary.
TEST(Region, LocatesItsCorners) {
  for_each_case(40, [](const test::RegionCase& c) {
    const Region region = region_of(c);
    if (region.rounded.error_bound != 0) {
      return;
    }
    const RegionLocator locator(region.exact);
    for (const Point& p : region.rounded.vertices) {
      ASSERT_EQ(locator.locate(p), 0);
    }
  });
}

TEST(Region, LocatesByTheRings) {
  const PolygonRings ring{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{1, 1}, {9, 1}, {9, 9}, {1, 9}}};
  const PolygonRings square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  const Region region = test::sum_region(ring, square);
  EXPECT_EQ(test::text_of(region.exact),
            "outer 0: 0/1 0/1, 11/1 0/1, 11/1 11/1, 0/1 11/1\n"
            "hole 0: 2/1 2/1, 2/1 9/1, 9/1 9/1, 9/1 2/1\n");
  const RegionLocator locator(region.exact);
  EXPECT_EQ(locator.locate({1, 1}), 1);
  EXPECT_EQ(locator.locate({2, 5}), 0);
  EXPECT_EQ(locator.locate({5, 5}), -1);
  EXPECT_EQ(locator.locate({11, 11}), 0);
  EXPECT_EQ(locator.locate({12, 5}), -1);
  EXPECT_EQ(locator.locate({5, 1}), 1);
}

TEST(Region, OfNothingIsEmpty) {
  const PolygonRings box{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  const PolygonRings larger{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}};
  const Region region = test::fit_region(box, larger);
  EXPECT_TRUE(region.exact.parts.empty());
  EXPECT_TRUE(region.rounded.vertices.empty());
  EXPECT_EQ(RegionLocator(region.exact).locate({0, 0}), -1);
}

// Nothing is certain in doubles there.
TEST(Region, OfTheLargestNumbers) {
  const PolygonRings a{{{2, 0.1}, {7, 1}, {15, 13}, {5, 11}, {3.5, 14}}};
  const PolygonRings b{{{0, 0}, {1.7e308, 1.7e308}, {1e308, 1.6e308}, {0, 1.7e308}}};
  EXPECT_EQ(rings_of(test::sum_region(a, b).exact.parts).size(), 1U);
  const PolygonRings fixed{{{0, 0}, {4, 4}, {2, 3}, {0, 4}}};
  const PolygonRings moving{{{1.7e308, -8}, {-12, -2}, {-1, -13}, {-3, -8}}};
  EXPECT_EQ(rings_of(test::sum_region(fixed, moving, {9, 12}).exact.parts).size(), 1U);
}

// The free positions of a part far below, in a container far above, and the same sideways.
TEST(Region, RefusesPositionsThatNoDoubleHolds) {
  const PolygonRings high{{{0, 1.5e308}, {3, 1.5e308}, {3, 1.7e308}, {0, 1.7e308}}};
  const PolygonRings low{{{0, -1e308}, {1, -1e308}, {1, -0.9e308}, {0, -0.9e308}}};
  const PolygonRings right{{{1.5e308, 0}, {1.7e308, 0}, {1.7e308, 3}, {1.5e308, 3}}};
  const PolygonRings left{{{-1e308, 0}, {-0.9e308, 0}, {-0.9e308, 1}, {-1e308, 1}}};
  EXPECT_THROW(static_cast<void>(test::fit_region(high, low)), Error);
  EXPECT_THROW(static_cast<void>(test::fit_region(right, left)), Error);
}

// Many holes are put in an order of their own. It does not show.
TEST(Region, DoesNotDependOnTheOrderOfHoles) {
  PolygonRings plate{{{0, 0}, {100, 0}, {100, 100}, {0, 100}}};
  for (int k = 0; k < 100; ++k) {
    const double x = 10.0 * (k % 10) + 2;
    const double y = 10.0 * (k / 10) + 2;
    const double size = 3 + k % 4;
    plate.push_back({{x, y}, {x, y + size}, {x + size, y + size}, {x + size, y}});
  }
  const PolygonRings peg{{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}};
  const Region ordered = test::sum_region(plate, peg, {0, 0}, {});
  test::Random random(8);
  std::shuffle(plate.begin() + 1, plate.end(), random);
  const Region shuffled = test::sum_region(plate, peg, {0, 0}, {});
  EXPECT_GT(ordered.exact.parts.size(), 50U);
  ASSERT_EQ(ordered.rounded.parts.size(), shuffled.rounded.parts.size());
  ASSERT_EQ(ordered.rounded.vertices.size(), shuffled.rounded.vertices.size());
  EXPECT_TRUE(std::equal(ordered.rounded.vertices.begin(), ordered.rounded.vertices.end(),
                         shuffled.rounded.vertices.begin()));
}

// Two islands of a container that touch each other's surroundings: rings are cut where the walk
// comes to a point again.
TEST(Region, CutsRingsThatTouchThemselves) {
  const PolygonRings container{{{0, 0}, {10, 0}, {10, 10}, {0, 10}},
                               {{3, 3}, {5, 3}, {5, 5}, {3, 5}},
                               {{6, 6}, {8, 6}, {8, 8}, {6, 8}}};
  const PolygonRings square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  EXPECT_EQ(test::text_of(test::fit_region(container, square).exact),
            "outer 0: 0/1 0/1, 9/1 0/1, 9/1 9/1, 0/1 9/1\n"
            "hole 0: 2/1 2/1, 2/1 5/1, 5/1 5/1, 5/1 2/1\n"
            "hole 0: 5/1 5/1, 5/1 8/1, 8/1 8/1, 8/1 5/1\n");
}

// Its first vertex does not tell in which face it lies.
TEST(Region, HasAnIslandThatTouchesTheWallOnTheLeft) {
  const PolygonRings container{{{0, 0}, {20, 0}, {20, 20}, {0, 20}},
                               {{2, 10}, {4, 8}, {6, 10}, {4, 12}}};
  const PolygonRings part{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
  EXPECT_EQ(test::text_of(test::fit_region(container, part).exact),
            "outer 0: 1/1 1/1, 19/1 1/1, 19/1 19/1, 1/1 19/1\n"
            "hole 0: 1/1 10/1, 4/1 13/1, 7/1 10/1, 4/1 7/1\n");
}

// Round the large island three triples of small ones, each round a face that ends in a vertex of
// the large one: all vertices of an island are on rings of faces that do not hold it.
TEST(Region, FindsTheFaceOfAnIslandWhoseVerticesAreOnOtherFaces) {
  PolygonRings container{{{-20, -20}, {30, -20}, {30, 30}, {-20, 30}}};
  const auto add = [&](double x, double y, double size) {
    container.push_back({{x, y}, {x + size, y}, {x, y + size}});
  };
  add(0, 0, 9);
  for (const auto& [x, y] :
       {Point{10, 0}, Point{10, -2}, Point{12, -2}, Point{0, 10}, Point{-2, 10}, Point{-2, 12},
        Point{-2, 0}, Point{0, -2}, Point{-2, -2}}) {
    add(x, y, 1);
  }
  const PolygonRings part{{{0, 0}, {-1, 0}, {0, -1}}};
  EXPECT_EQ(test::text_of(test::fit_region(container, part).exact),
            "outer 0: -19/1 -19/1, 30/1 -19/1, 30/1 30/1, -19/1 30/1\n"
            "hole 0: -2/1 -2/1, -2/1 2/1, 2/1 -2/1\n"
            "hole 0: -2/1 10/1, -2/1 14/1, 2/1 10/1\n"
            "hole 0: 0/1 0/1, 0/1 10/1, 10/1 0/1\n"
            "hole 0: 10/1 -2/1, 10/1 2/1, 14/1 -2/1\n"
            "outer 1: -2/1 0/1, 0/1 -2/1, 0/1 0/1\n"
            "outer 2: -2/1 12/1, 0/1 10/1, 0/1 12/1\n"
            "outer 3: 10/1 0/1, 12/1 -2/1, 12/1 0/1\n");
}

}  // namespace
}  // namespace gcv
