// SPDX-License-Identifier: LGPL-3.0-or-later
#include "superset.hpp"

#include <algorithm>
#include <tuple>

#include "contributions.hpp"
#include "predicates.hpp"

namespace gcv {

namespace {

// Calls visit(edge, vertex) for every edge of one polygon and every generalized contributing
// vertex of the other.
template <class Visit>
void for_each_contribution(const Ranks& edge_ranks, const Boundary& polygon, const Ranks& ranks,
                           Rank half_turn, Visit visit) {
  const EdgesByRank edges(edge_ranks, half_turn);
  for_each_cone(polygon, ranks, [&](Index v, Rank in, Rank out) {
    edges.for_each(in, out, [&](Index edge) { visit(edge, v); });
  });
}

// The parallel pair of edges, one of A and one of B, that the edge e is part of: e's own
// edge, and the edge of the other polygon that starts or ends in its vertex. Since no
// polygon has collinear neighbours, there is at most one.
struct ParallelPair {
  bool exists;
  Index i;
  Index j;
};

ParallelPair parallel_pair(const Operands& operands, const EdgeName& e) {
  const Directions& directions = operands.directions;
  if (e.kind == EdgeName::translated) {
    const Index before = operands.b.previous(e.j);
    const Rank rank = directions.rank_a[e.i];
    if (directions.rank_b[e.j] == rank) {
      return {true, e.i, e.j};
    }
    return {directions.rank_b[before] == rank, e.i, before};
  }
  const Index before = operands.a.previous(e.i);
  const Rank rank = directions.rank_b[e.j];
  if (directions.rank_a[e.i] == rank) {
    return {true, e.i, e.j};
  }
  return {directions.rank_a[before] == rank, before, e.j};
}

// Is the direction of edge i of A, which edge j of B shares, the longer of the two?
// Along a line, lengths compare as the differences of one coordinate do.
bool a_is_longer(const Operands& operands, Index i, Index j) {
  const Point& v0 = operands.a.vertices[i];
  const Point& v1 = operands.a.vertices[operands.a.next(i)];
  const Point& w0 = operands.b.vertices[j];
  const Point& w1 = operands.b.vertices[operands.b.next(j)];
  Tally tally;
  // v1 - v0 > w1 - w0 as v1 + w0 > v0 + w1, with the sign of the direction.
  const int order = v0.x != v1.x ? compare_sums(v1.x, w0.x, v0.x, w1.x, tally)
                                 : compare_sums(v1.y, w0.y, v0.y, w1.y, tally);
  const bool ascending = v0.x != v1.x ? v0.x < v1.x : v0.y < v1.y;
  return ascending ? order > 0 : order < 0;
}

SupersetEdge translated_corner_edge(const Operands& operands, Index i, Index j, Merge merge) {
  const Index i1 = operands.a.next(i);
  const Index j1 = operands.b.next(j);
  const EdgeSource source{EdgeKind::translated_corner, i, j};
  if (merge == Merge::whole) {
    return {operands.point({i, j}), operands.point({i1, j1}), source};
  }
  const bool a_longer = a_is_longer(operands, i, j);
  if (merge == Merge::start) {
    return {operands.point({i, j}), a_longer ? operands.point({i1, j}) : operands.point({i, j1}),
            source};
  }
  return {a_longer ? operands.point({i, j1}) : operands.point({i1, j}), operands.point({i1, j1}),
          source};
}

}  // namespace

EdgeSource superset_source(const Operands& operands, const EdgeName& e) {
  const ParallelPair pair = parallel_pair(operands, e);
  if (pair.exists && operands.merge(pair.i, pair.j) != Merge::none) {
    return {EdgeKind::translated_corner, pair.i, pair.j};
  }
  return {e.kind == EdgeName::translated ? EdgeKind::translated : EdgeKind::corner, e.i, e.j};
}

std::vector<SupersetEdge> enumerate_superset(const Operands& operands) {
  const Boundary& a = operands.a;
  const Boundary& b = operands.b;
  const Directions& directions = operands.directions;
  std::vector<SupersetEdge> edges;
  // A merged pair is met once for each translated or corner edge that it absorbs.
  const auto add = [&](const EdgeName& e) {
    const EdgeSource source = superset_source(operands, e);
    if (source.kind == EdgeKind::translated_corner) {
      edges.push_back(
          translated_corner_edge(operands, source.a, source.b, operands.merge(source.a, source.b)));
    } else if (source.kind == EdgeKind::translated) {
      edges.push_back({operands.point({e.i, e.j}), operands.point({a.next(e.i), e.j}), source});
    } else {
      edges.push_back({operands.point({e.i, e.j}), operands.point({e.i, b.next(e.j)}), source});
    }
  };
  for_each_contribution(directions.rank_a, b, directions.rank_b, directions.half_turn,
                        [&](Index i, Index j) { add(operands.translated(i, j)); });
  for_each_contribution(directions.rank_b, a, directions.rank_a, directions.half_turn,
                        [&](Index j, Index i) { add(operands.corner(i, j)); });
  const auto key = [](const SupersetEdge& e) {
    return std::tuple(e.source.kind, e.source.a, e.source.b);
  };
  std::sort(edges.begin(), edges.end(),
            [&](const SupersetEdge& e, const SupersetEdge& f) { return key(e) < key(f); });
  const auto last =
      std::unique(edges.begin(), edges.end(),
                  [&](const SupersetEdge& e, const SupersetEdge& f) { return key(e) == key(f); });
  edges.erase(last, edges.end());
  return edges;
}

}  // namespace gcv
