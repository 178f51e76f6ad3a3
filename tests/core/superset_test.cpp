// SPDX-License-Identifier: LGPL-3.0-or-later
#include "superset.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

#include "data.hpp"
#include "generators.hpp"
#include "minkowski_sum.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Ring;

// Definition 1, word for word, in the doubles of small integers, where it is exact.
bool contributes_by_definition(const Polygon& edges, Index e, const Polygon& vertices, Index k) {
  const auto edge = [](const Polygon& p, Index i) {
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
    const Polygon a = make_polygon(
        test::random_small_integer_polygon(random, test::uniform(random, 3, 8), extent), "a");
    const Polygon b = make_polygon(
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

// The superset by brute force: every contribution, then the three cases on every pair of
// edges of equal direction.
std::multiset<Segment> superset_by_definition(const Polygon& a, const Polygon& b) {
  std::map<std::tuple<int, Index, Index>, Segment> edges;  // by kind, i, j
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
  std::multiset<Segment> segments;
  for (const auto& [key, value] : edges) {
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
    const Polygon a = make_polygon(ring(), "a");
    const Polygon b = make_polygon(ring(), "b");
    Tally tally;
    const Operands operands{a, b, merge_directions(a, b, tally)};
    std::multiset<Segment> segments;
    for (const SupersetEdge& edge : enumerate_superset(operands)) {
      segments.insert(segment(sum(edge.from), sum(edge.to)));
      ++kinds[edge.source.kind];
    }
    ASSERT_EQ(segments, superset_by_definition(a, b));
  }
  EXPECT_GT(kinds[EdgeKind::translated], 1000);
  EXPECT_GT(kinds[EdgeKind::corner], 1000);
  EXPECT_GT(kinds[EdgeKind::translated_corner], 1000);
}

TEST(Superset, HasThePapersCounts) {
  const auto directory = test::data_directory();
  if (!directory) {
    GTEST_SKIP() << "no polygon data: set GCV_DATA_DIR";
  }
  const std::map<std::string, std::size_t> counts{
      {"stars", 371}, {"comb", 80}, {"fork", 331}, {"knife", 211}};
  std::size_t found = 0;
  for (const test::NamedPair& pair : test::read_pairs(*directory)) {
    if (const auto count = counts.find(pair.name); count != counts.end()) {
      EXPECT_EQ(superset(make_polygon(pair.a, "a"), make_polygon(pair.b, "b")).size(),
                count->second)
          << pair.name;
      ++found;
    }
  }
  EXPECT_EQ(found, counts.size());
}

}  // namespace
}  // namespace gcv
