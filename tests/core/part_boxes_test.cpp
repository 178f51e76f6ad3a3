// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Boxes of the pieces of a polygon hold these, and no more of the plane than pays.
#include "part_boxes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "boundary.hpp"
#include "convex_pieces.hpp"

namespace gcv {
namespace {

double area(const std::vector<Box>& boxes) {
  double sum = 0;
  for (const Box& box : boxes) {
    sum += (box.x1 - box.x0) * (box.y1 - box.y0);
  }
  return sum;
}

// Does one of the boxes hold the point, or nearly?
bool hold(const std::vector<Box>& boxes, const Point& p) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) {
    const Box wide = widened(box, 1e-9);
    return p.x >= wide.x0 && p.x <= wide.x1 && p.y >= wide.y0 && p.y <= wide.y1;
  });
}

Boundary turned(const PointVector& ring, double angle) {
  PointVector points;
  for (const Point& p : ring) {
    points.push_back({std::cos(angle) * p.x - std::sin(angle) * p.y,
                      std::sin(angle) * p.x + std::cos(angle) * p.y});
  }
  return make_ring(points, "ring");
}

TEST(PartBoxes, AreOneWhereFewAreMet) {
  for (const double angle : {0.0, 0.3, 2.0}) {
    const Boundary bar = turned({{0, 0}, {100, 0}, {100, 1}, {0, 1}}, angle);
    for (const double meeting : {0.0, 1e-4}) {
      const std::vector<Box> boxes = part_boxes(bar, meeting);
      ASSERT_EQ(boxes.size(), 1U);
      EXPECT_EQ(area(boxes), area({bar.relative_bounds()}));
    }
  }
}

TEST(PartBoxes, HoldThePieces) {
  const PointVector angle_iron{{0, 0}, {100, 0}, {100, 1}, {1, 1}, {1, 100}, {0, 100}};
  for (const double angle : {0.0, 0.3, 2.0, 4.0}) {
    for (const PointVector& ring : {angle_iron, PointVector{{0, 0}, {100, 0}, {70, 3}}}) {
      const Boundary polygon = turned(ring, angle);
      const std::vector<Box> boxes = part_boxes(polygon, 10);
      const ConvexPieces& pieces = polygon.convex_pieces();
      ASSERT_GT(pieces.count(), 0U);
      for (std::size_t k = 0; k < pieces.count(); ++k) {
        const std::span<const Index> piece = pieces.piece(k);
        for (const Index i : piece) {
          for (const Index j : piece) {
            for (const double t : {0.0, 0.13, 0.5, 0.71}) {
              const Point p = polygon.relative(i);
              const Point q = polygon.relative(j);
              EXPECT_TRUE(hold(boxes, {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)}));
            }
          }
        }
      }
      EXPECT_LT(area(boxes), 0.6 * area({polygon.relative_bounds()}));
    }
  }
}

// As many as pay: more where more is met.
TEST(PartBoxes, AreMoreWhereMoreIsMet) {
  const Boundary bar = turned({{0, 0}, {100, 0}, {100, 1}, {0, 1}}, 0.3);
  std::size_t before = 1;
  for (const double meeting : {0.1, 1.0, 10.0}) {
    const std::size_t count = part_boxes(bar, meeting).size();
    EXPECT_GT(count, before);
    EXPECT_LE(count, 32U);
    before = count;
  }
}

TEST(PartBoxes, OfHugePolygonsAreOne) {
  const Boundary bar = make_ring({{0, 0}, {1e200, 1e200}, {1e200, 1.1e200}, {0, 1e199}}, "bar");
  EXPECT_EQ(part_boxes(bar, 1e-300).size(), 1U);
  EXPECT_EQ(part_boxes(bar, std::nan("")).size(), 1U);
}

}  // namespace
}  // namespace gcv
