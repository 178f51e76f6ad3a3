// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The order of vertices of regions against their fractions.
#include "exact_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "exact_rings.hpp"
#include "region_families.hpp"
#include "regions.hpp"

namespace gcv {
namespace {

using invariants::Exact;

int sign_of(int x) { return (x > 0) - (x < 0); }
int order_of(const Exact& p, const Exact& q) { return p < q ? -1 : q < p ? 1 : 0; }

// A region and its vertices in fractions.
struct Example {
  Region region;
  invariants::Ring points;
  Tally tally;
  [[nodiscard]] ExactOrder order() {
    return {*region.exact.a.ring, *region.exact.b.ring, region.exact.shift, tally};
  }
};

template <class Visit>
void for_each_example(int count, Visit visit) {
  for (const test::RegionFamily& family : test::region_families()) {
    test::Random random(351);
    for (int k = 0; k < count; ++k) {
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(k));
      const test::RegionCase c = family.next_case(random);
      // Thirds of a shift make vertices that are not doubles.
      const Point shift = k % 2 == 0 ? c.shift : Point{c.shift.x + 1.0 / 3, c.shift.y - 0x1p-60};
      Example example{
          c.inner_fit ? test::fit_region(c.a, c.b, shift) : test::sum_region(c.a, c.b, shift),
          {},
          {}};
      example.points = test::exact(example.region.exact);
      visit(example);
    }
  }
}

TEST(ExactOrder, IsThatOfFractions) {
  std::size_t equal = 0;
  std::size_t by_fractions = 0;
  for_each_example(15, [&](Example& example) {
    const ExactOrder order = example.order();
    const std::vector<RingVertex>& vertices = example.region.exact.vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      for (std::size_t j = 0; j < vertices.size(); ++j) {
        const int expected = order_of(example.points[i], example.points[j]);
        ASSERT_EQ(sign_of(order.compare(vertices[i], vertices[j])), expected);
        equal += i != j && expected == 0 ? 1U : 0U;
      }
    }
    by_fractions += example.tally.rational;
  });
  EXPECT_GT(equal, 20U);
  EXPECT_GT(by_fractions, 100U);
}

// Doubles around each vertex.
TEST(ExactOrder, OfAVertexAndAPoint) {
  std::size_t equal = 0;
  for_each_example(15, [&](Example& example) {
    const ExactOrder order = example.order();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < example.points.size(); ++i) {
      const auto placed = order.placed(example.region.exact.vertices[i]);
      const auto [x, y] = invariants::nearest(example.points[i]);
      for (const double near_x : {x, std::nextafter(x, infinity), std::nextafter(x, -infinity)}) {
        for (const double near_y : {y, std::nextafter(y, infinity), std::nextafter(y, -infinity)}) {
          const Point p{near_x, near_y};
          const int expected = order_of(example.points[i], test::exact(p));
          ASSERT_EQ(sign_of(order.compare(placed, p)), expected);
          equal += expected == 0 ? 1U : 0U;
        }
      }
    }
  });
  EXPECT_GT(equal, 500U);
}

// Boxes overlap where the boxes of the fractions do.
TEST(ExactOrder, BoxesOfEdgesOverlap) {
  std::size_t overlapping = 0;
  for_each_example(10, [&](Example& example) {
    const ExactOrder order = example.order();
    const std::vector<RingVertex>& vertices = example.region.exact.vertices;
    const std::size_t n = vertices.size();
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < n; ++i) {
      boxes.push_back(
          ExactOrder::box_of_edge(order.placed(vertices[i]), order.placed(vertices[(i + 1) % n])));
    }
    const auto are_apart_exactly = [&](std::size_t i, std::size_t j) {
      const auto [x0, x1] = std::minmax(example.points[i].x, example.points[(i + 1) % n].x);
      const auto [y0, y1] = std::minmax(example.points[i].y, example.points[(i + 1) % n].y);
      const Exact& p = example.points[j];
      const Exact& q = example.points[(j + 1) % n];
      return std::max(p.x, q.x) < x0 || x1 < std::min(p.x, q.x) || std::max(p.y, q.y) < y0 ||
             y1 < std::min(p.y, q.y);
    };
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        if (!are_apart_exactly(i, j)) {
          ++overlapping;
          ASSERT_FALSE(are_apart(boxes[i], boxes[j]));
        }
      }
    }
  });
  EXPECT_GT(overlapping, 1000U);
}

TEST(ExactOrder, OrdersRings) {
  std::size_t rings = 0;
  for_each_example(10, [&](Example& example) {
    const ExactOrder order = example.order();
    std::vector<std::vector<RingVertex>> all;
    for (const RegionPart& part : example.region.exact.parts) {
      if (!part.is_ring()) {
        continue;
      }
      const auto first =
          example.region.exact.vertices.begin() + static_cast<std::ptrdiff_t>(part.first);
      std::vector<RingVertex> ring(first, first + static_cast<std::ptrdiff_t>(part.size));
      const RingVertex smallest = ring.front();
      std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(ring.size() / 2),
                  ring.end());
      order.begin_with_smallest(ring);
      ASSERT_EQ(order.compare(ring.front(), smallest), 0);
      all.push_back(std::move(ring));
      ++rings;
    }
    for (const auto& p : all) {
      ASSERT_FALSE(order.is_before(p, p));
      const std::vector<RingVertex> longer = [&] {
        std::vector<RingVertex> ring = p;
        ring.push_back(p.front());
        return ring;
      }();
      ASSERT_TRUE(order.is_before(p, longer));
      ASSERT_FALSE(order.is_before(longer, p));
      for (const auto& q : all) {
        const int by_first = order.compare(p.front(), q.front());
        if (by_first != 0) {
          ASSERT_EQ(order.is_before(p, q), by_first < 0);
        } else if (&p != &q) {
          ASSERT_NE(order.is_before(p, q), order.is_before(q, p));
        }
      }
    }
  });
  EXPECT_GT(rings, 100U);
}

}  // namespace
}  // namespace gcv
