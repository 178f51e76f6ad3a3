// SPDX-License-Identifier: LGPL-3.0-or-later
#include "exact_indices.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "cycle.hpp"
#include "generators.hpp"

namespace gcv {
namespace {

using test::Random;

// Doubles are exact here: the vertices are small integers, and edges are level or upright.
double square_of_distance(const Point& p, const Point& a, const Point& b) {
  const double x = std::min(std::max(p.x, std::min(a.x, b.x)), std::max(a.x, b.x)) - p.x;
  const double y = std::min(std::max(p.y, std::min(a.y, b.y)), std::max(a.y, b.y)) - p.y;
  return x * x + y * y;
}

TEST(ExactIndices, AreThoseOfTheClosestEdges) {
  Random random(471);
  Task task;
  for (int k = 0; k < 200; ++k) {
    const PointVector ring = test::random_histogram(random, 2 + k % 8, 8);
    PointVector points = ring;
    for (int n = 0; n < 20; ++n) {
      const double x = test::uniform(random, -8, 40) / 2.0;
      points.push_back({x, test::uniform(random, -8, 24) / 2.0});
    }
    // Moved and scaled by what doubles hold exactly.
    const double move = std::ldexp(test::uniform(random, -1024, 1024), 40);
    const double scale = std::ldexp(1.0, test::uniform(random, -900, 900));
    PointVector scaled_ring = ring;
    PointVector scaled_points = points;
    for (PointVector* const all : {&scaled_ring, &scaled_points}) {
      for (Point& p : *all) {
        p = {(p.x + move) * scale, (p.y - move) * scale};
      }
    }
    const std::vector<std::size_t> found = closest_edges(scaled_ring, scaled_points, task);
    ASSERT_EQ(found.size(), points.size());
    for (std::size_t n = 0; n < points.size(); ++n) {
      const auto equal = std::find(ring.begin(), ring.end(), points[n]);
      if (equal != ring.end()) {
        ASSERT_EQ(found[n], static_cast<std::size_t>(equal - ring.begin()));
        continue;
      }
      const auto square_of = [&](std::size_t edge) {
        return square_of_distance(points[n], ring[edge], ring[cyclic_next(edge, ring.size())]);
      };
      for (std::size_t edge = 0; edge < ring.size(); ++edge) {
        ASSERT_LE(square_of(found[n]), square_of(edge));
      }
    }
  }
}

// All edges of a regular polygon are as close to its centre.
TEST(ExactIndices, AreTheFirstOfAllThatAreAsClose) {
  Task task;
  for (const double size : {1.0, 3.0, 0x1p900}) {
    const PointVector square{{-size, -size}, {size, -size}, {size, size}, {-size, size}};
    EXPECT_EQ(closest_edges(square, {{0, 0}}, task), (std::vector<std::size_t>{0}));
    EXPECT_EQ(closest_edges(square, {{size / 2, size / 2}}, task), (std::vector<std::size_t>{1}));
  }
}

// A star whose twelve inner corners are as close to its centre: 24 edges.
TEST(ExactIndices, AreTheFirstOfManyThatAreAsClose) {
  PointVector star;
  const auto turned = [](const Point& p, int quarters) {
    return quarters == 0   ? p
           : quarters == 1 ? Point{-p.y, p.x}
           : quarters == 2 ? Point{-p.x, -p.y}
                           : Point{p.y, -p.x};
  };
  for (const int quarters : {0, 1, 2, 3}) {
    for (const Point& p : {Point{5, 0}, {16, 5}, {4, 3}, {7, 7}, {3, 4}, {3, 9}}) {
      star.push_back(turned(p, quarters));
    }
  }
  Task task;
  for (std::size_t first = 0; first < star.size(); ++first) {
    EXPECT_EQ(closest_edges(star, {{0, 0}}, task), (std::vector<std::size_t>{0}));
    std::rotate(star.begin(), star.begin() + 1, star.end());
  }
}

TEST(ExactIndices, OfThinRings) {
  Task task;
  for (const double x : {-11.0, -1.0, 0.0, 10.0}) {
    const PointVector ring{{x, 0}, {x + 1, 0}, {x + 2, 0}, {x + 2, 1e-200}, {x, 1e-200}};
    PointVector upright;
    for (const Point& p : ring) {
      upright.push_back({-p.y, p.x});
    }
    EXPECT_EQ(closest_edges(ring, {{x + 2.5, 5e-201}}, task), (std::vector<std::size_t>{1}));
    EXPECT_EQ(closest_edges(upright, {{-5e-201, x + 2.5}}, task), (std::vector<std::size_t>{1}));
  }
}

TEST(ExactIndices, AskTheCallerOnTheWay) {
  int calls = 0;
  const auto count = [](void* context, std::uint64_t, std::uint64_t) {
    ++*static_cast<int*>(context);
    return std::int32_t{0};
  };
  Task task(1, count, &calls);
  const PointVector triangle{{0, 0}, {1, 0}, {0, 1}};
  EXPECT_EQ(closest_edges(triangle, PointVector(4 * Task::portion), task),
            std::vector<std::size_t>(4 * Task::portion));
  EXPECT_EQ(calls, 4);
}

}  // namespace
}  // namespace gcv
