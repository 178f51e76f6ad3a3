// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Witnesses along superset edges: what they hold lies in the open sum, in fractions; and no pair of
// edges near a place is missing, in a loop over all of them.
#include "witness_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "cover.hpp"
#include "exact_pieces.hpp"
#include "exact_rings.hpp"
#include "generators.hpp"
#include "tree_product.hpp"

namespace gcv {
namespace {

using invariants::Exact;
using invariants::Rational;
using test::Random;

// Two polygons of small integers: relative coordinates of their sums are exact in doubles.
struct Example {
  Boundary a;
  Boundary b;
  Tally tally = {};
  Operands operands{a, b, merge_directions(a, b, tally)};
  invariants::Ring fixed = test::exact(a.vertices);
  invariants::Ring other = test::exact(b.vertices);

  // The point of the line with that parameter.
  [[nodiscard]] static Exact at(const RelativeLine& line, double t) {
    return test::exact(line.origin) + Rational(t) * Exact{Rational(line.dx), Rational(line.dy)};
  }
  // Do the interiors of A and x - B meet? x is in relative coordinates.
  [[nodiscard]] bool covers(const Exact& x) const {
    const Exact place = x + fixed.front() + other.front();
    invariants::Ring reflected;
    for (const Exact& p : other) {
      reflected.push_back(place - p);
    }
    return invariants::interiors_overlap(fixed, reflected);
  }
  // Does the sum of edge i of A and edge j of B hold the point?
  [[nodiscard]] bool holds(Index i, Index j, const Exact& x) const {
    const Exact p = test::exact(operands.relative(i, j));
    const Exact u = test::exact(operands.relative(a.next(i), j)) - p;
    const Exact v = test::exact(operands.relative(i, b.next(j))) - p;
    const Exact w = x - p;
    const Rational turn = invariants::cross(u, v);
    if (turn == 0) {
      return invariants::on_segment(std::min({p, p + u, p + v, p + u + v}),
                                    std::max({p, p + u, p + v, p + u + v}), x);
    }
    const Rational s = invariants::cross(w, v) / turn;
    const Rational t = invariants::cross(u, w) / turn;
    return s >= 0 && s <= 1 && t >= 0 && t <= 1;
  }
  [[nodiscard]] RelativeLine line(const PairEdge& e) const {
    const auto [from, to] = operands.source(e);
    return {operands.relative_start(e), to.x - from.x, to.y - from.y};
  }
  // What pairs of edges have in common that are the same but for their names.
  [[nodiscard]] auto sum_of_pair(Index i, Index j) const {
    const Point p = operands.relative(i, j);
    const Point q = operands.relative(a.next(i), b.next(j));
    const Directions& directions = operands.directions;
    return std::tuple{p.x,
                      p.y,
                      q.x,
                      q.y,
                      directions.rank_a[i],
                      directions.rank_b[j],
                      directions.rank_a[a.previous(i)],
                      directions.rank_b[b.previous(j)]};
  }
  [[nodiscard]] std::vector<PairEdge> contributing_edges() const {
    std::vector<PairEdge> edges;
    for (Index i = 0; i < a.size(); ++i) {
      for (Index j = 0; j < b.size(); ++j) {
        const PairEdge translated = operands.translated(i, j);
        const PairEdge corner = operands.corner(i, j);
        if (operands.b_contributes(j, translated.rank)) {
          edges.push_back(translated);
        }
        if (operands.a_contributes(i, corner.rank)) {
          edges.push_back(corner);
        }
      }
    }
    return edges;
  }
};

Example random_example(Random& random, int k) {
  const auto polygon = [&](int n) {
    return make_ring(k % 3 == 0   ? test::random_histogram(random, n, 4)
                     : k % 3 == 1 ? test::random_small_integer_polygon(random, n, 6)
                                  : test::random_small_integer_polygon(random, n, 30),
                     "polygon");
  };
  return {polygon(4 + k % 9), polygon(3 + k % 6)};
}

TEST(WitnessSearch, ReachesOnlyWhatLiesInTheOpenSum) {
  Random random(361);
  std::size_t reached = 0;
  for (int k = 0; k < 24; ++k) {
    const Example example = random_example(random, k);
    WitnessSearch search(example.operands);
    for (const PairEdge& edge : example.contributing_edges()) {
      const RelativeLine line = example.line(edge);
      search.begin(line);
      for (double t = 0; t < 1;) {
        const double end = search.reach(t);
        ASSERT_GE(end, t);
        ASSERT_LE(end, 1);
        if (end > t) {
          ++reached;
          for (const double part : {0.0, 0.375, 1.0}) {
            ASSERT_TRUE(example.covers(Example::at(line, t + part * (end - t))));
          }
        }
        t = end + 0.125;
      }
    }
  }
  EXPECT_GT(reached, 500U);
}

std::vector<WitnessSearch::Pair> pairs_near(WitnessSearch& search, double from, double to) {
  std::vector<WitnessSearch::Pair> pairs;
  search.approach(from, to);
  while (const std::optional<WitnessSearch::Pair> pair = search.next_pair()) {
    pairs.push_back(*pair);
  }
  EXPECT_FALSE(search.next_found_pair());
  return pairs;
}

// Looks for pairs along superset edges, but for those that are left out. Returns how many there
// were.
std::size_t check_pairs_near(const Example& example, Random& random, std::size_t edges_to_pass) {
  std::size_t found = 0;
  WitnessSearch search(example.operands);
  const std::vector<PairEdge> edges = example.contributing_edges();
  for (std::size_t k = 0; k < edges.size(); k += edges_to_pass) {
    const RelativeLine line = example.line(edges[k]);
    search.begin(line);
    for (double from = 0, to = 0; to < 1; from = std::min(to + 0.125, 1.0)) {
      from = search.reach(from);
      to = std::min(from + 0.125 * test::uniform(random, 0, 4), 1.0);
      const std::vector<WitnessSearch::Pair> pairs = pairs_near(search, from, to);
      std::set<std::pair<Index, Index>> near;
      for (const WitnessSearch::Pair& pair : pairs) {
        near.emplace(pair.i, pair.j);
      }
      EXPECT_EQ(pairs.size(), near.size());
      for (Index i = 0; i < example.a.size(); ++i) {
        for (Index j = 0; j < example.b.size(); ++j) {
          const bool is_near = example.holds(i, j, Example::at(line, from)) ||
                               example.holds(i, j, Example::at(line, to)) ||
                               example.holds(i, j, Example::at(line, (from + to) / 2));
          EXPECT_TRUE(!is_near || near.count({i, j}) != 0);
          found += is_near ? 1U : 0U;
        }
      }
    }
  }
  return found;
}

TEST(WitnessSearch, MissesNoPairOfEdges) {
  Random random(362);
  std::size_t found = 0;
  for (int k = 0; k < 6; ++k) {
    found += check_pairs_near(random_example(random, k), random, 1);
  }
  EXPECT_GT(found, 1000U);
}

PointVector even_comb(int teeth, double height = 5) {
  PointVector ring{{0, -1}, {2.0 * teeth - 1, -1}};
  for (int k = teeth - 1; k >= 0; --k) {
    const double x = 2 * k;
    ring.insert(ring.end(), {{x + 1, height}, {x, height}});
    if (k > 0) {
      ring.insert(ring.end(), {{x, 0}, {x - 1, 0}});
    }
  }
  return ring;
}

// Small integers, turned and five times as large.
PointVector slanting(PointVector ring) {
  for (Point& p : ring) {
    p = {4 * p.x - 3 * p.y, 3 * p.x + 4 * p.y};
  }
  return ring;
}

bool has_turned_boxes(const Boundary& a, const Boundary& b) {
  return !TurnedBoxes(a.cover_index().chords, b.cover_index().chords).empty();
}

TEST(WitnessSearch, MissesNoPairOfEdgesOfSlantingCombs) {
  constexpr double height = 40;
  const Boundary upright = make_ring(even_comb(6, height), "comb");
  const Boundary a = make_ring(slanting(even_comb(6, height)), "comb");
  const Boundary b = make_ring(slanting(even_comb(5, height - 7)), "comb");
  const Boundary square = make_ring(slanting({{0, 0}, {9, 0}, {9, 9}, {0, 9}}), "square");
  EXPECT_TRUE(has_turned_boxes(a, b));
  EXPECT_FALSE(has_turned_boxes(upright, upright));
  EXPECT_FALSE(has_turned_boxes(square, square));
  Random random(365);
  EXPECT_GT(check_pairs_near({a, b}, random, 5), 1000U);
  EXPECT_GT(check_pairs_near({a, upright}, random, 5), 1000U);
}

// A comb, whose teeth are alike but for the height of every third one and a side of every fifth
// one: so what goes before an edge differs too, before convex and reflex vertices.
Boundary comb(int teeth) {
  PointVector ring{{0, -1}, {2.0 * teeth - 1, -1}};
  for (int k = teeth - 1; k >= 0; --k) {
    const double x = 2 * k;
    const double height = k % 3 == 0 ? 4 : 5;
    ring.insert(ring.end(), {{x + 1, height}, {k % 5 == 0 ? x + 0.25 : x, height}});
    if (k > 0) {
      ring.insert(ring.end(), {{x, 0}, {x - 1, 0}});
    }
  }
  return make_ring(ring, "comb");
}

TEST(WitnessSearch, LeavesOutPairsThatEqualOthersAlone) {
  const Example example{comb(24), comb(20)};
  const auto sum_of_pair = [&](const WitnessSearch::Pair& pair) {
    return example.sum_of_pair(pair.i, pair.j);
  };
  using Sum = decltype(sum_of_pair({}));
  WitnessSearch search(example.operands);
  std::size_t left_out = 0;
  for (const PairEdge& edge : example.contributing_edges()) {
    if (edge.i % 5 != 0 || edge.j % 5 != 0) {
      continue;
    }
    const RelativeLine line = example.line(edge);
    const std::vector<WitnessSearch::Pair> all = search.all_pairs_near(line, 0, 1);
    search.begin(line);
    const std::vector<WitnessSearch::Pair> some = pairs_near(search, 0, 1);
    std::multiset<Sum> sums;
    for (const WitnessSearch::Pair& pair : some) {
      sums.insert(sum_of_pair(pair));
    }
    std::set<std::pair<Index, Index>> different;
    for (const WitnessSearch::Pair& pair : all) {
      ASSERT_TRUE(different.emplace(pair.i, pair.j).second);
      ASSERT_GE(sums.count(sum_of_pair(pair)), 1U);
    }
    left_out += all.size() - some.size();
  }
  EXPECT_GT(left_out, 300U);
}

// Nearly all superset edges of combs whose teeth are all alike coincide with others.
TEST(WitnessSearch, PassesOverEdgesThatEqualOthers) {
  const Example example{make_ring(even_comb(40), "a"), make_ring(even_comb(32), "b")};
  const Directions& directions = example.operands.directions;
  for (const Rank first : {Rank{0}, directions.half_turn}) {
    WitnessSearch search(example.operands);
    const auto key = [&](const PairEdge& e) {
      return std::pair{e.kind, example.sum_of_pair(e.i, e.j)};
    };
    std::set<decltype(key(PairEdge{}))> visited;
    std::size_t visits = 0;
    search.for_each_uncovered_edge(
        first,
        [&](const PairEdge& e) {
          visited.insert(key(e));
          ++visits;
        },
        [](std::uint64_t) {});
    std::size_t all = 0;
    for (const PairEdge& e : example.contributing_edges()) {
      if (directions.angle(first, e.rank) < directions.half_turn) {
        const RelativeLine line = example.line(e);
        ASSERT_TRUE(visited.count(key(e)) != 0 || search.covers(box_of(line.at(0), line.at(1))));
        ++all;
      }
    }
    EXPECT_LT(2 * visits, all);
    EXPECT_LT(visits, 8 * (example.a.size() + example.b.size()));
  }
}

TEST(WitnessSearch, PassesOverCoveredEdgesAlone) {
  Random random(363);
  std::size_t visited_edges = 0;
  std::size_t passed_over = 0;
  for (int k = 0; k < 24; ++k) {
    const Example example = random_example(random, k);
    const Directions& directions = example.operands.directions;
    const std::vector<PairEdge> edges = example.contributing_edges();
    WitnessSearch search(example.operands);
    for (const PairEdge& edge : edges) {  // what is found on the way may be passed over later
      search.begin(example.line(edge));
      for (double t = 0; t < 1; t = search.reach(t) + 0.25) {
      }
    }
    const auto first = static_cast<Rank>(k) % (2 * directions.half_turn);
    std::set<std::tuple<PairEdge::Kind, Index, Index>> visited;
    std::uint64_t pairs = 0;
    search.for_each_uncovered_edge(
        first,
        [&](const PairEdge& e) {
          ASSERT_LT(directions.angle(first, e.rank), directions.half_turn);
          ASSERT_TRUE(visited.insert({e.kind, e.i, e.j}).second);
        },
        [&](std::uint64_t passed) { pairs += passed; });
    ASSERT_EQ(pairs, std::uint64_t{example.operands.a.size()} * example.operands.b.size());
    visited_edges += visited.size();
    std::size_t known = 0;
    for (const PairEdge& e : edges) {
      if (visited.count({e.kind, e.i, e.j}) != 0) {
        ++known;
      } else if (directions.angle(first, e.rank) < directions.half_turn) {
        ++passed_over;
        for (const double t : {0.0, 0.375, 1.0}) {
          ASSERT_TRUE(example.covers(Example::at(example.line(e), t)));
        }
      }
    }
    ASSERT_EQ(known, visited.size());
  }
  EXPECT_GT(visited_edges, 200U);
  EXPECT_GT(passed_over, 10U);
}

// A bit along the way from a place on the boundary of the open sum lies outside of it.
TEST(EdgeCover, FindsWaysOff) {
  Random random(364);
  std::size_t ways = 0;
  for (int k = 0; k < 12; ++k) {
    Example example = random_example(random, k);
    const Operands& operands = example.operands;
    EdgeCover cover(operands, example.tally);
    for (Index i = 0; i < example.a.size(); ++i) {
      for (Index j = 0; j < example.b.size(); ++j) {
        const Exact place = test::exact(operands.relative(i, j));
        if (example.covers(place)) {
          continue;
        }
        for (const Point& way :
             cover.ways_off(operands.translated(i, j), Place::of(VertexSum{i, j}))) {
          ASSERT_FALSE(example.covers(place + Rational(0x1p-30) * test::exact(way)));
          ++ways;
        }
      }
    }
  }
  EXPECT_GT(ways, 100U);
}

}  // namespace
}  // namespace gcv
