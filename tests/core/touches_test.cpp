// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Touches of rings against all pairs of an edge and a vertex. Coordinates are small integers, whose
// cross products are exact in doubles.
#include "touches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

#include "boundary.hpp"
#include "polygon.hpp"
#include "region_families.hpp"

namespace gcv {
namespace {

using Set = std::set<Index>;

Set set_of(const std::vector<Index>& numbers) { return {numbers.begin(), numbers.end()}; }

bool is_inside_edge(const Point& p, const Point& q, const Point& x) {
  const double cross = (q.x - p.x) * (x.y - p.y) - (q.y - p.y) * (x.x - p.x);
  const double along = (x.x - p.x) * (q.x - x.x) + (x.y - p.y) * (q.y - x.y);
  return cross == 0 && along > 0;
}

// What there is in the place of a vertex.
struct Expected {
  Set vertices;
  Set leaving;
  Set arriving;
  [[nodiscard]] bool is_touch() const { return leaving.size() > 1; }
};

Expected expected_at(const Boundary& b, Index vertex) {
  Expected expected;
  const Point& x = b.vertices[vertex];
  for (Index i = 0; i < b.size(); ++i) {
    if (b.vertices[i] == x) {
      expected.vertices.insert(i);
      expected.leaving.insert(i);
      expected.arriving.insert(b.previous(i));
    } else if (is_inside_edge(b.vertices[i], b.vertices[b.next(i)], x)) {
      expected.leaving.insert(i);
      expected.arriving.insert(i);
    }
  }
  return expected;
}

TEST(Touches, AreAllOfThem) {
  test::Random random(311);
  std::size_t touches_in_all = 0;
  std::size_t on_edges = 0;
  for (int k = 0; k < 400; ++k) {
    const test::RegionCase c = test::holes_that_touch(random);
    for (const test::Rings& rings : {c.a, c.b}) {
      const Polygon polygon = make_polygon(rings, "polygon");
      const Boundary& b = polygon.boundary();
      const Touches touches(b.vertices, b.layout);
      std::set<Set> places;
      for (Index i = 0; i < b.size(); ++i) {
        const Expected expected = expected_at(b, i);
        const Touch* const touch = touches.at(i);
        ASSERT_EQ(touch != nullptr, expected.is_touch());
        if (touch == nullptr) {
          continue;
        }
        places.insert(expected.vertices);
        ASSERT_EQ(set_of(touch->vertices), expected.vertices);
        ASSERT_EQ(set_of(touch->leaving), expected.leaving);
        ASSERT_EQ(set_of(touch->arriving), expected.arriving);
        ASSERT_EQ(touch->leaving.size(), expected.leaving.size());
        ASSERT_EQ(touch->arriving.size(), expected.arriving.size());
      }
      ASSERT_EQ(touches.all().size(), places.size());
      ASSERT_EQ(touches.empty(), places.empty());
      touches_in_all += places.size();

      for (Index edge = 0; edge < b.size(); ++edge) {
        const Point& from = b.vertices[edge];
        std::vector<Point> expected;
        for (Index i = 0; i < b.size(); ++i) {
          if (is_inside_edge(from, b.vertices[b.next(edge)], b.vertices[i])) {
            expected.push_back(b.vertices[i]);
          }
        }
        const auto distance = [&](const Point& p) {
          return (p.x - from.x) * (p.x - from.x) + (p.y - from.y) * (p.y - from.y);
        };
        std::sort(expected.begin(), expected.end(),
                  [&](const Point& p, const Point& q) { return distance(p) < distance(q); });
        expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
        std::vector<Point> found;
        for (const Index i : touches.on(edge)) {
          found.push_back(b.vertices[i]);
        }
        ASSERT_EQ(found, expected);
        on_edges += found.size();
      }
    }
  }
  EXPECT_GT(touches_in_all, 300U);
  EXPECT_GT(on_edges, 50U);
}

TEST(Touches, OfOneRingAreNone) {
  const Boundary b = make_ring({{0, 0}, {4, 0}, {4, 4}, {2, 1}}, "polygon");
  const Touches touches(b.vertices, b.layout);
  EXPECT_TRUE(touches.empty());
  EXPECT_EQ(touches.at(2), nullptr);
  EXPECT_TRUE(touches.on(1).empty());
  EXPECT_TRUE(Touches().empty());
}

// Three rings in one point; on an edge of the outer ring that runs downwards, two of them.
TEST(Touches, OfSeveralRingsInOnePoint) {
  const Polygon polygon = make_polygon(std::vector<PointVector>{{{0, 0}, {8, 0}, {8, 8}, {0, 8}},
                                                                {{0, 2}, {2, 1}, {2, 3}},
                                                                {{0, 6}, {2, 5}, {4, 4}, {2, 7}},
                                                                {{4, 4}, {6, 3}, {6, 5}}},
                                       "polygon");
  const Boundary& b = polygon.boundary();
  const Touches touches(b.vertices, b.layout);
  EXPECT_EQ(touches.all().size(), 3U);
  const Index down = 3;  // from (0, 8) to (0, 0)
  ASSERT_EQ(touches.on(down).size(), 2U);
  EXPECT_EQ(b.vertices[touches.on(down)[0]], (Point{0, 6}));
  EXPECT_EQ(b.vertices[touches.on(down)[1]], (Point{0, 2}));
}

}  // namespace
}  // namespace gcv
