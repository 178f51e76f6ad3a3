// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Are starts of walks corners of the hull of the sum, by exact orientations? Far from the
// origin, where many vertices are as far as each other in rounded numbers, though not in fact.
#include "hull.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "generators.hpp"
#include "predicates.hpp"

namespace gcv {
namespace {

using test::Random;
using test::uniform;

// A star round (distance, distance), in quarters. Tips are about as far as each other.
PointVector star(Random& random, int tips, double distance) {
  PointVector ring;
  for (int k = 0; k < 2 * tips; ++k) {
    const double angle = std::numbers::pi * k / tips;
    const double radius = k % 2 == 0 ? 96 + uniform(random, -2, 2) / 4.0 : 80;
    ring.push_back({distance + std::round(4 * radius * std::cos(angle)) / 4,
                    distance + std::round(4 * radius * std::sin(angle)) / 4});
  }
  return ring;
}

struct Way {
  Point from;
  Point to;
};

// Is the sum of the vertices a corner of the convex hull of the sum, and the sum of no others? Then
// the ways from them to all other vertices of their polygons lie within less than half a turn.
bool is_corner(const gcv::Boundary& a, const gcv::Boundary& b, const VertexSum& vertex) {
  std::vector<Way> ways;
  const auto add = [&](const gcv::Boundary& polygon, Index corner) {
    for (const Point& p : polygon.vertices) {
      if (!(p == polygon.vertices[corner])) {
        ways.push_back({polygon.vertices[corner], p});
      }
    }
  };
  add(a, vertex.i);
  add(b, vertex.j);
  Tally tally;
  return std::any_of(ways.begin(), ways.end(), [&](const Way& first) {
    return std::all_of(ways.begin(), ways.end(), [&](const Way& way) {
      const int side = turn(first.from, first.to, way.from, way.to, tally);
      return side > 0 || (side == 0 && lexicographically_less(first.from, first.to) ==
                                           lexicographically_less(way.from, way.to));
    });
  });
}

TEST(Hull, WalksStartInCornersOfTheSum) {
  Random random(23);
  std::size_t starts = 0;
  for (int round = 0; round < 60; ++round) {
    const double distance = round % 2 == 0 ? 0 : 0x1p50;
    const gcv::Boundary a = make_ring(star(random, 24, distance), "a");
    const gcv::Boundary b = make_ring(star(random, 9, -distance), "b");
    const HullVertices vertices = hull_vertices(a, b, 8);
    starts += vertices.size();
    EXPECT_EQ(vertices.front().i, a.lexicographic_min);
    EXPECT_EQ(vertices.front().j, b.lexicographic_min);
    for (const VertexSum& vertex : vertices) {
      EXPECT_TRUE(is_corner(a, b, vertex))
          << "round " << round << ": " << vertex.i << ", " << vertex.j;
    }
    for (std::size_t k = 1; k < vertices.size(); ++k) {
      const auto follows = [](Index later, Index earlier) {
        return later >= earlier || later == 0;
      };
      EXPECT_TRUE(follows(vertices[k].i, vertices[k - 1].i)) << "round " << round;
      EXPECT_TRUE(follows(vertices[k].j, vertices[k - 1].j)) << "round " << round;
    }
  }
  EXPECT_GT(starts, 60U * 8U);
}

TEST(Hull, OneThreadStartsOnce) {
  Random random(29);
  const gcv::Boundary a = make_ring(star(random, 5, 0), "a");
  EXPECT_EQ(hull_vertices(a, a, 1).size(), 1U);
}

}  // namespace
}  // namespace gcv
