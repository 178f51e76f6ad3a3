// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The tree against all pairs of boxes, one by one.
#include "overlapping_pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "box.hpp"
#include "generators.hpp"

namespace gcv {
namespace {

using test::Random;
using test::uniform;
using Pair = std::pair<std::size_t, std::size_t>;

// Boxes along a random path, some of them far away, at that scale.
std::vector<Box> random_boxes(Random& random, std::size_t count, double scale) {
  std::vector<Box> boxes;
  Point at{1000, -1000};
  for (std::size_t k = 0; k < count; ++k) {
    const Point to{at.x + uniform(random, -20, 20), at.y + uniform(random, -20, 20)};
    const Box box = box_of(at, to);
    boxes.push_back({box.x0 * scale, box.y0 * scale, box.x1 * scale, box.y1 * scale});
    at = uniform(random, 0, 40) == 0 ? Point{at.x + 300, at.y - 100} : to;
  }
  return boxes;
}

bool overlap(const Box& a, const Box& b) {
  return a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1;
}

TEST(OverlappingPairs, FindsEachPairOnceOnEveryLevel) {
  Random random(17);
  std::size_t visited = 0;
  std::size_t possible = 0;
  for (const std::size_t count : {1U, 2U, 7U, 8U, 9U, 63U, 64U, 65U, 200U, 513U, 1500U}) {
    for (const int exponent : {0, -1060, 1010}) {
      const std::vector<Box> boxes = random_boxes(random, count, std::ldexp(1.0, exponent));
      const OverlappingPairs pairs(boxes);
      for (std::uint32_t level = 0; level <= pairs.last_level(); ++level) {
        std::set<Pair> found;
        for (std::uint32_t node = 0; node < pairs.nodes(level); ++node) {
          EXPECT_TRUE(
              pairs.visit_from(level, node, ~std::uint64_t{0}, [&](std::size_t i, std::size_t j) {
                EXPECT_LT(i, j);
                EXPECT_LT(j, count);
                EXPECT_TRUE(found.insert({i, j}).second);
                return true;
              }));
        }
        for (std::size_t i = 0; i < count; ++i) {
          for (std::size_t j = i + 1; j < count; ++j) {
            if (overlap(boxes[i], boxes[j])) {
              ASSERT_TRUE(found.count({i, j}) != 0);
            }
          }
        }
        visited += found.size();
        possible += count * (count - 1) / 2;
      }
    }
  }
  EXPECT_LT(visited, possible / 10);
}

// Is the pair of edges i and j among those that are visited?
bool visits(const OverlappingPairs& pairs, std::size_t i, std::size_t j) {
  bool found = false;
  pairs.visit_all([&](std::size_t k, std::size_t l) { found = found || Pair{k, l} == Pair{i, j}; });
  return found;
}

TEST(OverlappingPairs, OfRoundedPointsTakeRoomForRounding) {
  using Points = OverlappingPairs::Points;
  const double a = 0.5;
  const double b = a + 0x1p-21;
  const test::Ring slot{{0, 0}, {1, 0}, {1, 1}, {b, 1}, {b, 0.25}, {a, 0.25}, {a, 1}, {0, 1}};
  EXPECT_FALSE(visits(OverlappingPairs(slot, box_of(slot), Points::exact), 3, 5));
  EXPECT_TRUE(visits(OverlappingPairs(slot, box_of(slot), Points::rounded), 3, 5));

  // In lexicographic order, which rounding may have made.
  test::Ring zigzag;
  for (int k = 0; k < 9; ++k) {
    zigzag.push_back({k * 0x1p-40, k % 2 * 1.0});
  }
  zigzag.push_back({1, 0.5});
  EXPECT_FALSE(visits(OverlappingPairs(zigzag, box_of(zigzag), Points::exact), 2, 4));
  EXPECT_TRUE(visits(OverlappingPairs(zigzag, box_of(zigzag), Points::rounded), 2, 4));
}

// The pairs of edges of the ring, other than neighbours, whose boxes overlap are visited.
void expect_all_found(const test::Ring& ring, const Box& bounds) {
  const auto box = [&](std::size_t i) { return box_of(ring[i], ring[(i + 1) % ring.size()]); };
  std::set<Pair> found;
  OverlappingPairs(ring, bounds, OverlappingPairs::Points::rounded)
      .visit_all([&](std::size_t i, std::size_t j) {
        found.insert({i, j});
      });
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (std::size_t j = i + 2; j < ring.size(); ++j) {
      if (overlap(box(i), box(j)) && !(i == 0 && j + 1 == ring.size())) {
        ASSERT_TRUE(found.count({i, j}) != 0) << i << " " << j;
      }
    }
  }
}

TEST(OverlappingPairs, OfARingAreFoundWithBoundsThatAreOff) {
  Random random(19);
  for (int round = 0; round < 50; ++round) {
    test::Ring ring;
    for (int k = 0; k < 100; ++k) {
      ring.push_back({uniform(random, 0, 60) / 1.0, uniform(random, 0, 60) / 1.0});
    }
    const Box box = box_of(ring);
    expect_all_found(ring, box);
    expect_all_found(ring, {box.x0 + 20, box.y0 - 20, box.x1 + 40, box.y1 - 20});
    for (Point& p : ring) {
      p = {std::ldexp(p.x - 30, 1019), std::ldexp(p.y - 30, 1019)};
    }
    expect_all_found(ring, box_of(ring));  // infinite extents
  }
}

TEST(OverlappingPairs, AreFoundWhereTheExtentsOverflow) {
  std::vector<Box> boxes;
  for (int k = 0; k < 100; ++k) {
    const double x = (k < 50 ? -1.5 : 1.5) * 0x1p1023 + k * 0x1p1000;
    boxes.push_back({x, -x, x + 0x1p1001, 0x1p1001 - x});
  }
  std::set<Pair> found;
  OverlappingPairs(boxes).visit_all([&](std::size_t i, std::size_t j) {
    EXPECT_TRUE(found.insert({i, j}).second);
  });
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      if (overlap(boxes[i], boxes[j])) {
        ASSERT_TRUE(found.count({i, j}) != 0);
      }
    }
  }
}

TEST(OverlappingPairs, EndWhereToldToOrAfterSoManyPairs) {
  Random random(18);
  const OverlappingPairs pairs(random_boxes(random, 100, 1));
  int calls = 0;
  EXPECT_FALSE(pairs.visit_some(1000000, [&](std::size_t, std::size_t) { return ++calls < 5; }));
  EXPECT_EQ(calls, 5);
  calls = 0;
  EXPECT_FALSE(pairs.visit_some(9, [&](std::size_t, std::size_t) { return ++calls > 0; }));
  EXPECT_LT(calls, 10);
}

}  // namespace
}  // namespace gcv
