// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Searches in the superset, in both its forms, by both caches, against all its edges, one
// by one.
// The polygons have small integer coordinates, times a power of two: there the positions of edges
// are exact in doubles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "ahead_cache.hpp"
#include "choose.hpp"
#include "generators.hpp"
#include "piece.hpp"
#include "place_cache.hpp"
#include "predicates.hpp"
#include "table.hpp"
#include "tree_product.hpp"

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

// Searches for the edges that meet a piece of each edge, by search(edge, piece, visit), which calls
// visit(e). The piece is the edge or its first half. Returns how many were visited.
template <class SearchFor>
std::size_t expect_found(const Operands& operands, const std::vector<PairEdge>& edges,
                         SearchFor search) {
  std::set<std::tuple<PairEdge::Kind, Index, Index>> all;
  for (const PairEdge& e : edges) {
    all.insert(key(e));
  }
  std::size_t visited = 0;
  std::size_t number = 0;
  for (const PairEdge& s : edges) {
    Segment piece = segment(operands, s);
    const SumEdge line = coordinates(operands.a, operands.b, s);
    const SumEdge edge{{piece.from, {0, 0}}, piece.from, piece.to, line.dx, line.dy};
    if (number++ % 2 == 0) {
      piece.to = {piece.from.x + edge.dx / 2, piece.from.y + edge.dy / 2};
    }
    std::set<std::tuple<PairEdge::Kind, Index, Index>> found;
    search(edge, piece, [&](const PairEdge& e) {
      EXPECT_TRUE(all.count(key(e)) != 0 && found.insert(key(e)).second);
    });
    visited += found.size();
    for (const PairEdge& e : edges) {
      EXPECT_TRUE(!meet(piece, segment(operands, e)) || found.count(key(e)) != 0);
    }
  }
  return visited;
}

// The same for many polygons: prepare(operands, edges) gives the search.
template <class Prepare>
void expect_all_found(double most_visits, Prepare prepare) {
  Random random(71);
  std::size_t visited = 0;
  std::size_t possible = 0;
  for (int k = 0; k < 150; ++k) {
    const int exponents[] = {0, -1000, -60, 900};
    const int exponent = exponents[k % 4];
    const int stretches[] = {0, -9, 12};  // of y
    const Point unit{std::ldexp(1.0, exponent), std::ldexp(1.0, exponent + stretches[k / 4 % 3])};
    const auto boundary = [&](int vertices) {
      Ring ring = k % 3 == 0 ? test::random_histogram(random, vertices / 2, 200)
                             : test::random_small_integer_polygon(random, vertices, 200);
      for (Point& p : ring) {
        p = {p.x * unit.x, p.y * unit.y};
      }
      return ring;
    };
    // Some with two more rings, in the box of the first one, which is all that a search knows of
    // holes.
    const auto polygon = [&](int vertices) {
      const gcv::Boundary outer = make_ring(boundary(vertices), "outer");
      const Point& first = outer.vertices.front();
      std::vector<gcv::Boundary> holes;
      for (int hole = 0; hole < (k % 5 == 0 ? 2 : 0); ++hole) {
        Ring ring = boundary(5);
        for (Point& p : ring) {
          p = {first.x + p.x / 256, outer.bounds.y0 + p.y / 400 + unit.y / 2};
        }
        holes.push_back(make_ring(ring, "hole", gcv::Boundary::Kind::hole));
      }
      std::vector<const Boundary*> all;
      for (const Boundary& hole : holes) {
        all.push_back(&hole);
      }
      return joined(outer, all);
    };
    Tally tally;
    const gcv::Boundary a = polygon(4 + k % 24);
    const gcv::Boundary b = polygon(4 + k % 21);
    const Operands operands{a, b, merge_directions(a, b, tally)};
    const std::vector<PairEdge> edges = all_edges(operands);
    const std::size_t found = expect_found(operands, edges, prepare(operands, edges));
    if (exponent < 900) {  // there, products overflow
      visited += found;
      possible += edges.size() * edges.size();
    }
  }
  EXPECT_LT(static_cast<double>(visited), most_visits * static_cast<double>(possible));
}

auto search_in_table(const Operands& operands, const std::vector<PairEdge>& edges) {
  const RankedEdges ranked(operands.directions);
  const CoarseGrid grid(operands);
  EXPECT_EQ(count_superset(operands, ranked).all(), edges.size());
  EXPECT_TRUE(grid.is_fine_enough(operands) || operands.a.layout.ring_count() > 1);
  return [tree = SupersetTable(operands, grid, ranked, edges.size())](
             const SumEdge& edge, const Segment& piece, auto visit) {
    tree.search(SupersetTable::Piece(tree, edge, piece.from, piece.to), visit);
  };
}

TEST(SupersetTable, FindsAllEdgesThatMeetAPiece) {
  expect_all_found(0.3, [](const Operands& operands, const std::vector<PairEdge>& edges) {
    return search_in_table(operands, edges);
  });
}

// In units of the grid their directions are too small for doubles.
TEST(SupersetTable, FindsEdgesBesideTheShortestOnes) {
  for (const double unit : {0x1p-60, 0x1p-1000, 0x1p-1070}) {
    const Ring large{{0, 0}, {0x1p1000, 0}, {0x1p999, 0x1p999}, {0, 0x1p1000}};
    Ring small{{0, 0}, {9, 1}, {9, 4}, {3, 3}, {5, 8}, {0, 7}};
    for (Point& p : small) {
      p = {p.x * unit, p.y * unit};
    }
    Tally tally;
    const gcv::Boundary a = make_ring(large, "large");
    const gcv::Boundary b = make_ring(small, "small");
    const Operands operands{a, b, merge_directions(a, b, tally)};
    const std::vector<PairEdge> edges = all_edges(operands);
    expect_found(operands, edges, search_in_table(operands, edges));
  }
}

// A gear of so many teeth, whose edges are about as long as its radius over their number, stretched
// along y.
gcv::Boundary gear(int teeth, double radius, double stretch = 1) {
  Ring ring;
  for (int k = 0; k < 2 * teeth; ++k) {
    const double angle = M_PI * k / teeth;
    const double r = k % 2 == 0 ? radius : 0.8 * radius;
    ring.push_back({r * std::cos(angle), stretch * r * std::sin(angle)});
  }
  return make_ring(ring, "gear");
}

TEST(CoarseGrid, IsTooCoarseForManyShortEdgesOrExtentsOutOfRange) {
  const auto is_fine = [](double radius_a, double radius_b, double stretch = 1) {
    Tally tally;
    const gcv::Boundary a = gear(50, radius_a, stretch);
    const gcv::Boundary b = gear(50, radius_b, stretch);
    const Operands operands{a, b, merge_directions(a, b, tally)};
    return CoarseGrid(operands).is_fine_enough(operands);
  };
  EXPECT_TRUE(is_fine(1, 1));
  EXPECT_TRUE(is_fine(1, 1e-2));
  EXPECT_FALSE(is_fine(1, 1e-4));
  EXPECT_FALSE(is_fine(1e-4, 1));
  EXPECT_TRUE(is_fine(1, 1, 1e-6));
  EXPECT_TRUE(is_fine(1, 1, 1e6));
  EXPECT_FALSE(is_fine(1, 1e-4, 1e6));
  EXPECT_TRUE(is_fine(0x1p-900, 0x1p-900));
  EXPECT_TRUE(is_fine(0x1p1020, 0x1p1020));
  EXPECT_FALSE(is_fine(0x1p1023, 0x1p1023));
  EXPECT_FALSE(is_fine(0x1p-1020, 0x1p-1020));
}

TEST(TreeProduct, FindsAllEdgesThatMeetAPiece) {
  expect_all_found(0.3, [](const Operands& operands, const std::vector<PairEdge>& /*edges*/) {
    return [superset = TreeProduct(operands), slack = slack_of(operands)](
               const SumEdge& edge, const Segment& piece, auto visit) {
      Piece place(edge, edge.from, piece.from, piece.to, slack);
      superset.search(place, [&](Index i, Index j) { superset.for_each_edge(i, j, visit); });
    };
  });
}

// The trees over their edges are not in the order of the boundary.
TEST(TreeProduct, FindsAllEdgesOfSpirals) {
  Ring spiral;
  Ring inner;
  for (int k = 0; k < 80; ++k) {
    const double low = 2 * k;
    const double high = 320 - 2 * k;
    spiral.insert(spiral.end(), {{low, low}, {high, low}, {high, high}, {low + 2, high}});
    inner.insert(
        inner.end(),
        {{low + 1, low + 1}, {high - 1, low + 1}, {high - 1, high - 1}, {low + 3, high - 1}});
  }
  spiral.insert(spiral.end(), inner.rbegin(), inner.rend());
  for (Point& p : spiral) {
    p = {4 * p.x - 3 * p.y, 3 * p.x + 4 * p.y};
  }
  const gcv::Boundary a = make_ring(spiral, "spiral");
  const gcv::Boundary b = make_ring(Ring{{0, 0}, {3, 1}, {1, 2}, {2, 5}}, "small");
  ASSERT_FALSE(a.search_index().order.empty());
  for (const auto& [p, q] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    Tally tally;
    const Operands operands{*p, *q, merge_directions(*p, *q, tally)};
    const std::vector<PairEdge> edges = all_edges(operands);
    const TreeProduct superset(operands);
    const std::size_t visited =
        expect_found(operands, edges, [&](const SumEdge& edge, const Segment& piece, auto visit) {
          Piece place(edge, edge.from, piece.from, piece.to, slack_of(operands));
          superset.search(place, [&](Index i, Index j) { superset.for_each_edge(i, j, visit); });
        });
    EXPECT_LT(visited, 20 * edges.size());
  }
}

// A zigzag in the direction (40, 3), turned, is full of long boxes one over the other.
TEST(SearchableSuperset, TakesTablesWhereFewBoxesLieOverAPlace) {
  const auto has_table = [](bool is_turned, int vertices) {
    Ring ring;
    for (int k = 0; k < vertices; ++k) {
      const bool is_back = k >= vertices / 2;
      const double x = is_back ? vertices - 1 - k : k;
      const double y = (static_cast<int>(x) % 2 == 0 ? 0 : vertices / 2) + (is_back ? 1 : 0);
      ring.push_back(is_turned ? Point{4 * x - 3 * y, 3 * x + 4 * y} : Point{x, y / 1000});
    }
    const gcv::Boundary a = make_ring(ring, "zigzag");
    const gcv::Boundary b = make_ring(Ring{{0, 0}, {3, 1}, {1, 2}, {2, 5}}, "small");
    Tally tally;
    const Operands operands{a, b, merge_directions(a, b, tally)};
    return SearchableSuperset(operands).table().has_value();
  };
  EXPECT_TRUE(has_table(false, 1000));
  EXPECT_FALSE(has_table(true, 1000));
  EXPECT_TRUE(has_table(true, 40));
}

// Those of stairs and a slanting bar lie along a line, and leave most of the sum's box empty.
TEST(SearchableSuperset, TakesTreesWhereBoxesLieAlongACurve) {
  const auto has_table = [](int steps, double length) {
    Ring ring;
    for (int k = 0; k <= 2 * steps; ++k) {
      ring.push_back({static_cast<double>((k + 1) / 2), static_cast<double>(k / 2)});
    }
    ring.push_back({0, static_cast<double>(steps)});
    const gcv::Boundary a = make_ring(ring, "stairs");
    const gcv::Boundary b =
        make_ring(Ring{{0, 0}, {4 * length, length}, {4 * length - 1, length + 4}, {-1, 4}}, "bar");
    Tally tally;
    const Operands operands{a, b, merge_directions(a, b, tally)};
    return SearchableSuperset(operands).table().has_value();
  };
  EXPECT_FALSE(has_table(2000, 200));
  EXPECT_TRUE(has_table(2000, 2));
  EXPECT_TRUE(has_table(1000, 100));
}

TEST(PlaceCache, HoldsAllEdgesThatMeetAPiece) {
  std::size_t served = 0;
  std::size_t pieces = 0;
  const auto prepare = [&](const Operands& operands, const std::vector<PairEdge>& /*edges*/) {
    auto superset = std::make_shared<TreeProduct>(operands);
    auto local = std::make_shared<PlaceCache>(*superset, slack_of(operands));
    return [&served, &pieces, superset, local, slack = slack_of(operands)](
               const SumEdge& edge, const Segment& piece, auto visit) {
      const auto& [from, to] = piece;
      const double length = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
      ++pieces;
      if (local->covers(from, to) ||
          (length < local->reach() && local->gather(from, to, nullptr))) {
        ++served;
        local->for_each_near(edge.from, edge.dx, edge.dy, from, to, visit);
      } else {
        Piece place(edge, edge.from, from, to, slack);
        superset->search(place, [&](Index i, Index j) { superset->for_each_edge(i, j, visit); });
      }
    };
  };
  expect_all_found(0.3, prepare);
  EXPECT_GT(served, pieces / 2);
}

// A walk that comes to the start of a piece by a bent way, swinging, which leads on along it.
void walk_to(AheadCache& cache, const Segment& piece) {
  const double dx = piece.to.x - piece.from.x;
  const double dy = piece.to.y - piece.from.y;
  for (int k = -400; k < 0; ++k) {
    const double along = k / 100.0;
    const double across = (k % 2 == 0 ? 0.1 : -0.1) + 0.01 * along * along;
    cache.pass({piece.from.x + along * dx - across * dy, piece.from.y + along * dy + across * dx});
  }
}

TEST(AheadCache, HoldsAllEdgesThatMeetAPiece) {
  std::size_t boxes = 0;
  std::size_t shortened = 0;
  std::size_t pieces = 0;
  const auto prepare = [&](const Operands& operands, const std::vector<PairEdge>& /*edges*/) {
    auto superset = std::make_shared<TreeProduct>(operands);
    auto cache = std::make_shared<AheadCache>(*superset, slack_of(operands));
    return [&, superset, cache, slack = slack_of(operands)](const SumEdge& edge,
                                                            const Segment& piece, auto visit) {
      Piece place(edge, edge.from, piece.from, piece.to, slack);
      ++pieces;
      if (!cache->holds(piece.from)) {
        walk_to(*cache, piece);
      }
      cache->budget().add_search(1000000);
      if (!cache->keep_up(piece.from, nullptr)) {
        superset->search(place, [&](Index i, Index j) { superset->for_each_edge(i, j, visit); });
        return;
      }
      ++boxes;
      std::set<std::tuple<PairEdge::Kind, Index, Index>> found;
      const auto visit_once = [&](const PairEdge& e) {
        if (found.insert(key(e)).second) {
          visit(e);
        }
      };
      if (!cache->holds(piece.to)) {  // then up to its border, and beyond it in the superset
        ++shortened;
        const double room = cache->room(piece.from, edge.dx, edge.dy);
        EXPECT_LT(room, 1);
        const Point border{piece.from.x + room * edge.dx, piece.from.y + room * edge.dy};
        EXPECT_TRUE(cache->holds(border));
        Piece rest(edge, edge.from, border, piece.to, slack);
        superset->search(rest,
                         [&](Index i, Index j) { superset->for_each_edge(i, j, visit_once); });
        place.shorten(border);
      }
      cache->search(place, visit_once);
    };
  };
  expect_all_found(0.3, prepare);
  EXPECT_GT(boxes, pieces / 2);
  EXPECT_GT(shortened, boxes / 10);
}

TEST(CostBudget, SpendsAnEighthOfWhatSearchesCostAtMostWhereFillsSpareNothing) {
  CostBudget budget;
  std::int64_t searched = 0;
  std::int64_t spent = 0;
  for (int k = 0; k < 100000; ++k) {
    budget.add_search(100);
    searched += 100;
    if (const std::int64_t most = budget.most(); most > 0) {
      budget.spend(most, k % 3 != 0);
      spent += most;
    }
    EXPECT_LE(8 * spent, searched);
  }
  EXPECT_GT(64 * spent, searched);
  EXPECT_LT(31 * spent, searched);
}

TEST(CostBudget, GrantsOneAfterAnotherWhereTheySpareMoreThanTwiceTheirCost) {
  CostBudget budget;
  while (budget.most() == 0) {
    budget.add_search(100);
  }
  for (int cache = 0; cache < 100; ++cache) {
    ASSERT_GE(budget.most(), 512);
    budget.spend(512, true);
    for (int k = 0; k < 13; ++k) {
      budget.add_spared(10);
    }
  }
}

TEST(CostBudget, GrantsNoneWhereThePlaceCacheSparesMostSearches) {
  CostBudget budget;
  for (int k = 0; k < 100000; ++k) {
    budget.add_search(100);
    budget.add_near();
    EXPECT_EQ(budget.most(), 0);
  }
}

}  // namespace
}  // namespace gcv
