// SPDX-License-Identifier: LGPL-3.0-or-later
#include "superset.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <ostream>
#include <set>
#include <tuple>

#include "generators.hpp"
#include "minkowski_sum.hpp"
#include "polygon.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Ring;

// Definition 1, word for word, in the doubles of small integers, where it is exact.
bool contributes_by_definition(const gcv::Boundary& edges, Index e, const gcv::Boundary& vertices,
                               Index k) {
  const auto edge = [](const gcv::Boundary& p, Index i) {
    const Point& from = p.vertices[i];
    const Point& to = p.vertices[p.next(i)];
    return Point{to.x - from.x, to.y - from.y};
  };
  const auto outer_normal = [](const Point& d) { return Point{d.y, -d.x}; };
  const auto dot = [](const Point& p, const Point& q) { return p.x * q.x + p.y * q.y; };
  const Point n = outer_normal(edge(edges, e));
  const Point n_before = outer_normal(edge(vertices, vertices.previous(k)));
  const Point& v = vertices.vertices[k];
  return dot(v, n) >= dot(vertices.vertices[vertices.previous(k)], n) &&
         dot(v, n) >= dot(vertices.vertices[vertices.next(k)], n) &&
         dot(edge(vertices, k), n_before) <= 0;
}

TEST(ContributingVertices, AreThoseOfTheDefinition) {
  Random random(21);
  for (int k = 0; k < 2000; ++k) {
    const int extent = test::uniform(random, 2, 9);
    const gcv::Boundary a = make_ring(
        test::random_small_integer_polygon(random, test::uniform(random, 3, 8), extent), "a");
    const gcv::Boundary b = make_ring(
        test::random_small_integer_polygon(random, test::uniform(random, 3, 8), extent), "b");
    Tally tally;
    const Operands operands{a, b, merge_directions(a, b, tally)};
    for (Index i = 0; i < a.size(); ++i) {
      for (Index j = 0; j < b.size(); ++j) {
        ASSERT_EQ(operands.b_contributes(j, operands.directions.rank_a[i]),
                  contributes_by_definition(a, i, b, j));
        ASSERT_EQ(operands.a_contributes(i, operands.directions.rank_b[j]),
                  contributes_by_definition(b, j, a, i));
      }
    }
  }
}

using Segment = std::tuple<double, double, double, double>;

Segment segment(const Point& p, const Point& q) { return {p.x, p.y, q.x, q.y}; }
Point sum(const Point& p, const Point& q) { return {p.x + q.x, p.y + q.y}; }
Point sum(const SumPoint& p) { return sum(p.a, p.b); }

// Superset edges by kind, i and j.
using NamedSegments = std::map<std::tuple<int, Index, Index>, Segment>;

// The superset by brute force: every contribution, then the three cases on every pair of
// edges of equal direction.
NamedSegments superset_by_definition(const gcv::Boundary& a, const gcv::Boundary& b) {
  NamedSegments edges;
  for (Index i = 0; i < a.size(); ++i) {
    for (Index j = 0; j < b.size(); ++j) {
      const Point& v = a.vertices[i];
      const Point& w = b.vertices[j];
      if (contributes_by_definition(a, i, b, j)) {
        edges[{1, i, j}] = segment(sum(v, w), sum(a.vertices[a.next(i)], w));
      }
      if (contributes_by_definition(b, j, a, i)) {
        edges[{2, i, j}] = segment(sum(v, w), sum(v, b.vertices[b.next(j)]));
      }
    }
  }
  const auto has = [&](int kind, Index i, Index j) { return edges.contains({kind, i, j}); };
  for (Index i = 0; i < a.size(); ++i) {
    for (Index j = 0; j < b.size(); ++j) {
      const Index i1 = a.next(i);
      const Index j1 = b.next(j);
      const Point d{a.vertices[i1].x - a.vertices[i].x, a.vertices[i1].y - a.vertices[i].y};
      const Point e{b.vertices[j1].x - b.vertices[j].x, b.vertices[j1].y - b.vertices[j].y};
      if (d.x * e.y - d.y * e.x != 0 || d.x * e.x + d.y * e.y < 0) {
        continue;
      }
      const Point start = sum(a.vertices[i], b.vertices[j]);
      const Point end = sum(a.vertices[i1], b.vertices[j1]);
      const bool d_longer = d.x * d.x + d.y * d.y > e.x * e.x + e.y * e.y;
      const Point& longer = d_longer ? d : e;
      const bool whole = (has(2, i, j) && has(1, i, j1)) || (has(1, i, j) && has(2, i1, j));
      const bool starts = has(2, i, j) && has(1, i, j);
      const bool ends = has(1, i, j1) && has(2, i1, j);
      if (!whole && !starts && !ends) {
        continue;
      }
      edges.erase({1, i, j});
      edges.erase({1, i, j1});
      edges.erase({2, i, j});
      edges.erase({2, i1, j});
      edges[{3, i, j}] = whole    ? segment(start, end)
                         : starts ? segment(start, sum(start, longer))
                                  : segment({end.x - longer.x, end.y - longer.y}, end);
    }
  }
  return edges;
}

std::multiset<Segment> segments_of(const NamedSegments& edges) {
  std::multiset<Segment> segments;
  for (const auto& [name, value] : edges) {
    segments.insert(value);
  }
  return segments;
}

TEST(Superset, IsThatOfTheDefinition) {
  Random random(22);
  std::map<EdgeKind, int> kinds;
  for (int k = 0; k < 4000; ++k) {
    const auto ring = [&] {
      return k % 2 == 0 ? test::random_small_integer_polygon(random, test::uniform(random, 3, 9), 5)
                        : test::random_histogram(random, test::uniform(random, 1, 5), 4);
    };
    const gcv::Boundary a = make_ring(ring(), "a");
    const gcv::Boundary b = make_ring(ring(), "b");
    Tally tally;
    const Operands operands{a, b, merge_directions(a, b, tally)};
    std::multiset<Segment> segments;
    for (const SupersetEdge& edge : enumerate_superset(operands)) {
      segments.insert(segment(sum(edge.from), sum(edge.to)));
      ++kinds[edge.source.kind];
    }
    ASSERT_EQ(segments, segments_of(superset_by_definition(a, b)));
  }
  EXPECT_GT(kinds[EdgeKind::translated], 1000);
  EXPECT_GT(kinds[EdgeKind::corner], 1000);
  EXPECT_GT(kinds[EdgeKind::translated_corner], 1000);
}

// A hole is a ring like any other, with the solid on its left.
TEST(Superset, OfPolygonsWithHolesIsThatOfTheDefinition) {
  Random random(23);
  for (int k = 0; k < 500; ++k) {
    Ring hole = test::random_small_integer_polygon(random, test::uniform(random, 3, 7), 5);
    for (Point& p : hole) {
      p = {p.x + 1, p.y + 1};
    }
    const Polygon a = make_polygon(std::vector<Ring>{{{0, 0}, {9, 0}, {7, 7}, {0, 9}}, hole}, "a");
    const Polygon b(test::random_small_integer_polygon(random, test::uniform(random, 3, 7), 5),
                    "b");
    Tally tally;
    const Operands operands{a.boundary(), b.boundary(),
                            merge_directions(a.boundary(), b.boundary(), tally)};
    std::multiset<Segment> segments;
    for (const SupersetEdge& edge : enumerate_superset(operands)) {
      segments.insert(segment(sum(edge.from), sum(edge.to)));
    }
    ASSERT_EQ(segments, segments_of(superset_by_definition(a.boundary(), b.boundary())));
  }
}

// A base with teeth of width 1 and gaps of width 1.
Ring comb(int teeth, int height) {
  Ring ring{{0, 0}, {2.0 * teeth - 1, 0}};
  for (int k = teeth - 1; k >= 0; --k) {
    ring.push_back({2.0 * k + 1, 1.0 * height});
    ring.push_back({2.0 * k, 1.0 * height});
    if (k > 0) {
      ring.push_back({2.0 * k, 1});
      ring.push_back({2.0 * k - 1, 1});
    }
  }
  return ring;
}

// A base with teeth that are steep on one side and slant on the other.
Ring saw(int teeth) {
  Ring ring{{0, 0}, {2.0 * teeth, 0}};
  for (int k = teeth; k > 0; --k) {
    ring.push_back({2.0 * k, 3});
    ring.push_back({2.0 * k - 2, 1});
  }
  return ring;
}

// Spikes of integer coordinates, long and short radii in turns.
Ring star(int spikes, double outer, double inner, double turn) {
  Ring ring;
  for (int k = 0; k < 2 * spikes; ++k) {
    const double angle = turn + k * std::numbers::pi / spikes;
    const double radius = k % 2 == 0 ? outer : inner;
    ring.push_back({std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle))});
  }
  return ring;
}

Ring turned_left(Ring ring) {
  for (Point& p : ring) {
    p = {-p.y, p.x};
  }
  return ring;
}

// How many edges of each kind a superset has.
struct Counts {
  std::size_t translated = 0;
  std::size_t corner = 0;
  std::size_t translated_corner = 0;

  friend bool operator==(const Counts&, const Counts&) = default;
  friend std::ostream& operator<<(std::ostream& stream, const Counts& c) {
    return stream << c.translated << " translated, " << c.corner << " corner, "
                  << c.translated_corner << " translated-corner";
  }

  void add(int kind) { ++(kind == 1 ? translated : kind == 2 ? corner : translated_corner); }
};

// The counts of the library. Checks them against the definition.
Counts counts_of(const Ring& ring_a, const Ring& ring_b) {
  const gcv::Boundary a = make_ring(ring_a, "a");
  const gcv::Boundary b = make_ring(ring_b, "b");
  Counts expected;
  for (const auto& [name, value] : superset_by_definition(a, b)) {
    expected.add(std::get<0>(name));
  }
  Counts counts;
  for (const SupersetEdge& edge : superset(a, b)) {
    counts.add(static_cast<int>(edge.source.kind));
  }
  EXPECT_EQ(counts, expected);
  return counts;
}

TEST(Superset, HasTheCountsOfACombAndATriangle) {
  // No edges are parallel, so nothing merges. One vertex of the triangle contributes to each of
  // the 4 t edges of the comb. The edge (5, 1) of the triangle has one convex vertex of the comb,
  // at the right of the base. (-2, 4) has the right one of each tooth's top, and (-3, -5) the left.
  const Ring triangle{{0, 0}, {5, 1}, {3, 5}};
  for (const int teeth : {2, 10, 40}) {
    const std::size_t t = static_cast<std::size_t>(teeth);
    EXPECT_EQ(counts_of(comb(teeth, 7), triangle), (Counts{4 * t, 2 * t + 1, 0}));
  }
}

TEST(Superset, HasTheCountsOfTwoCombs) {
  // All edges are parallel to others.
  EXPECT_EQ(counts_of(comb(10, 7), turned_left(comb(6, 9))), (Counts{63, 55, 136}));
}

TEST(Superset, HasTheCountsOfTwoStars) {
  EXPECT_EQ(counts_of(star(12, 1000, 300, 0), star(9, 800, 350, 0.1)), (Counts{90, 102, 0}));
}

TEST(Superset, HasTheCountsOfASawAndItsNegative) {
  // Edges are parallel to others, and vertices between parallel edges are reflex or not.
  EXPECT_EQ(counts_of(saw(8), test::negated(saw(8))), (Counts{16, 16, 16}));
}

}  // namespace
}  // namespace gcv
