// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "edge_sources.hpp"
#include "generators.hpp"
#include "minkowski_sum.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Ring;

OuterFace sum_of(const Ring& a, const Ring& b) {
  Task task;
  return minkowski_sum({std::make_shared<gcv::Boundary>(make_ring(a, "a")), "a"},
                       {std::make_shared<gcv::Boundary>(make_ring(b, "b")), "b"}, {0, 0},
                       Rounding::nearest, task);
}

Ring scaled(Ring ring, double factor) {
  for (Point& p : ring) {
    p = {p.x * factor, p.y * factor};
  }
  return ring;
}

Ring translated(Ring ring, double dx, double dy) {
  for (Point& p : ring) {
    p = {p.x + dx, p.y + dy};
  }
  return ring;
}

const Ring square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(OuterFace, OfConvexPolygonsMergesTheirEdges) {
  EXPECT_EQ(sum_of(square, scaled(square, 2)).rounded.vertices, scaled(square, 3));
  const Ring triangle{{0, 0}, {2, 0}, {0, 2}};
  EXPECT_EQ(sum_of(triangle, test::negated(triangle)).rounded.vertices,
            (Ring{{-2, 0}, {0, -2}, {2, -2}, {2, 0}, {0, 2}, {-2, 2}}));
}

TEST(OuterFace, ClosesTheSlitOfAnExactFit) {
  // A slot one wide, and the square that just goes in: free along a line, which is no face.
  const Ring slot{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  EXPECT_EQ(sum_of(slot, test::negated(square)).rounded.vertices,
            (Ring{{-1, -1}, {3, -1}, {3, 3}, {-1, 3}}));
  // A little wider, and the way in is free.
  Ring wider = slot;
  wider[4].x = 2 + 0x1p-40;
  wider[3].x = 2 + 0x1p-40;
  EXPECT_EQ(sum_of(wider, test::negated(square)).rounded.vertices.size(), 8U);
}

TEST(OuterFace, LeavesAPocketBehindAnExactFitAlone) {
  // Behind a slit of width 0 lies a chamber in which the square is free: a hole of the
  // sum, not a part of the outer face.
  const Ring chamber{{0, 0}, {5, 0}, {5, 6}, {3, 6}, {3, 4}, {4, 4},
                     {4, 1}, {1, 1}, {1, 4}, {2, 4}, {2, 6}, {0, 6}};
  EXPECT_EQ(sum_of(chamber, test::negated(square)).rounded.vertices,
            (Ring{{-1, -1}, {5, -1}, {5, 6}, {-1, 6}}));
}

TEST(OuterFace, IsCommutative) {
  Random random(41);
  for (int k = 0; k < 500; ++k) {
    const Ring a = test::random_small_integer_polygon(random, 9, 7);
    const Ring b = test::random_histogram(random, 4, 4);
    EXPECT_EQ(sum_of(a, b).rounded.vertices, sum_of(b, a).rounded.vertices);
  }
}

TEST(OuterFace, IsTranslatedAndScaledWithItsOperands) {
  Random random(42);
  for (int k = 0; k < 300; ++k) {
    const Ring a = test::random_small_integer_polygon(random, 9, 7);
    const Ring b = test::random_small_integer_polygon(random, 7, 7);
    const Ring sum = sum_of(a, b).rounded.vertices;
    // Scaling by a power of two commutes with rounding, to the last bit.
    for (const double factor : {0x1p-900, 0x1p900}) {
      ASSERT_EQ(sum_of(scaled(a, factor), scaled(b, factor)).rounded.vertices, scaled(sum, factor));
    }
    const OuterFace there = sum_of(translated(a, 0x1p40, 64), translated(b, -0x1p40, -64));
    ASSERT_EQ(there.rounded.vertices, sum);
  }
}

// Does the segment from p to q lie on the edge? Small integers and their few fractions:
// the midpoint is compared in doubles with room to spare.
bool holds(const SupersetEdge& e, const Point& p, const Point& q) {
  const Point from{e.from.a.x + e.from.b.x, e.from.a.y + e.from.b.y};
  const Point to{e.to.a.x + e.to.b.x, e.to.a.y + e.to.b.y};
  const auto distance = [&](const Point& r) {
    return std::abs((to.x - from.x) * (r.y - from.y) - (to.y - from.y) * (r.x - from.x));
  };
  return distance(p) < 1e-9 && distance(q) < 1e-9;
}

// Where numbers round, a piece of an edge may be no longer than nothing.
TEST(OuterFace, EndsWhereTheOtherPolygonIsSomeUlpsLarge) {
  const auto turned = [](const Ring& ring, double angle) {
    Ring result;
    for (const Point& p : ring) {
      result.push_back({std::cos(angle) * p.x - std::sin(angle) * p.y,
                        std::sin(angle) * p.x + std::cos(angle) * p.y});
    }
    return result;
  };
  constexpr int spikes = 132;
  Ring star;
  for (int k = 0; k < 2 * spikes; ++k) {
    const double radius = k % 2 == 1 ? 1 : 0.3;
    const double angle = 3.141592653589793 * k / spikes + 5.321488440947398;
    star.push_back({8.514290299713841e-15 * radius * std::cos(angle),
                    8.514290299713841e-15 * radius * std::sin(angle)});
  }
  EXPECT_GT(sum_of(turned(square, 0.5688855900799814), star).rounded.vertices.size(), 200U);
}

TEST(OuterFace, SourcesAreTrue) {
  Random random(43);
  for (int k = 0; k < 500; ++k) {
    const Ring a = test::random_small_integer_polygon(random, 9, 7);
    const Ring b = test::random_histogram(random, 4, 4);
    const OuterFace face = sum_of(a, b);
    const Ring& ring = face.rounded.vertices;
    const std::vector<EdgeSource> sources = edge_sources(face.exact);
    ASSERT_EQ(sources.size(), ring.size());
    const std::vector<SupersetEdge> edges = superset(make_ring(a, "a"), make_ring(b, "b"));
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const EdgeSource& source = sources[i];
      const auto edge = std::find_if(edges.begin(), edges.end(), [&](const SupersetEdge& e) {
        return e.source.kind == source.kind && e.source.a == source.a && e.source.b == source.b;
      });
      ASSERT_NE(edge, edges.end());
      ASSERT_TRUE(holds(*edge, ring[i], ring[(i + 1) % ring.size()]));
    }
  }
}

// A closed coast line: midpoint displacement with integers only.
Ring coast(Random& random, std::size_t vertices) {
  Ring ring{{1 << 30, 0}, {0, 1 << 30}, {-(1 << 30), 0}, {0, -(1 << 30)}};
  while (ring.size() < vertices) {
    Ring finer;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point& p = ring[k];
      const Point& q = ring[(k + 1) % ring.size()];
      const double shift = test::uniform(random, -150, 150) / 1000.0;
      finer.push_back(p);
      finer.push_back({std::floor((p.x + q.x) / 2 - (q.y - p.y) * shift),
                       std::floor((p.y + q.y) / 2 + (q.x - p.x) * shift)});
    }
    ring = finer;
  }
  return ring;
}

TEST(OuterFace, LooksAtFewEdgesOfThoseOfTenThousandVertices) {
  Random random(44);
  const Ring a = coast(random, 10000);
  const Ring b = coast(random, 10000);
  const OuterFace face = sum_of(a, b);
  std::printf("%zu x %zu vertices, %zu of the sum: %llu steps, %llu candidate edges\n", a.size(),
              b.size(), face.exact.size(), static_cast<unsigned long long>(face.counts.walk_steps),
              static_cast<unsigned long long>(face.counts.candidate_edges));
  EXPECT_GT(face.exact.size(), 10000U);
  EXPECT_LT(face.counts.walk_steps, 2 * face.exact.size());
  EXPECT_LT(face.counts.candidate_edges, 4 * face.counts.walk_steps);
}

}  // namespace
}  // namespace gcv
