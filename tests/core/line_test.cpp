// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Superset edges along a line, against all of them, one by one. The polygons have small integer
// coordinates: positions of their sums are exact in doubles.
#include "line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <tuple>
#include <vector>

#include "generators.hpp"
#include "minkowski_sum.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Ring;

auto key(const PairEdge& e) { return std::tuple(e.kind, e.i, e.j); }

std::vector<PairEdge> all_edges(const Operands& operands) {
  std::vector<PairEdge> edges;
  for (Index i = 0; i < operands.a.size(); ++i) {
    for (Index j = 0; j < operands.b.size(); ++j) {
      if (operands.b_contributes(j, operands.directions.rank_a[i])) {
        edges.push_back(operands.translated(i, j));
      }
      if (operands.a_contributes(i, operands.directions.rank_b[j])) {
        edges.push_back(operands.corner(i, j));
      }
    }
  }
  return edges;
}

Point at(const Operands& operands, const VertexSum& sum) {
  const Point& p = operands.a.vertices[sum.i];
  const Point& q = operands.b.vertices[sum.j];
  return {p.x + q.x, p.y + q.y};
}

double offset(const SumEdge& s, const Point& start, const Point& p) {
  return s.dx * (p.y - start.y) - s.dy * (p.x - start.x);
}
double along(const SumEdge& s, const Point& p) { return s.dx * p.x + s.dy * p.y; }

// How far edges of the direction of s lead on along its line, by looking at all of them again and
// again.
double reach_of(const Operands& operands, const std::vector<PairEdge>& edges, const PairEdge& s) {
  const SumEdge line = coordinates(operands.a, operands.b, s);
  const Point start = at(operands, start_of(s));
  double reach = along(line, at(operands, end_of(operands, s)));
  for (bool is_further = true; is_further;) {
    is_further = false;
    for (const PairEdge& e : edges) {
      const Point p = at(operands, start_of(e));
      const double end = along(line, at(operands, end_of(operands, e)));
      if (e.rank == s.rank && offset(line, start, p) == 0 && along(line, p) <= reach &&
          end > reach) {
        reach = end;
        is_further = true;
      }
    }
  }
  return reach;
}

struct RandomPair {
  gcv::Boundary a;
  gcv::Boundary b;
};

RandomPair random_pair(Random& random, int k) {
  const auto polygon = [&](int n) {
    return make_ring(k % 2 == 0 ? test::random_histogram(random, n, 3)
                                : test::random_small_integer_polygon(random, n, 5),
                     "polygon");
  };
  return {polygon(5 + k % 9), polygon(4 + k % 7)};
}

TEST(GapTree, FindsTheNextLargerGapExactly) {
  Random random(90);
  for (int k = 0; k < 200; ++k) {
    std::vector<Gap> gaps(static_cast<std::size_t>(test::uniform(random, 1, 40)));
    for (Gap& gap : gaps) {  // many of them are the same double
      gap = Gap::between(0x1p-60 * test::uniform(random, -2, 2), test::uniform(random, 1, 3));
    }
    gaps.back() = Gap::infinite();
    const GapTree tree(gaps);
    for (std::size_t first = 0; first < gaps.size(); ++first) {
      const Gap gap =
          Gap::between(0x1p-60 * test::uniform(random, -2, 2), test::uniform(random, 0, 3));
      const auto exactly = [](const Gap& g) {  // which long doubles can tell apart
        return static_cast<long double>(g.hi) + static_cast<long double>(g.lo);
      };
      std::size_t expected = first;
      while (!(exactly(gaps[expected]) > exactly(gap))) {
        ++expected;
      }
      ASSERT_EQ(tree.first_above(first, gap), expected);
    }
  }
}

TEST(LineSearch, ReachesAsFarAsTheEdgesLeadOn) {
  Random random(91);
  int further = 0;
  for (int k = 0; k < 120; ++k) {
    const RandomPair pair = random_pair(random, k);
    Tally tally;
    const Operands operands{pair.a, pair.b, merge_directions(pair.a, pair.b, tally)};
    const std::vector<PairEdge> edges = all_edges(operands);
    for (const PairEdge& s : edges) {
      LineSearch line(operands, s);
      ASSERT_TRUE(line.is_about(s));
      line.go_to(s);
      const VertexSum end = end_of(operands, s);
      const SumEdge at_s = coordinates(operands.a, operands.b, s);
      const Point reached = at(operands, line.reach(end));
      ASSERT_EQ(offset(at_s, at(operands, end), reached), 0);
      ASSERT_EQ(along(at_s, reached), reach_of(operands, edges, s));
      further += reached == at(operands, end) ? 0 : 1;
    }
  }
  EXPECT_GT(further, 1000);
}

TEST(LineSearch, VisitsTheEdgesThatLeaveTheLineToTheRight) {
  Random random(92);
  int leaving = 0;
  for (int k = 0; k < 60; ++k) {
    const RandomPair pair = random_pair(random, k);
    Tally tally;
    const Operands operands{pair.a, pair.b, merge_directions(pair.a, pair.b, tally)};
    const std::vector<PairEdge> edges = all_edges(operands);
    const TreeProduct product(operands);
    const double slack = slack_of(operands);
    for (const PairEdge& s : edges) {
      LineSearch line(operands, s);
      line.go_to(s);
      const SumEdge at_s = coordinates(operands.a, operands.b, s);
      const Point from = operands.relative_start(s);
      const Point to = operands.relative_end(s);
      std::set<std::tuple<PairEdge::Kind, Index, Index>> found;
      LineSearch::Place place(line, Piece(at_s, from, from, to, slack));
      product.search(place, [&](Index i, Index j) {
        const Index next_i = operands.a.next(i);
        const Index next_j = operands.b.next(j);
        const VertexSum corners[] = {{i, j}, {next_i, j}, {i, next_j}, {next_i, next_j}};
        ASSERT_TRUE(std::any_of(std::begin(corners), std::end(corners), [&](const VertexSum& sum) {
          return offset(at_s, from, operands.relative(sum.i, sum.j)) < 0;
        }));
        product.for_each_edge(i, j, [&](const PairEdge& e) { found.insert(key(e)); });
      });
      for (const PairEdge& e : edges) {
        const Point p = operands.relative_start(e);
        const Point q = operands.relative_end(e);
        const double side_of_p = offset(at_s, from, p);
        const double side_of_q = offset(at_s, from, q);
        const double first = offset({{}, {}, {}, q.x - p.x, q.y - p.y}, p, from);
        const double second = offset({{}, {}, {}, q.x - p.x, q.y - p.y}, p, to);
        if (side_of_p >= 0 && side_of_q < 0 && first * second <= 0) {
          ++leaving;
          ASSERT_TRUE(found.count(key(e)) != 0);
        }
      }
    }
  }
  EXPECT_GT(leaving, 1000);
}

// The symmetries of the square: exact in doubles.
Ring image(Ring ring, int symmetry) {
  for (Point& p : ring) {
    p = (symmetry & 1) != 0 ? Point{p.y, p.x} : p;
    p.x = (symmetry & 2) != 0 ? 0.0 - p.x : p.x;
    p.y = (symmetry & 4) != 0 ? 0.0 - p.y : p.y;
  }
  return ring;
}

OuterFace sum_of(const Ring& a, const Ring& b) {
  Task task;
  return minkowski_sum({std::make_shared<gcv::Boundary>(make_ring(a, "a")), "a"},
                       {std::make_shared<gcv::Boundary>(make_ring(b, "b")), "b"}, {0, 0},
                       Rounding::nearest, task);
}

std::vector<std::pair<double, double>> sorted(const Ring& ring) {
  std::vector<std::pair<double, double>> points;
  for (const Point& p : ring) {
    points.emplace_back(p.x, p.y);
  }
  std::sort(points.begin(), points.end());
  return points;
}

Ring comb(int teeth, double width, double gap, double height) {
  const double pitch = width + gap;
  Ring ring{{0, -1}, {pitch * teeth - gap, -1}};
  for (int k = teeth - 1; k >= 0; --k) {
    ring.insert(ring.end(), {{pitch * k + width, height}, {pitch * k, height}});
    if (k > 0) {
      ring.insert(ring.end(), {{pitch * k, 0}, {pitch * k - gap, 0}});
    }
  }
  return ring;
}

Ring saw(int teeth) {
  Ring ring{{0, -5}, {static_cast<double>(teeth), -5}};
  for (int k = teeth; k > 0; --k) {
    ring.insert(ring.end(), {{static_cast<double>(k), 0}, {k - 1.0, 3}});
  }
  return ring;
}

// In each position of both operands the same ring comes out, turned like them; and in each position
// of one alone the walk comes to its end.
void expect_the_same_everywhere(const Ring& a, const Ring& b) {
  for (int position = 0; position < 8; ++position) {
    const Ring c = image(b, position);
    const Ring sum = sum_of(a, c).rounded.vertices;
    for (int symmetry = 1; symmetry < 8; symmetry += 2) {
      ASSERT_EQ(sorted(sum_of(image(a, symmetry), image(c, symmetry)).rounded.vertices),
                sorted(image(sum, symmetry)));
    }
  }
}

TEST(LineSearch, ChangesNoSum) {
  expect_the_same_everywhere(comb(70, 0.5, 0.5, 40), comb(70, 0.5, 0.5, 40));
  expect_the_same_everywhere(comb(60, 1, 0.75, 9), comb(50, 0.5, 1.25, 7));
  expect_the_same_everywhere(comb(64, 0.5, 0.25, 5), saw(70));
  for (const int teeth : {55, 58, 100}) {
    expect_the_same_everywhere(saw(teeth), saw(teeth));
  }
}

// A few long steps in place of one for each pair of teeth.
TEST(LineSearch, CrossesTheTipsOfTwoCombsInAFewSteps) {
  const Ring thin = comb(500, 0.5, 0.5, 1000);
  for (int position = 0; position < 8; ++position) {
    const OuterFace face = sum_of(thin, image(thin, position));
    EXPECT_EQ(face.exact.size(), 4U);
    EXPECT_LT(face.counts.walk_steps, 1000U);
    EXPECT_LT(face.counts.candidate_edges, 20000U);
  }
}

}  // namespace
}  // namespace gcv
