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

double distance(const Point& p, const Point& a, const Point& b) {
  const double x = std::clamp(p.x, std::min(a.x, b.x), std::max(a.x, b.x)) - p.x;
  const double y = std::clamp(p.y, std::min(a.y, b.y), std::max(a.y, b.y)) - p.y;
  return std::hypot(x, y);
}

// How far the edge from p to q is from that from a to b, which is level or upright.
double distance(const Point& p, const Point& q, const Point& a, const Point& b) {
  const bool is_against = (q.x - p.x) * (b.x - a.x) + (q.y - p.y) * (b.y - a.y) < 0;
  return std::max(distance(p, a, b), distance(q, a, b)) +
         (is_against ? std::hypot(q.x - p.x, q.y - p.y) : 0);
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
      const auto distance_of = [&](std::size_t edge) {
        return distance(points[n], points[cyclic_next(n, points.size())], ring[edge],
                        ring[cyclic_next(edge, ring.size())]);
      };
      for (std::size_t edge = 0; edge < ring.size(); ++edge) {
        ASSERT_LE(distance_of(found[n]), distance_of(edge) * (1 + 1e-12));
      }
    }
  }
}

// Moved outward, a corner is as close to the edge that ends there as to the one that begins there.
// The edge from the returned vertex lies along the latter.
TEST(ExactIndices, LeadAlongTheEdges) {
  Task task;
  const PointVector square{{0, 0}, {9, 0}, {9, 9}, {0, 9}};
  const PointVector around{{-1, -1}, {10, -1}, {10, 10}, {-1, 10}};
  EXPECT_EQ(closest_edges(square, around, task), (std::vector<std::size_t>{0, 1, 2, 3}));
  // Both walls of the slit are as close to each other.
  const PointVector slit{{0, 0}, {9, 0}, {9, 9}, {4, 9}, {4, 1}, {3.5, 9}, {0, 9}};
  const PointVector near{{-1, -1}, {10, -1}, {10, 10}, {4.25, 10}, {4, 1}, {3.25, 10}, {-1, 10}};
  EXPECT_EQ(closest_edges(slit, near, task), (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6}));
}

TEST(ExactIndices, OfDistinctPlacesAreTheFirst) {
  const PointVector places{{1, 1}, {2, 0}, {2, 0}, {3, 3}, {0, 2}, {1, 1}};
  const DistinctPlaces as_they_are = distinct_places(places, 7, false);
  EXPECT_EQ(as_they_are.places, (PointVector{{1, 1}, {2, 0}, {3, 3}, {0, 2}}));
  EXPECT_EQ(as_they_are.indices, (std::vector<std::uint64_t>{7, 8, 10, 11}));
  const DistinctPlaces from_smallest = distinct_places(places, 7, true);
  EXPECT_EQ(from_smallest.places, (PointVector{{0, 2}, {1, 1}, {2, 0}, {3, 3}}));
  EXPECT_EQ(from_smallest.indices, (std::vector<std::uint64_t>{11, 7, 8, 10}));
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
