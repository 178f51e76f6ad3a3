// SPDX-License-Identifier: LGPL-3.0-or-later
//
// On small integers, whose sums are doubles: the cycle covers the superset and nothing else, and
// says of each edge which others touch it.
#include "convolution_cycle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <utility>
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

class Sum {
 public:
  Sum(const gcv::Boundary& a, const gcv::Boundary& b)
      : operands_{a, b, merge_directions(a, b, tally_)},
        cycle_(ConvolutionCycle::find({a, b, {}}, tally_)) {}

  [[nodiscard]] const Operands& operands() const { return operands_; }
  [[nodiscard]] const std::optional<ConvolutionCycle>& cycle() const { return cycle_; }

  [[nodiscard]] Segment segment(const EdgeName& e) const {
    const SumPoint p = operands_.start(e);
    const SumPoint q = operands_.end(e);
    return {{p.a.x + p.b.x, p.a.y + p.b.y}, {q.a.x + q.b.x, q.a.y + q.b.y}};
  }

  // All edges that vertices contribute to (the paper, Definition 1).
  [[nodiscard]] std::vector<PairEdge> contributions() const {
    std::vector<PairEdge> edges;
    for (Index i = 0; i < operands_.a.size(); ++i) {
      for (Index j = 0; j < operands_.b.size(); ++j) {
        const PairEdge translated = operands_.translated(i, j);
        if (operands_.b_contributes(j, translated.rank)) {
          edges.push_back(translated);
        }
        const PairEdge corner = operands_.corner(i, j);
        if (operands_.a_contributes(i, corner.rank)) {
          edges.push_back(corner);
        }
      }
    }
    return edges;
  }

  // Those of the cycle, from its first one on, with their numbers.
  [[nodiscard]] std::vector<std::pair<Index, PairEdge>> edges() const {
    std::vector<std::pair<Index, PairEdge>> edges;
    for (Index number = 0; number < cycle_->size(); ++number) {
      if (!cycle_->is_gap(number)) {
        edges.emplace_back(number, operands_.named(cycle_->edge(number)));
      }
    }
    return edges;
  }

 private:
  Tally tally_;
  Operands operands_;
  std::optional<ConvolutionCycle> cycle_;
};

bool on_one_line(const Segment& s, const Segment& t) {
  Tally tally;
  return orientation(s.from, s.to, t.from, tally) == 0 &&
         orientation(s.from, s.to, t.to, tally) == 0;
}

// How far along its line a point is, for points of one line.
double along(const Segment& s, const Point& p) { return s.from.x != s.to.x ? p.x : p.y; }

std::pair<double, double> extent(const Segment& line, const Segment& s) {
  return std::minmax({along(line, s.from), along(line, s.to)});
}

bool meet(const Segment& s, const Segment& t) {
  Tally tally;
  if (on_one_line(s, t)) {
    const auto [s0, s1] = extent(s, s);
    const auto [t0, t1] = extent(s, t);
    return s0 <= t1 && t0 <= s1;
  }
  return orientation(s.from, s.to, t.from, tally) * orientation(s.from, s.to, t.to, tally) <= 0 &&
         orientation(t.from, t.to, s.from, tally) * orientation(t.from, t.to, s.to, tally) <= 0;
}

// Does the edge lie on edges of the cycle with the same direction?
bool is_covered(const Sum& sum, const PairEdge& e) {
  const Segment s = sum.segment(e);
  std::vector<std::pair<double, double>> parts;
  for (const auto& [number, f] : sum.edges()) {
    if (f.rank == e.rank && on_one_line(s, sum.segment(f))) {
      parts.push_back(extent(s, sum.segment(f)));
    }
  }
  std::sort(parts.begin(), parts.end());
  auto [reached, end] = extent(s, s);
  for (const auto& [from, to] : parts) {
    if (from <= reached) {
      reached = std::max(reached, to);
    }
  }
  return reached >= end;
}

void check(const Sum& sum) {
  const auto edges = sum.edges();
  const auto contributions = sum.contributions();
  for (const PairEdge& e : contributions) {
    ASSERT_TRUE(is_covered(sum, e));
  }
  const auto name = [](const EdgeName& e) { return std::tuple(e.kind, e.i, e.j); };
  for (const auto& [number, e] : edges) {
    const auto is_e = [&, &edge = e](const PairEdge& f) { return name(f) == name(edge); };
    ASSERT_TRUE(std::any_of(contributions.begin(), contributions.end(), is_e));
    if (const auto next = sum.cycle()->next(number)) {
      const PairEdge f = sum.operands().named(sum.cycle()->edge(*next));
      ASSERT_EQ(sum.segment(e).to, sum.segment(f).from);
      ASSERT_EQ(sum.cycle()->goes_straight_on(*next), f.rank == e.rank);
    }
  }
  for (const auto& [p, e] : edges) {
    for (const auto& [q, f] : edges) {
      const auto are_neighbours = [&](Index k, Index l) { return sum.cycle()->next(k) == l; };
      const auto near = sum.cycle()->near(p);
      const bool is_near = std::find(near.begin(), near.end(), q) != near.end();
      if (p != q && !are_neighbours(p, q) && !are_neighbours(q, p) &&
          meet(sum.segment(e), sum.segment(f))) {
        ASSERT_TRUE(is_near);
      }
    }
  }
}

TEST(ConvolutionCycle, CoversTheSupersetAndKnowsWhatIsNear) {
  Random random(7);
  int cycles = 0;
  int with_gaps = 0;
  for (int k = 0; k < 20000 && cycles < 2000; ++k) {
    const int extent = test::uniform(random, 3, 12);
    const gcv::Boundary a =
        make_ring(test::random_small_integer_polygon(random, k % 2 == 0 ? 4 : 12, extent), "a");
    const gcv::Boundary b =
        make_ring(test::random_small_integer_polygon(random, k % 2 == 0 ? 12 : 4, extent), "b");
    const Sum sum(a, b);
    ASSERT_TRUE(!sum.cycle() || a.is_convex != b.is_convex);
    if (sum.cycle()) {
      check(sum);
      if (HasFatalFailure()) {
        return;
      }
      ++cycles;
      with_gaps += sum.edges().size() < sum.cycle()->size() ? 1 : 0;
    }
  }
  EXPECT_EQ(cycles, 2000);
  EXPECT_GT(with_gaps, 500);
}

TEST(ConvolutionCycle, StartsInVerticesOfTheHull) {
  const gcv::Boundary a = make_ring(Ring{{0, 0}, {4, 0}, {4, 4}, {3, 1}}, "a");
  const gcv::Boundary b = make_ring(Ring{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, "b");
  for (const auto& [p, q] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const Sum sum(*p, *q);
    ASSERT_TRUE(sum.cycle());
    const Index first = sum.cycle()->first_from(p->lexicographic_min, q->lexicographic_min);
    EXPECT_EQ(sum.segment(sum.cycle()->edge(first)).from, (Point{0, 0}));
  }
}

TEST(ConvolutionCycle, IsNotWhereAllIsNearAll) {
  Random random(8);
  const gcv::Boundary comb = make_ring(test::random_histogram(random, 400, 50), "comb");
  const gcv::Boundary small = make_ring(Ring{{0, 0}, {0.5, 0}, {0.25, 0.5}}, "small");
  const gcv::Boundary large = make_ring(Ring{{0, 0}, {300, 10}, {150, 200}}, "large");
  EXPECT_TRUE(Sum(comb, small).cycle());
  EXPECT_FALSE(Sum(comb, large).cycle());
  EXPECT_FALSE(Sum(comb, comb).cycle());
  EXPECT_FALSE(Sum(small, large).cycle());
}

}  // namespace
}  // namespace gcv
