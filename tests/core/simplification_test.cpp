// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What simplification promises, in fractions: of noise, spirals, combs and thin things, at all
// magnitudes; and which numbers the new vertices and edges have.
#include "simplification.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "exact_rings.hpp"
#include "generators.hpp"

namespace gcv {
namespace {

using test::exact;
using test::polygon_of;
using test::Random;
using test::scaled;
using test::uniform;

using PolygonPointer = decltype(polygon_of({}));

Simplified simplified(const PolygonPointer& polygon, double tolerance, Rounding rounding) {
  return simplify(polygon, tolerance, rounding, polygon->size() - 1);
}

bool is_subsequence(const PointVector& part, const PointVector& all) {
  auto place = all.begin();
  return std::all_of(part.begin(), part.end(), [&](const Point& p) {
    place = std::find(place, all.end(), p);
    return place != all.end();
  });
}

// How many vertices are left.
std::size_t expect_promises(const PolygonPointer& polygon, double tolerance, Rounding rounding) {
  const Simplified result = simplified(polygon, tolerance, rounding);
  const PointVector& vertices = result.ring->vertices;
  const invariants::Ring before = exact(polygon->vertices);
  const invariants::Ring after = exact(vertices);
  EXPECT_LE(vertices.size(), polygon->vertices.size());
  EXPECT_LE(result.error_bound, tolerance);
  EXPECT_EQ(result.error_bound == 0, vertices == polygon->vertices);
  EXPECT_TRUE(test::is_simple_and_counter_clockwise(after));
  EXPECT_TRUE(test::are_within(after, before, result.error_bound));
  if (rounding == Rounding::nearest) {
    EXPECT_TRUE(is_subsequence(vertices, polygon->vertices));
  } else {
    EXPECT_TRUE(test::contains(after, before));
  }
  return vertices.size();
}

struct Left {
  std::size_t nearest;
  std::size_t outward;
};

Left expect_promises(const PointVector& ring, double tolerance) {
  SCOPED_TRACE(testing::Message() << ring.size() << " vertices, tolerance " << tolerance);
  const auto polygon = polygon_of(ring);
  return {expect_promises(polygon, tolerance, Rounding::nearest),
          expect_promises(polygon, tolerance, Rounding::outward)};
}

// A circle of radius 100 with as much noise.
PointVector noisy_circle(Random& random, int vertices, double noise) {
  PointVector ring;
  for (int k = 0; k < vertices; ++k) {
    const double angle = 2 * std::numbers::pi * k / vertices;
    const double radius = 100 + noise * uniform(random, -100, 100) / 100;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return ring;
}

// A band of half the width between its turns, which are 1 apart.
PointVector spiral(int vertices_per_turn, int turns) {
  PointVector outer;
  PointVector inner;
  for (int k = 0; k <= turns * vertices_per_turn; ++k) {
    const double part = static_cast<double>(k) / vertices_per_turn;
    const double angle = 2 * std::numbers::pi * part;
    outer.push_back({(part + 1.5) * std::cos(angle), (part + 1.5) * std::sin(angle)});
    inner.push_back({(part + 1) * std::cos(angle), (part + 1) * std::sin(angle)});
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

// A band about as thin as given along a parabola.
PointVector thin_band(Random& random, int vertices, double width) {
  PointVector lower;
  PointVector upper;
  for (int k = 0; k < vertices; ++k) {
    const double y = k * (vertices - k) / 10.0 + width * uniform(random, 0, 30) / 100;
    lower.push_back({static_cast<double>(k), y});
    upper.push_back({static_cast<double>(k), y + width});
  }
  lower.insert(lower.end(), upper.rbegin(), upper.rend());
  return lower;
}

TEST(Simplification, LeavesAllWithoutATolerance) {
  Random random(1);
  const auto polygon = polygon_of(noisy_circle(random, 50, 1e-9));
  for (const Rounding rounding : {Rounding::nearest, Rounding::outward}) {
    for (const double tolerance : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
      const Simplified result = simplified(polygon, tolerance, rounding);
      EXPECT_EQ(result.ring, polygon);
      EXPECT_EQ(result.error_bound, 0);
    }
    // A tolerance, but more vertices are left than are asked for.
    const std::size_t left = simplified(polygon, 1, rounding).ring->vertices.size();
    ASSERT_LT(left, 50U);
    EXPECT_EQ(simplify(polygon, 1, rounding, left).ring->vertices.size(), left);
    EXPECT_EQ(simplify(polygon, 1, rounding, left - 1).ring, polygon);
    EXPECT_EQ(simplify(polygon, 1, rounding, left - 1).error_bound, 0);
  }
}

TEST(Simplification, KeepsItsPromisesOfNoise) {
  Random random(2);
  for (const double noise : {1e-6, 0.01, 1.0}) {
    const PointVector ring = noisy_circle(random, 200, noise);
    for (const double tolerance : {noise / 10, 3 * noise, 5.0, 60.0}) {
      expect_promises(ring, tolerance);
    }
  }
  // It is worth it.
  const Left left = expect_promises(noisy_circle(random, 300, 0.01), 0.5);
  EXPECT_LT(left.nearest, 60U);
  EXPECT_LT(left.outward, 60U);
}

TEST(Simplification, KeepsItsPromisesOfStars) {
  Random random(3);
  for (int k = 0; k < 25; ++k) {
    const PointVector ring = k % 2 == 0 ? test::random_spiky_star(random, 30)
                                        : test::random_small_integer_polygon(random, 14, 30);
    for (const double tolerance : {0.1, 2.0, 9.0, 1e9}) {
      expect_promises(ring, tolerance);
    }
  }
}

TEST(Simplification, KeepsItsPromisesOfSpiralsCombsAndThinThings) {
  Random random(4);
  for (const double tolerance : {1e-3, 0.03, 0.2, 0.6, 3.0}) {
    expect_promises(spiral(30, 3), tolerance);
    expect_promises(test::block_with_slits(10, 1, 0), tolerance);
    expect_promises(test::block_with_slits(10, 1e-3, 0.5), tolerance);
    expect_promises(thin_band(random, 60, 1e-3), tolerance);
    expect_promises(thin_band(random, 60, 1e-12), tolerance);
    expect_promises(test::random_histogram(random, 20, 9), tolerance);
  }
}

TEST(Simplification, KeepsItsPromisesAtAllMagnitudes) {
  Random random(5);
  for (const int exponent : {-1070, -1020, -500, 500, 1016}) {
    for (const double noise : {0.1, 3.0}) {
      const PointVector ring = scaled(noisy_circle(random, 60, noise), exponent);
      expect_promises(ring, std::ldexp(noise, exponent));
      expect_promises(ring, std::ldexp(10, exponent));
    }
    const PointVector flat = scaled(noisy_circle(random, 60, 3), 0, std::min(exponent, 500));
    expect_promises(flat, 1);
  }
  const PointVector ring = scaled(noisy_circle(random, 60, 3), 1016);
  expect_promises(ring, std::numeric_limits<double>::max());
  PointVector far = noisy_circle(random, 100, 0.1);
  for (Point& p : far) {
    p = {p.x + 1e9, p.y - 1e12};
  }
  expect_promises(far, 1);
}

// The numbers of the given ring that the vertices and the edges have.
void expect_numbers(const Simplified& result, const std::vector<std::uint32_t>& vertex_numbers,
                    const std::vector<std::uint32_t>& edge_numbers) {
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> edges;
  for (const auto& corner : result.ring->corners) {
    vertices.push_back(corner.vertex_number);
    edges.push_back(corner.edge_number);
  }
  EXPECT_EQ(vertices, vertex_numbers);
  EXPECT_EQ(edges, edge_numbers);
}

// A trapezoid without one corner, and with a dent.
TEST(Simplification, NumbersWhatStandsForSeveralAsTheFirst) {
  const PointVector ring{{0, 0}, {14, 0},    {10.5, 3.5}, {9.5, 4},
                         {5, 4}, {4.5, 3.9}, {4, 4},      {0, 4}};
  const Simplified outward = simplified(polygon_of(ring), 1, Rounding::outward);
  EXPECT_EQ(outward.ring->vertices, (PointVector{{0, 0}, {14, 0}, {10, 4}, {0, 4}}));
  expect_numbers(outward, {0, 1, 2, 7}, {0, 1, 3, 7});
  EXPECT_GE(outward.error_bound, 0.5 / std::sqrt(5.0));
  EXPECT_LE(outward.error_bound, 0.5);
  const Simplified nearest = simplified(polygon_of(ring), 0.2, Rounding::nearest);
  EXPECT_EQ(nearest.ring->vertices, (PointVector{{0, 0}, {14, 0}, {10.5, 3.5}, {9.5, 4}, {0, 4}}));
  expect_numbers(nearest, {0, 1, 2, 3, 7}, {0, 1, 2, 3, 7});
  EXPECT_GE(nearest.error_bound, 0.1 - 1e-9);
  EXPECT_LE(nearest.error_bound, 0.1 + 1e-9);
}

// The caller's numbers: from another vertex, and either way round.
TEST(Simplification, KeepsTheNumbersOfTheCaller) {
  Random random(6);
  for (int k = 0; k < 20; ++k) {
    PointVector ring = noisy_circle(random, 60, 1);
    std::rotate(ring.begin(), ring.begin() + 3 * k, ring.end());
    const bool is_clockwise = k % 2 == 1;
    if (is_clockwise) {
      std::reverse(ring.begin(), ring.end());
    }
    const auto polygon = polygon_of(ring);
    const auto n = static_cast<std::uint32_t>(ring.size());
    const auto behind = [&](std::uint32_t vertex) {
      return is_clockwise ? (vertex + n - 1) % n : vertex;
    };
    const Simplified nearest = simplified(polygon, 2, Rounding::nearest);
    ASSERT_LT(nearest.ring->vertices.size(), ring.size());
    for (std::size_t i = 0; i < nearest.ring->vertices.size(); ++i) {
      const auto& corner = nearest.ring->corners[i];
      EXPECT_EQ(ring[corner.vertex_number], nearest.ring->vertices[i]);
      EXPECT_EQ(corner.edge_number, behind(corner.vertex_number));
    }
    // A vertex that is not new has its own number, and each edge a number from its chain: in
    // order, each once.
    const Simplified outward = simplified(polygon, 2, Rounding::outward);
    ASSERT_LT(outward.ring->vertices.size(), ring.size());
    std::uint32_t way = 0;
    for (std::size_t i = 0; i < outward.ring->vertices.size(); ++i) {
      const auto& corner = outward.ring->corners[i];
      const Point& p = outward.ring->vertices[i];
      const auto given = std::find(ring.begin(), ring.end(), p);
      if (given != ring.end()) {
        EXPECT_EQ(ring[corner.vertex_number], p);
      }
      const auto distance = [&](std::uint32_t from, std::uint32_t to) {
        return is_clockwise ? (from + n - to) % n : (to + n - from) % n;
      };
      const auto& following = invariants::next(outward.ring->corners, i);
      EXPECT_LT(distance(behind(corner.vertex_number), corner.edge_number),
                distance(corner.vertex_number, following.vertex_number));
      way += distance(corner.vertex_number, following.vertex_number);
    }
    EXPECT_EQ(way, n);
  }
}

TEST(Simplification, IsDeterministic) {
  Random random(7);
  const PointVector ring = noisy_circle(random, 200, 1);
  for (const Rounding rounding : {Rounding::nearest, Rounding::outward}) {
    const Simplified first = simplified(polygon_of(ring), 1, rounding);
    const Simplified again = simplified(polygon_of(ring), 1, rounding);
    EXPECT_EQ(first.ring->vertices, again.ring->vertices);
    EXPECT_EQ(first.error_bound, again.error_bound);
    // In units of another power of two, all is the same.
    for (const int exponent : {-900, 900}) {
      const auto polygon = polygon_of(scaled(ring, exponent));
      const Simplified other = simplified(polygon, std::ldexp(1, exponent), rounding);
      EXPECT_EQ(other.ring->vertices, scaled(first.ring->vertices, exponent));
      EXPECT_EQ(other.error_bound, std::ldexp(first.error_bound, exponent));
    }
  }
}

}  // namespace
}  // namespace gcv
