// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Directions as numbers, of one ring and of two polygons, against their order in fractions.
#include "directions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "exact_rings.hpp"
#include "generators.hpp"
#include "line_directions.hpp"
#include "numbers.hpp"

namespace gcv {
namespace {

using invariants::Exact;
using test::exact;
using test::polygon_of;
using test::Random;
using test::scaled;
using test::uniform;

using Edges = std::vector<Exact>;

Edges edges_of(const PointVector& ring) {
  const invariants::Ring vertices = exact(ring);
  Edges edges;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    edges.push_back(invariants::next(vertices, i) - vertices[i]);
  }
  return edges;
}

// Is the angle in [0, pi)?
bool points_up(const Exact& edge) { return edge.y > 0 || (edge.y == 0 && edge.x > 0); }

Exact line_of(const Exact& edge) { return points_up(edge) ? edge : Exact{-edge.x, -edge.y}; }

// The line directions that occur, in order, one edge of each.
Edges lines_of(Edges edges) {
  std::transform(edges.begin(), edges.end(), edges.begin(), line_of);
  std::sort(edges.begin(), edges.end(),
            [](const Exact& e, const Exact& f) { return invariants::cross(e, f) > 0; });
  const auto end = std::unique(edges.begin(), edges.end(), [](const Exact& e, const Exact& f) {
    return invariants::cross(e, f) == 0;
  });
  edges.erase(end, edges.end());
  return edges;
}

std::size_t number_of(const Exact& edge, const Edges& lines) {
  const Exact line = line_of(edge);
  const auto place = std::find_if(lines.begin(), lines.end(), [&](const Exact& other) {
    return invariants::cross(line, other) == 0;
  });
  return static_cast<std::size_t>(place - lines.begin());
}

void expect_lines(const PointVector& ring, bool is_convex) {
  const Edges edges = edges_of(ring);
  const Edges lines = lines_of(edges);
  const LineDirections directions =
      sort_line_directions(ring, RingLayout(static_cast<Index>(ring.size())), is_convex);
  ASSERT_EQ(directions.lines.size(), lines.size());
  ASSERT_EQ(directions.edges.size(), edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    ASSERT_EQ(directions.edges[i].points_up, points_up(edges[i])) << i;
    ASSERT_EQ(directions.edges[i].line, number_of(edges[i], lines)) << i;
  }
  for (std::size_t k = 0; k < lines.size(); ++k) {
    ASSERT_EQ(directions.edges[directions.lines[k].edge].line, k);
  }
}

void expect_ranks(const PointVector& ring_a, const PointVector& ring_b) {
  const auto a = polygon_of(ring_a);
  const auto b = polygon_of(ring_b);
  const Edges edges_a = edges_of(a->vertices);
  const Edges edges_b = edges_of(b->vertices);
  Edges all = edges_a;
  all.insert(all.end(), edges_b.begin(), edges_b.end());
  const Edges lines = lines_of(all);
  Tally tally;
  const Directions directions = merge_directions(*a, *b, tally);
  ASSERT_EQ(directions.half_turn, lines.size());
  const auto expect = [&](const Ranks& ranks, const Edges& edges) {
    ASSERT_EQ(ranks.size(), edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
      ASSERT_EQ(ranks[i], number_of(edges[i], lines) + (points_up(edges[i]) ? 0 : lines.size()));
    }
  };
  expect(directions.rank_a, edges_a);
  expect(directions.rank_b, edges_b);
  // Turns and opposites, as angles tell them.
  for (std::size_t i = 0; i < edges_a.size(); ++i) {
    for (std::size_t j = 0; j < edges_b.size(); ++j) {
      const Rank angle = directions.angle(directions.rank_a[i], directions.rank_b[j]);
      const int turn = invariants::sign(invariants::cross(edges_a[i], edges_b[j]));
      const int ahead = invariants::sign(invariants::dot(edges_a[i], edges_b[j]));
      ASSERT_LT(angle, 2 * directions.half_turn);
      ASSERT_EQ(angle == 0, turn == 0 && ahead > 0);
      ASSERT_EQ(angle == directions.half_turn, turn == 0 && ahead < 0);
      ASSERT_EQ(angle > 0 && angle<directions.half_turn, turn> 0);
    }
  }
}

// Coordinates moved by one unit in the last place at most: of parallel edges, some stay parallel.
PointVector nudged(Random& random, PointVector ring) {
  for (Point& p : ring) {
    for (double* const x : {&p.x, &p.y}) {
      const int step = uniform(random, -2, 2);
      *x = step == 1    ? std::nextafter(*x, HUGE_VAL)
           : step == -1 ? std::nextafter(*x, -HUGE_VAL)
                        : *x;
    }
  }
  return ring;
}

// Points of a parabola round x = `middle`: convex, each edge by about 2 / middle^2 steeper than
// the one before it, in parts of a turn.
PointVector parabola(double middle, int count) {
  PointVector ring;
  for (int k = 0; k < count; ++k) {
    const double x = middle + k;
    ring.push_back({x, x * x});
  }
  return ring;
}

TEST(LineDirections, AreInOrderForAnyRing) {
  Random random(1);
  for (int k = 0; k < 400; ++k) {
    PointVector ring;
    while (ring.size() < 16) {
      const Point p{static_cast<double>(uniform(random, -4, 4)),
                    static_cast<double>(uniform(random, -4, 4))};
      if (ring.empty() || !(p == ring.back() || p == ring.front())) {
        ring.push_back(p);
      }
    }
    expect_lines(ring, false);
    expect_lines(nudged(random, ring), false);
  }
}

TEST(LineDirections, AreInOrderForAllMagnitudes) {
  Random random(2);
  for (int k = 0; k < 400; ++k) {
    test::Attack attack(random);
    PointVector ring;
    for (int tries = 0; tries < 12; ++tries) {
      const Point p = attack.point();
      if (ring.empty() || !(p == ring.back() || p == ring.front())) {
        ring.push_back(p);
      }
    }
    if (ring.size() > 1) {
      expect_lines(ring, false);
    }
  }
}

TEST(LineDirections, OfConvexRingsAreMerged) {
  Random random(3);
  for (const double middle : {-20.0, 1e3, 0x1p20, 0x1p25}) {
    const PointVector ring = parabola(middle, 40);
    expect_lines(ring, true);
    expect_lines(test::negated(ring), true);
    PointVector turned = ring;
    std::rotate(turned.begin(), turned.begin() + 17, turned.end());
    expect_lines(turned, true);
    expect_lines(ring, false);
  }
  expect_lines({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true);
  expect_lines({{0, 1}, {0, 0}, {1, 0}, {1, 1}}, true);
  expect_lines({{0, 0}, {2, 0}, {3, 1}, {2, 2}, {0, 2}, {-1, 1}}, true);
}

TEST(LineDirections, DoNotTellZeros) {
  const PointVector zeros{{0, 0}, {1, -0.0}, {-0.0, 1}};
  const PointVector others{{-0.0, -0.0}, {1, 0}, {0, 1}};
  expect_lines(zeros, false);
  expect_lines(others, false);
  expect_lines(others, true);
  expect_ranks(zeros, others);
}

TEST(Directions, AreInOrderForPolygons) {
  Random random(4);
  for (int k = 0; k < 150; ++k) {
    const PointVector a = test::random_small_integer_polygon(random, uniform(random, 3, 12), 5);
    const PointVector b = k % 2 == 0 ? test::random_small_integer_polygon(random, 8, 5)
                                     : test::random_spiky_star(random, 12);
    expect_ranks(a, b);
  }
}

// Opposite edges are half a turn apart, equal directions of other lengths have equal ranks, and
// what differs by a unit in the last place does not.
TEST(Directions, TellNearlyParallelEdges) {
  Random random(5);
  for (int k = 0; k < 60; ++k) {
    const PointVector a = k % 2 == 0 ? test::random_small_integer_polygon(random, 9, 6)
                                     : test::random_spiky_star(random, 12);
    expect_ranks(a, a);
    expect_ranks(a, test::negated(a));
    expect_ranks(a, scaled(a, 3 * (k - 30)));
    expect_ranks(a, nudged(random, a));
    expect_ranks(nudged(random, a), test::negated(nudged(random, a)));
  }
}

TEST(Directions, TellNearlyParallelEdgesOfConvexPolygons) {
  for (const double middle : {1e3, 0x1p20, 0x1p25}) {
    const PointVector ring = parabola(middle, 24);
    PointVector every_other;
    for (std::size_t k = 0; k < ring.size(); k += 2) {
      every_other.push_back(ring[k]);
    }
    expect_ranks(ring, test::negated(ring));
    expect_ranks(ring, every_other);
    expect_ranks(parabola(middle + 1, 24), ring);
  }
}

TEST(Directions, AreInOrderForAllMagnitudes) {
  Random random(6);
  for (const int x : {-1070, -500, 0, 500, 1015}) {
    for (const int y : {-1070, 0, 1015}) {
      const PointVector a = test::random_spiky_star(random, 10);
      expect_ranks(scaled(a, x, y), scaled(test::negated(a), y, x));
      expect_ranks(scaled(a, x, y), scaled(test::random_spiky_star(random, 10), x, y));
      expect_ranks(scaled(a, x), scaled(a, y));
    }
  }
}

}  // namespace
}  // namespace gcv
