// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A search in the tree against all superset edges, one by one. The polygons have small integer
// coordinates, times a power of two: there the positions of edges are exact in doubles.
#include "superset_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <vector>

#include "generators.hpp"
#include "predicates.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Ring;

struct Segment {
  Point from;
  Point to;
};

auto key(const PairEdge& e) { return std::tuple(e.kind, e.i, e.j); }

// In relative coordinates.
Segment segment(const Operands& operands, const PairEdge& e) {
  const auto sum = [&](Index i, Index j) {
    const Point& p = operands.a.relative[i];
    const Point& q = operands.b.relative[j];
    return Point{p.x + q.x, p.y + q.y};
  };
  return {sum(e.i, e.j), e.kind == PairEdge::translated ? sum(operands.a.next(e.i), e.j)
                                                        : sum(e.i, operands.b.next(e.j))};
}

bool meet(const Segment& s, const Segment& t) {
  Tally tally;
  const auto sides = [&](const Segment& u, const Segment& v) {
    return orientation(u.from, u.to, v.from, tally) * orientation(u.from, u.to, v.to, tally);
  };
  const auto apart = [](double a, double b, double c, double d) {
    return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
  };
  return sides(s, t) <= 0 && sides(t, s) <= 0 && !apart(s.from.x, s.to.x, t.from.x, t.to.x) &&
         !apart(s.from.y, s.to.y, t.from.y, t.to.y);
}

std::vector<PairEdge> all_edges(const Operands& operands) {
  std::vector<PairEdge> edges;
  for (Index i = 0; i < operands.a.size(); ++i) {
    for (Index j = 0; j < operands.b.size(); ++j) {
      if (operands.b_contributes(j, operands.directions.rank_a[i])) {
        edges.push_back({PairEdge::translated, i, j});
      }
      if (operands.a_contributes(i, operands.directions.rank_b[j])) {
        edges.push_back({PairEdge::corner, i, j});
      }
    }
  }
  return edges;
}

TEST(SupersetTree, FindsAllEdgesThatMeetAPiece) {
  Random random(71);
  std::size_t visited = 0;
  std::size_t possible = 0;
  for (int k = 0; k < 150; ++k) {
    const int exponents[] = {0, -1000, -60, 900};
    const double unit = std::ldexp(1.0, exponents[k % 4]);
    const auto polygon = [&](int vertices) {
      Ring ring = test::random_small_integer_polygon(random, vertices, 200);
      for (Point& p : ring) {
        p = {p.x * unit, p.y * unit};
      }
      return make_polygon(ring, "polygon");
    };
    Tally tally;
    const Polygon a = polygon(4 + k % 20);
    const Polygon b = polygon(4 + k % 17);
    const Operands operands{a, b, merge_directions(a, b, tally)};
    const std::vector<PairEdge> edges = all_edges(operands);
    const RankedEdges ranked(operands.directions);
    ASSERT_EQ(count_superset(operands, ranked), edges.size());
    const SupersetTree tree(operands, ranked, edges.size());
    for (const PairEdge& s : edges) {
      const Segment piece = segment(operands, s);
      const Point& origin = piece.from;
      const SumEdge edge{{origin, {0, 0}},
                         piece.from,
                         piece.to,
                         piece.to.x - piece.from.x,
                         piece.to.y - piece.from.y};
      std::set<std::tuple<PairEdge::Kind, Index, Index>> found;
      tree.search(SupersetTree::Piece(tree, edge, origin, piece.from, piece.to),
                  [&](const PairEdge& e) { EXPECT_TRUE(found.insert(key(e)).second); });
      visited += found.size();
      possible += edges.size();
      for (const PairEdge& e : edges) {
        if (meet(piece, segment(operands, e))) {
          ASSERT_TRUE(found.count(key(e)) != 0);
        }
      }
    }
  }
  EXPECT_LT(visited, possible / 3);
}

}  // namespace
}  // namespace gcv
