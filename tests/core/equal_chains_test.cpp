// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Searches that pass over what they have met, against all superset edges in fractions: no edge may
// be missed but for one that coincides with it.
#include "equal_chains.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <memory>
#include <set>
#include <tuple>
#include <utility>

#include "box.hpp"
#include "edge_sources.hpp"
#include "generators.hpp"
#include "minkowski_sum.hpp"
#include "predicates.hpp"
#include "tree_product.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Ring;

using Rational = boost::multiprecision::mpq_rational;
using EdgeInFractions = std::tuple<Rational, Rational, Rational, Rational>;

// All of the plane.
struct Everywhere {
  static TreeProduct::Offsets offsets(const Box& /*box*/) { return {0, 0}; }
  static void cull(const TreeProduct::Block& /*block*/, const TreeProduct::Node& /*other*/,
                   TreeProduct::Survivors& survivors) {
    survivors = {SimdDouble::all, {0, 0, 0, 0}, {0, 0, 0, 0}};
  }
};

EdgeInFractions in_fractions(const Operands& operands, const PairEdge& e) {
  const auto sum = [](double x, double y) { return Rational(Rational(x) + Rational(y)); };
  const SumPoint from = operands.start(e);
  const SumPoint to = operands.end(e);
  return {sum(from.a.x, from.b.x), sum(from.a.y, from.b.y), sum(to.a.x, to.b.x),
          sum(to.a.y, to.b.y)};
}

struct Found {
  std::set<EdgeInFractions> edges;
  std::size_t visits = 0;
};

Found find_all(const Operands& operands, const TreeProduct& superset, VisitedPairs* met) {
  Found found;
  Everywhere everywhere;
  superset.search(
      everywhere,
      [&](Index i, Index j) {
        superset.for_each_edge(i, j, [&](const PairEdge& e) {
          found.edges.insert(in_fractions(operands, e));
          ++found.visits;
        });
      },
      met);
  return found;
}

// Only edges that coincide may be passed over. Tells what part of the visits is left.
double expect_all_found(const Ring& ring_a, const Ring& ring_b) {
  const gcv::Boundary a = make_ring(ring_a, "a");
  const gcv::Boundary b = make_ring(ring_b, "b");
  Tally tally;
  const Operands operands{a, b, merge_directions(a, b, tally)};
  const TreeProduct superset(operands, find_equal_chains(operands));
  if (!superset.has_equal_chains()) {
    ADD_FAILURE() << "no repeated chains";
    return 1;
  }
  VisitedPairs met;
  const Found all = find_all(operands, superset, nullptr);
  double part = 1;
  for (int twice = 0; twice < 2; ++twice) {  // what one search has met, the next one meets again
    const Found without_repetitions = find_all(operands, superset, &met);
    EXPECT_EQ(all.edges, without_repetitions.edges);
    part = static_cast<double>(without_repetitions.visits) / static_cast<double>(all.visits);
  }
  return part;
}

Ring scaled(Ring ring, double factor) {
  for (Point& p : ring) {
    p = {p.x * factor, p.y * factor};
  }
  return ring;
}

// Stairs up and down, again and again.
Ring steps(Random& random) {
  const int heights[] = {test::uniform(random, 3, 4), test::uniform(random, 1, 2),
                         test::uniform(random, 3, 4), test::uniform(random, 1, 2)};
  const int width = test::uniform(random, 1, 3);
  constexpr int columns = 40;
  Ring ring{{0, 0}, {static_cast<double>(columns * width), 0}};
  for (int k = columns; k > 0; --k) {
    const double height = heights[k % 4];
    ring.push_back({static_cast<double>(width * k), height});
    ring.push_back({static_cast<double>(width * (k - 1)), height});
  }
  return ring;
}

TEST(EqualChains, OfAPolygonWithItself) {
  Random random(81);
  for (int k = 0; k < 5; ++k) {
    const Ring ring = test::random_spiky_star(random, 70 + k);
    EXPECT_LT(expect_all_found(ring, ring), 0.6);
  }
}

TEST(EqualChains, OfSteps) {
  Random random(82);
  for (int k = 0; k < 10; ++k) {
    const Ring a = steps(random);
    EXPECT_LT(expect_all_found(a, steps(random)), 0.7);
  }
}

// Sums that differ from each other by less than a unit in the last place.
TEST(EqualChains, WhereSumsAreNoDoubles) {
  Random random(83);
  for (int k = 0; k < 4; ++k) {
    const Ring a = steps(random);
    const Ring b = steps(random);
    expect_all_found(a, scaled(b, 0x1p-60));
    expect_all_found(scaled(a, 0x1p-1000), scaled(b, 0x1p-1060));
    expect_all_found(scaled(a, 0x1p1010), b);
  }
}

// The number of the edge that starts in vertex i.
std::uint32_t number(const gcv::Boundary& polygon, const EqualChains::Numbers& numbers, Index i) {
  return numbers[polygon.index().tree.first_block.back() + i / ChainTree::width]
                [i % ChainTree::width];
}

// The numbers of the edges of two polygons, against what they say of them.
void expect_right_numbers(const Ring& ring_a, const Ring& ring_b) {
  const gcv::Boundary a = make_ring(ring_a, "a");
  const gcv::Boundary b = make_ring(ring_b, "b");
  Tally tally;
  const Operands operands{a, b, merge_directions(a, b, tally)};
  const EqualChains chains = find_equal_chains(operands);
  ASSERT_TRUE(chains.exist());
  const auto vector = [](const gcv::Boundary& polygon, Index i) {
    const Point& p = polygon.vertices[i];
    const Point& q = polygon.vertices[polygon.next(i)];
    return std::pair(Rational(Rational(q.x) - Rational(p.x)),
                     Rational(Rational(q.y) - Rational(p.y)));
  };
  const auto cone = [](const gcv::Boundary& polygon, const Ranks& ranks, Index i) {
    return polygon.corners[i].convex ? std::pair(true, ranks[polygon.previous(i)])
                                     : std::pair(false, Rank{0});
  };
  int equal = 0;
  for (Index i = 0; i < a.size(); ++i) {
    for (Index j = 0; j < b.size(); ++j) {
      const bool are_equal =
          vector(a, i) == vector(b, j) &&
          cone(a, operands.directions.rank_a, i) == cone(b, operands.directions.rank_b, j);
      ASSERT_EQ(are_equal, number(a, chains.a, i) == number(b, chains.b, j));
      equal += are_equal ? 1 : 0;
    }
  }
  EXPECT_GT(equal, 0);
}

Ring transposed(Ring ring) {
  for (Point& p : ring) {
    p = {p.y, p.x};
  }
  return ring;
}

// Edges that differ in the last place only, or in what their starts contribute to.
TEST(EqualChains, EdgesAreNumberedByWhatTheyAre) {
  Random random(84);
  for (int k = 0; k < 10; ++k) {
    const Ring ring = steps(random);
    Ring moved = ring;
    for (Point& p : moved) {
      p.y = p.y == 1 ? std::nextafter(1.0, 2.0) : p.y;
    }
    expect_right_numbers(ring, moved);
    expect_right_numbers(transposed(ring), transposed(moved));
  }
}

// The first, by kind and indices, of the superset edges that pass through a vertex of the ring, or
// start there, and end with its leaving edge, in its direction.
PairEdge first_coinciding(const Operands& operands, const RingVertex& v) {
  const SumEdge arriving = coordinates(operands.a, operands.b, v.arriving());
  const auto line_side = [&](const SumPoint& p) {
    Tally tally;
    return side(arriving, p, tally);
  };
  const int ahead = line_side(operands.end(v.leaving()));
  const auto end = [&](const PairEdge& e) {
    const EdgeInFractions fractions = in_fractions(operands, e);
    return std::pair(std::get<2>(fractions), std::get<3>(fractions));
  };
  const auto key = [](const PairEdge& e) { return std::tuple(e.kind, e.i, e.j); };
  PairEdge first = operands.named(v.leaving());
  const auto consider = [&](const PairEdge& e) {
    if (e.rank == first.rank && key(e) < key(first) && end(e) == end(first) &&
        line_side(operands.start(e)) != ahead) {
      first = e;
    }
  };
  for (Index i = 0; i < operands.a.size(); ++i) {
    for (Index j = 0; j < operands.b.size(); ++j) {
      if (operands.b_contributes(j, operands.directions.rank_a[i])) {
        consider(operands.translated(i, j));
      }
      if (operands.a_contributes(i, operands.directions.rank_b[j])) {
        consider(operands.corner(i, j));
      }
    }
  }
  return first;
}

TEST(EqualChains, SourcesAreTheFirstOfTheEdgesThatCoincide) {
  Random random(86);
  for (int k = 0; k < 6; ++k) {
    const Ring ring_a = k % 3 == 0 ? test::random_spiky_star(random, 220) : steps(random);
    const Ring ring_b = k % 3 == 1 ? steps(random) : ring_a;
    const Operand a{std::make_shared<const gcv::Boundary>(make_ring(ring_a, "a")), "a"};
    const Operand b{std::make_shared<const gcv::Boundary>(make_ring(ring_b, "b")), "b"};
    Task task;
    const ExactRing ring = minkowski_sum(a, b, {0, 0}, Rounding::nearest, task).exact;
    ASSERT_TRUE(ring.chains_are_repeated || k % 3 == 1);
    const std::vector<EdgeSource> sources = edge_sources(ring);
    Tally tally;
    const Operands operands{*a.ring, *b.ring, merge_directions(*a.ring, *b.ring, tally)};
    ASSERT_EQ(sources.size(), ring.size());
    for (std::size_t v = 0; v < ring.size(); ++v) {
      const EdgeSource expected = in_callers_numbers(
          superset_source(operands, first_coinciding(operands, ring.vertices[v])), *a.ring,
          *b.ring);
      ASSERT_EQ(std::tuple(sources[v].kind, sources[v].a, sources[v].b),
                std::tuple(expected.kind, expected.a, expected.b));
    }
  }
}

TEST(EqualChains, NoneOfFewEdgesOrOfMostlyDifferentOnes) {
  Random random(85);
  const auto exist = [](const Ring& ring_a, const Ring& ring_b) {
    const gcv::Boundary a = make_ring(ring_a, "a");
    const gcv::Boundary b = make_ring(ring_b, "b");
    Tally tally;
    return find_equal_chains({a, b, merge_directions(a, b, tally)}).exist();
  };
  const Ring stairs = steps(random);
  const Ring star = test::random_spiky_star(random, 70);
  EXPECT_TRUE(exist(stairs, stairs));
  EXPECT_FALSE(exist(stairs, {{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
  EXPECT_FALSE(exist(star, test::random_spiky_star(random, 70)));
  EXPECT_FALSE(exist(test::random_histogram(random, 100, 1 << 20),
                     test::random_histogram(random, 100, 1 << 20)));
  Ring longest = stairs;  // its longest edge is longer than the largest double
  const double width = stairs[1].x;
  for (Point& p : longest) {
    p = {(2 * p.x / width - 1) * 0x1.8p1023, p.y};
  }
  EXPECT_FALSE(exist(longest, longest));
}

}  // namespace
}  // namespace gcv
