// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Searches in the superset, in both its forms, by windows and by strips, against all its edges, one
// by one.
// The polygons have small integer coordinates, times a power of two: there the positions of edges
// are exact in doubles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <tuple>
#include <vector>

#include "generators.hpp"
#include "implicit_superset.hpp"
#include "local_superset.hpp"
#include "piece.hpp"
#include "predicates.hpp"
#include "strip.hpp"
#include "superset_tree.hpp"

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
  return {operands.relative_start(e), operands.relative_end(e)};
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
        edges.push_back(operands.translated(i, j));
      }
      if (operands.a_contributes(i, operands.directions.rank_b[j])) {
        edges.push_back(operands.corner(i, j));
      }
    }
  }
  return edges;
}

// Searches for the edges that meet a piece of each edge: prepare(operands, edges) gives a
// search(edge, piece, visit), which calls visit(e). The piece is the edge or its first half.
template <class Prepare>
void expect_all_found(double most_visits, Prepare prepare) {
  Random random(71);
  std::size_t visited = 0;
  std::size_t possible = 0;
  for (int k = 0; k < 150; ++k) {
    const int exponents[] = {0, -1000, -60, 900};
    const int exponent = exponents[k % 4];
    const double unit = std::ldexp(1.0, exponent);
    const auto polygon = [&](int vertices) {
      Ring ring = k % 3 == 0 ? test::random_histogram(random, vertices / 2, 200)
                             : test::random_small_integer_polygon(random, vertices, 200);
      for (Point& p : ring) {
        p = {p.x * unit, p.y * unit};
      }
      return make_polygon(ring, "polygon");
    };
    Tally tally;
    const Polygon a = polygon(4 + k % 24);
    const Polygon b = polygon(4 + k % 21);
    const Operands operands{a, b, merge_directions(a, b, tally)};
    const std::vector<PairEdge> edges = all_edges(operands);
    const auto search = prepare(operands, edges);
    std::size_t number = 0;
    for (const PairEdge& s : edges) {
      Segment piece = segment(operands, s);
      const SumEdge edge{{piece.from, {0, 0}},
                         piece.from,
                         piece.to,
                         piece.to.x - piece.from.x,
                         piece.to.y - piece.from.y};
      if (number++ % 2 == 0) {
        piece.to = {piece.from.x + edge.dx / 2, piece.from.y + edge.dy / 2};
      }
      std::set<std::tuple<PairEdge::Kind, Index, Index>> found;
      search(edge, piece, [&](const PairEdge& e) { EXPECT_TRUE(found.insert(key(e)).second); });
      if (exponent < 900) {  // there, products overflow
        visited += found.size();
        possible += edges.size();
      }
      for (const PairEdge& e : edges) {
        if (meet(piece, segment(operands, e))) {
          ASSERT_TRUE(found.count(key(e)) != 0);
        }
      }
    }
  }
  EXPECT_LT(static_cast<double>(visited), most_visits * static_cast<double>(possible));
}

TEST(SupersetTree, FindsAllEdgesThatMeetAPiece) {
  expect_all_found(0.3, [](const Operands& operands, const std::vector<PairEdge>& edges) {
    const RankedEdges ranked(operands.directions);
    const CoarseGrid grid(operands);
    EXPECT_EQ(count_superset(operands, ranked), edges.size());
    EXPECT_TRUE(grid.is_fine_enough(operands));
    return [tree = SupersetTree(operands, grid, ranked, edges.size())](
               const SumEdge& edge, const Segment& piece, auto visit) {
      tree.search(SupersetTree::Piece(tree, edge, piece.from, piece.to), visit);
    };
  });
}

// A gear of so many teeth, whose edges are about as long as its radius over their number.
Polygon gear(int teeth, double radius) {
  Ring ring;
  for (int k = 0; k < 2 * teeth; ++k) {
    const double angle = M_PI * k / teeth;
    const double r = k % 2 == 0 ? radius : 0.8 * radius;
    ring.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return make_polygon(ring, "gear");
}

TEST(CoarseGrid, IsTooCoarseForManyShortEdgesOrExtentsOutOfRange) {
  const auto is_fine = [](double radius_a, double radius_b) {
    Tally tally;
    const Polygon a = gear(50, radius_a);
    const Polygon b = gear(50, radius_b);
    const Operands operands{a, b, merge_directions(a, b, tally)};
    return CoarseGrid(operands).is_fine_enough(operands);
  };
  EXPECT_TRUE(is_fine(1, 1));
  EXPECT_TRUE(is_fine(1, 1e-2));
  EXPECT_FALSE(is_fine(1, 1e-4));
  EXPECT_FALSE(is_fine(1e-4, 1));
  EXPECT_TRUE(is_fine(0x1p-900, 0x1p-900));
  EXPECT_TRUE(is_fine(0x1p1020, 0x1p1020));
  EXPECT_FALSE(is_fine(0x1p1023, 0x1p1023));
  EXPECT_FALSE(is_fine(0x1p-1020, 0x1p-1020));
}

TEST(ImplicitSuperset, FindsAllEdgesThatMeetAPiece) {
  expect_all_found(0.3, [](const Operands& operands, const std::vector<PairEdge>& /*edges*/) {
    return [superset = ImplicitSuperset(operands), slack = slack_of(operands)](
               const SumEdge& edge, const Segment& piece, auto visit) {
      Piece place(edge, edge.from, piece.from, piece.to, slack);
      superset.search(place, [&](Index i, Index j) { superset.for_each_edge(i, j, visit); });
    };
  });
}

TEST(LocalSuperset, HoldsAllEdgesThatMeetAPiece) {
  std::size_t windows = 0;
  std::size_t pieces = 0;
  const auto prepare = [&](const Operands& operands, const std::vector<PairEdge>& /*edges*/) {
    auto superset = std::make_shared<ImplicitSuperset>(operands);
    auto local = std::make_shared<LocalSuperset>(*superset, slack_of(operands));
    return [&windows, &pieces, superset, local, slack = slack_of(operands)](
               const SumEdge& edge, const Segment& piece, auto visit) {
      const auto& [from, to] = piece;
      const double length = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
      ++pieces;
      if (local->covers(from, to) ||
          (length < local->reach() && local->gather(from, to, nullptr))) {
        ++windows;
        local->for_each_near(edge.from, edge.dx, edge.dy, from, to, visit);
      } else {
        Piece place(edge, edge.from, from, to, slack);
        superset->search(place, [&](Index i, Index j) { superset->for_each_edge(i, j, visit); });
      }
    };
  };
  expect_all_found(0.3, prepare);
  EXPECT_GT(windows, pieces / 2);
}

// A walk that comes to the start of a piece by a bent way, swinging, which leads on along it.
void walk_to(Strip& strip, const Segment& piece) {
  const double dx = piece.to.x - piece.from.x;
  const double dy = piece.to.y - piece.from.y;
  for (int k = -400; k < 0; ++k) {
    const double along = k / 100.0;
    const double across = (k % 2 == 0 ? 0.1 : -0.1) + 0.01 * along * along;
    strip.pass({piece.from.x + along * dx - across * dy, piece.from.y + along * dy + across * dx});
  }
}

TEST(Strip, HoldsAllEdgesThatMeetAPiece) {
  std::size_t strips = 0;
  std::size_t shortened = 0;
  std::size_t pieces = 0;
  const auto prepare = [&](const Operands& operands, const std::vector<PairEdge>& /*edges*/) {
    auto superset = std::make_shared<ImplicitSuperset>(operands);
    auto strip = std::make_shared<Strip>(*superset, slack_of(operands));
    return [&, superset, strip, slack = slack_of(operands)](const SumEdge& edge,
                                                            const Segment& piece, auto visit) {
      Piece place(edge, edge.from, piece.from, piece.to, slack);
      ++pieces;
      if (!strip->holds(piece.from)) {
        walk_to(*strip, piece);
      }
      strip->fund().add_search(1000000);
      if (!strip->keep_up(piece.from, nullptr)) {
        superset->search(place, [&](Index i, Index j) { superset->for_each_edge(i, j, visit); });
        return;
      }
      ++strips;
      std::set<std::tuple<PairEdge::Kind, Index, Index>> found;
      const auto visit_once = [&](const PairEdge& e) {
        if (found.insert(key(e)).second) {
          visit(e);
        }
      };
      if (!strip->holds(piece.to)) {  // then up to its border, and beyond it in the superset
        ++shortened;
        const double room = strip->room(piece.from, edge.dx, edge.dy);
        EXPECT_LT(room, 1);
        const Point border{piece.from.x + room * edge.dx, piece.from.y + room * edge.dy};
        EXPECT_TRUE(strip->holds(border));
        Piece rest(edge, edge.from, border, piece.to, slack);
        superset->search(rest,
                         [&](Index i, Index j) { superset->for_each_edge(i, j, visit_once); });
        place.shorten(border);
      }
      strip->search(place, visit_once);
    };
  };
  expect_all_found(0.3, prepare);
  EXPECT_GT(strips, pieces / 2);
  EXPECT_GT(shortened, strips / 10);
}

TEST(StripFund, SpendsAnEighthOfWhatSearchesCostAtMostWhereStripsSpareNothing) {
  StripFund fund;
  std::int64_t searched = 0;
  std::int64_t spent = 0;
  for (int k = 0; k < 100000; ++k) {
    fund.add_search(100);
    searched += 100;
    if (const std::int64_t most = fund.most(); most > 0) {
      fund.spend(most, k % 3 != 0);
      spent += most;
    }
    EXPECT_LE(8 * spent, searched);
  }
  EXPECT_GT(64 * spent, searched);
  EXPECT_LT(31 * spent, searched);
}

TEST(StripFund, GrantsOneAfterAnotherWhereTheySpareMoreThanTwiceTheirCost) {
  StripFund fund;
  while (fund.most() == 0) {
    fund.add_search(100);
  }
  for (int strip = 0; strip < 100; ++strip) {
    ASSERT_GE(fund.most(), 512);
    fund.spend(512, true);
    for (int k = 0; k < 13; ++k) {
      fund.add_spared(10);
    }
  }
}

TEST(StripFund, GrantsNoneWhereWindowsSpareMostSearches) {
  StripFund fund;
  for (int k = 0; k < 100000; ++k) {
    fund.add_search(100);
    fund.add_window();
    EXPECT_EQ(fund.most(), 0);
  }
}

}  // namespace
}  // namespace gcv
