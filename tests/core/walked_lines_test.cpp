// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Parts of lines that were walked, against all edges before, one by one. The polygons have small
// integer coordinates: positions of their sums are exact in doubles.
#include "walked_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "generators.hpp"
#include "tree_product.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Ring;

std::vector<PairEdge> all_edges(const Operands& operands) {
  std::vector<PairEdge> edges;
  for (Index i = 0; i < operands.a.size(); ++i) {
    for (Index j = 0; j < operands.b.size(); ++j) {
      edges.push_back(operands.translated(i, j));
      edges.push_back(operands.corner(i, j));
    }
  }
  return edges;
}

// A part of a line: its direction, where the line meets an axis, and from where to where the part
// goes.
struct Part {
  Rank rank;
  double offset;
  double from;
  double to;
};

// Parts are measured along a line by x, or by y where it is upright.
double place_on(const Operands& operands, const PairEdge& e, const VertexSum& sum) {
  const SumPoint start = operands.start(e);
  const SumPoint end = operands.end(e);
  const double dx = end.a.x + end.b.x - start.a.x - start.b.x;
  const double dy = end.a.y + end.b.y - start.a.y - start.b.y;
  const SumPoint point = operands.point(sum);
  const double sign = (dx == 0 ? dy : dx) > 0 ? 1 : -1;
  return sign * (dx == 0 ? point.a.y + point.b.y : point.a.x + point.b.x);
}

Part part_of(const Operands& operands, const PairEdge& e) {
  const SumPoint start = operands.start(e);
  const SumPoint end = operands.end(e);
  const Point p{start.a.x + start.b.x, start.a.y + start.b.y};
  const Point q{end.a.x + end.b.x, end.a.y + end.b.y};
  const double dx = q.x - p.x;
  const double dy = q.y - p.y;
  const bool is_upright = dx == 0;
  const double offset = is_upright ? p.x : p.y - p.x * (dy / dx);
  const double sign = (is_upright ? dy : dx) > 0 ? 1 : -1;
  const double from = sign * (is_upright ? p.y : p.x);
  return {e.rank, offset, from, sign * (is_upright ? q.y : q.x)};
}

bool is_on_line(const Part& p, const Part& q) {
  return p.rank == q.rank && std::abs(p.offset - q.offset) < 1e-9;
}

using Stretch = std::pair<double, double>;

// What the others leave of a part, in order.
std::vector<Stretch> left_of(const Part& part, const std::vector<Part>& others) {
  std::vector<Stretch> on_line;
  for (const Part& other : others) {
    if (is_on_line(part, other)) {
      on_line.emplace_back(other.from, other.to);
    }
  }
  std::sort(on_line.begin(), on_line.end());
  std::vector<Stretch> left;
  double reached = part.from;
  for (const auto& [from, to] : on_line) {
    if (from > reached && reached < part.to) {
      left.emplace_back(reached, std::min(from, part.to));
    }
    reached = std::max(reached, to);
  }
  if (reached < part.to) {
    left.emplace_back(reached, part.to);
  }
  return left;
}

struct Pair {
  Boundary a;
  Boundary b;
};

Pair random_pair(Random& random, int k) {
  const auto polygon = [&](int n) {
    return make_ring(k % 2 == 0 ? test::random_histogram(random, n, 4)
                                : test::random_small_integer_polygon(random, n, 5),
                     "polygon");
  };
  return {polygon(4 + k % 7), polygon(3 + k % 5)};
}

TEST(WalkedLines, LeaveWhatWasNotWalked) {
  Random random(321);
  std::size_t held = 0;
  std::size_t asked = 0;
  std::size_t cut = 0;  // into several
  for (int k = 0; k < 80; ++k) {
    const Pair pair = random_pair(random, k);
    Tally tally;
    const Operands operands{pair.a, pair.b, merge_directions(pair.a, pair.b, tally)};
    WalkedLines lines(operands, slack_of(operands), tally);
    std::vector<PairEdge> edges = all_edges(operands);
    for (std::size_t i = edges.size() - 1; i > 0; --i) {
      std::swap(edges[i], edges[random() % (i + 1)]);
    }
    std::vector<Part> walked;
    for (const PairEdge& edge : edges) {
      const Part part = part_of(operands, edge);
      std::vector<Stretch> left;
      for (const WalkedLines::Part& stretch : lines.left_of(edge)) {
        const double from = place_on(operands, edge, stretch.from);
        left.emplace_back(from, place_on(operands, edge, stretch.to));
      }
      ++asked;
      held += left.empty() ? 1U : 0U;
      cut += left.size() > 1 ? 1U : 0U;
      // An edge that is alone in its direction is not asked for.
      const auto same_rank = [&](const PairEdge& e) { return e.rank == edge.rank; };
      const bool is_asked = std::count_if(edges.begin(), edges.end(), same_rank) >
                            static_cast<std::ptrdiff_t>(
                                edge.kind == EdgeName::translated ? pair.b.size() : pair.a.size());
      ASSERT_EQ(left,
                is_asked ? left_of(part, walked) : (std::vector<Stretch>{{part.from, part.to}}));
      walked.push_back(part);
      ASSERT_EQ(lines.left_of(edge).empty(), is_asked);
    }
  }
  EXPECT_GT(held, asked / 4);
  EXPECT_GT(cut, 0U);
}

// All teeth of a comb have their tips on one line. What is walked from one tip to the next is one
// part, which holds all other edges there.
TEST(WalkedLines, JoinEdgesOfALine) {
  Ring comb{{0, -1}, {39, -1}};
  for (int k = 9; k >= 0; --k) {
    comb.insert(comb.end(), {{4.0 * k + 3, 5}, {4.0 * k, 5}});
    if (k > 0) {
      comb.insert(comb.end(), {{4.0 * k, 0}, {4.0 * k - 1, 0}});
    }
  }
  const Boundary a = make_ring(comb, "a");
  const Boundary b = make_ring({{0, 0}, {9, 0}, {9, 1}, {0, 1}}, "b");
  Tally tally;
  const Operands operands{a, b, merge_directions(a, b, tally)};
  WalkedLines lines(operands, slack_of(operands), tally);
  const auto is_tip = [&](Index i) { return a.vertices[i].y == 5; };
  const Index top = 2;  // from (9, 1) to (0, 1)
  ASSERT_EQ(b.vertices[top], (Point{9, 1}));
  int corners = 0;
  for (Index i = 0; i < a.size(); ++i) {
    if (is_tip(i)) {
      ++corners;
      EXPECT_FALSE(lines.left_of(operands.corner(i, top)).empty());
    }
  }
  EXPECT_EQ(corners, 20);
  for (Index i = 0; i < a.size(); ++i) {
    if (is_tip(i)) {
      EXPECT_TRUE(lines.left_of(operands.corner(i, top)).empty());
    }
    if (is_tip(i) && is_tip(a.next(i))) {
      EXPECT_TRUE(lines.left_of(operands.translated(i, top)).empty());
      EXPECT_TRUE(lines.left_of(operands.translated(i, b.next(top))).empty());
    }
  }
}

}  // namespace
}  // namespace gcv
