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
#include <utility>
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

// Rings in any order and from any vertex; one of them twice, and once with a vertex more.
TEST(ExactOrder, SortsRings) {
  std::size_t sorted_rings = 0;
  test::Random shuffle(352);
  for_each_example(10, [&](Example& example) {
    const ExactOrder order = example.order();
    const std::vector<RingVertex>& vertices = example.region.exact.vertices;
    std::vector<std::vector<RingVertex>> rings;
    std::vector<invariants::Ring> expected;
    for (const RegionPart& part : example.region.exact.parts) {
      if (!part.is_ring()) {
        continue;
      }
      const auto first = static_cast<std::ptrdiff_t>(part.first);
      const auto size = static_cast<std::ptrdiff_t>(part.size);
      expected.emplace_back(example.points.begin() + first, example.points.begin() + first + size);
      rings.emplace_back(vertices.begin() + first, vertices.begin() + first + size);
      std::rotate(rings.back().begin(),
                  rings.back().begin() + static_cast<std::ptrdiff_t>(shuffle() % part.size),
                  rings.back().end());
      rings.push_back(rings.back());
      expected.push_back(expected.back());
      rings.push_back({vertices.begin() + first, vertices.begin() + first + size});
      rings.back().push_back(vertices[part.first + 1]);
      expected.push_back(expected.back());
      expected.back().push_back(example.points[part.first + 1]);
    }
    for (std::size_t k = rings.size(); k > 1; --k) {
      std::swap(rings[k - 1], rings[shuffle() % k]);
    }
    order.sort(rings);
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(rings.size(), expected.size());
    for (std::size_t k = 0; k < rings.size(); ++k) {
      ExactRing ring{example.region.exact.a, example.region.exact.b, example.region.exact.shift,
                     rings[k]};
      ASSERT_TRUE(test::exact(ring) == expected[k]);
      ++sorted_rings;
    }
  });
  EXPECT_GT(sorted_rings, 300U);
}

}  // namespace
}  // namespace gcv
