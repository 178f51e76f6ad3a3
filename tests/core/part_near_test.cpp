// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Parts of boundaries near a box: the same solid within the box, with few vertices.
#include "part_near.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "boundary.hpp"
#include "generators.hpp"

namespace gcv {
namespace {

// How often the rings wind round a point that is on none of them.
int winding(const Boundary& boundary, const Point& p) {
  int turns = 0;
  for (Index i = 0; i < boundary.size(); ++i) {
    const Point& from = boundary.vertices[i];
    const Point& to = boundary.vertices[boundary.next(i)];
    const double side = (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
    if (from.y <= p.y && to.y > p.y && side > 0) {
      ++turns;
    } else if (from.y > p.y && to.y <= p.y && side < 0) {
      --turns;
    }
  }
  return turns;
}

// A rough coast, with square islands in its sea.
Boundary coast_with_islands(test::Random& random, int vertices, bool with_islands) {
  PointVector ring;
  for (int k = 0; k < vertices; ++k) {
    const double angle = 2 * std::numbers::pi * k / vertices;
    const double radius = test::uniform(random, 900, 1100) / 10.0;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  const Boundary outer = make_ring(ring, "ring");
  std::vector<Boundary> islands;
  for (int x = -50; with_islands && x <= 50; x += 10) {
    for (int y = -50; y <= 50; y += 10) {
      islands.push_back(make_ring({{x + 0.5, y + 0.5}, {x + 4.5, y + 0.5}, {x + 4.5, y + 4.5}},
                                  "hole", Boundary::Kind::hole));
    }
  }
  std::vector<const Boundary*> all;
  for (const Boundary& island : islands) {
    all.push_back(&island);
  }
  return joined(outer, all);
}

void expect_same_within(const Boundary& boundary, const Boundary& part, const Box& box) {
  for (int x = 0; x <= 20; ++x) {
    for (int y = 0; y <= 20; ++y) {
      const Point p{box.x0 + (box.x1 - box.x0) * x / 20, box.y0 + (box.y1 - box.y0) * y / 20};
      ASSERT_EQ(winding(part, p), winding(boundary, p)) << p.x << ' ' << p.y;
    }
  }
  for (Index i = 0; i < boundary.size(); ++i) {
    const Point& p = boundary.vertices[i];
    if (p.x >= box.x0 && p.x <= box.x1 && p.y >= box.y0 && p.y <= box.y1) {
      ASSERT_NE(std::find(part.vertices.begin(), part.vertices.end(), p), part.vertices.end());
    }
  }
}

TEST(PartNear, IsTheSameWithinTheBox) {
  test::Random random(2);
  std::size_t parts = 0;
  for (int k = 0; k < 300; ++k) {
    SCOPED_TRACE(k);
    const Boundary solid = coast_with_islands(random, 400, k % 2 == 0);
    const Boundary boundary = k % 3 == 0 ? joined(solid, {}) : solid.complement();
    const double x = test::uniform(random, -110, 110) + 0.25;
    const double y = test::uniform(random, -110, 110) + 0.25;
    const Box box{x, y, x + test::uniform(random, 1, 40), y + test::uniform(random, 1, 40)};
    const auto part = part_near(boundary, box);
    if (part) {
      ++parts;
      EXPECT_LE(part->size(), boundary.size() / 2);
      EXPECT_EQ(part->kind, boundary.kind);
      expect_same_within(boundary, *part, box);
    }
  }
  EXPECT_GT(parts, 150U);
}

// Of a coast that is far from the box, a few vertices are left.
TEST(PartNear, IsSmallFarFromTheBoundary) {
  test::Random random(2);
  const Boundary boundary = coast_with_islands(random, 4000, false).complement();
  const auto part = part_near(boundary, {-1, -1, 1, 1});
  ASSERT_TRUE(part);
  EXPECT_LE(part->size(), 12U);
  EXPECT_FALSE(part_near(boundary, {-200, -200, 200, 200}));
}

}  // namespace
}  // namespace gcv
