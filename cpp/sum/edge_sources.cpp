// SPDX-License-Identifier: LGPL-3.0-or-later
#include "edge_sources.hpp"

#include <tuple>

#include "directions.hpp"
#include "edge_lines.hpp"
#include "piece.hpp"
#include "predicates.hpp"
#include "tree_product.hpp"

namespace gcv {

namespace {

// Finds the edges that walks without repeated chains take.
class CoincidingEdges {
 public:
  explicit CoincidingEdges(const Operands& operands)
      : operands_(operands), superset_(operands), slack_(slack_of(operands)) {}

  // Of the superset edges that pass through v, or start there, and end with its leaving edge, in
  // its direction, the first by kind and indices.
  EdgeName first(const RingVertex& v) {
    const PairEdge leaving = operands_.named(v.leaving());
    const PairEdge arriving = operands_.named(v.arriving());
    const SumEdge s = coordinates(operands_.a, operands_.b, leaving);
    const SumEdge line = coordinates(operands_.a, operands_.b, arriving);
    const Directions& directions = operands_.directions;
    const int away = directions.angle(arriving.rank, leaving.rank) < directions.half_turn ? 1 : -1;
    // The edge that arrives at a sum may be parallel: that of a segment.
    const auto begins_behind = [&](const PairEdge& e) {
      return v.is_sum() ? compare_along(operands_, leaving, operands_.point({v.i(), v.j()}),
                                        operands_.start(e), tally_) > 0
                        : side(line, operands_.start(e), tally_) == away;
    };
    const SumPoint end = operands_.end(leaving);
    const Point place = operands_.relative_end(leaving);
    Piece piece(s, operands_.relative_start(leaving), place, place, slack_);
    const auto key = [](const EdgeName& e) { return std::tuple(e.kind, e.i, e.j); };
    EdgeName first = leaving;
    superset_.search(piece, [&](Index i, Index j) {
      superset_.for_each_edge(i, j, [&](const PairEdge& e) {
        if (e.rank == leaving.rank && key(e) < key(first) &&
            are_equal(operands_.end(e), end, tally_) && !begins_behind(e)) {
          first = e;
        }
      });
    });
    return first;
  }

 private:
  const Operands& operands_;
  TreeProduct superset_;
  double slack_;
  Tally tally_;
};

}  // namespace

EdgeSource in_callers_numbers(const EdgeSource& source, const Boundary& a, const Boundary& b) {
  const bool a_is_edge = source.kind != EdgeKind::corner;
  const bool b_is_edge = source.kind != EdgeKind::translated;
  return {source.kind,
          a_is_edge ? a.corners[source.a].edge_number : a.corners[source.a].vertex_number,
          b_is_edge ? b.corners[source.b].edge_number : b.corners[source.b].vertex_number};
}

std::vector<EdgeSource> edge_sources(const ExactRing& ring) {
  const Boundary& a = *ring.a.ring;
  const Boundary& b = *ring.b.ring;
  Tally tally;
  const Operands operands{a, b, merge_directions(a, b, tally)};
  std::vector<EdgeSource> sources;
  sources.reserve(ring.size());
  const auto add = [&](const EdgeName& e) {
    sources.push_back(in_callers_numbers(superset_source(operands, e), a, b));
  };
  if (ring.chains_are_repeated) {
    CoincidingEdges edges(operands);
    for (const RingVertex& v : ring.vertices) {
      add(edges.first(v));
    }
  } else {
    for (const RingVertex& v : ring.vertices) {
      add(v.leaving());
    }
  }
  return sources;
}

}  // namespace gcv
