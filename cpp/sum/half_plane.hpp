// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Half a plane of directions is enough. The edges of a ring add up to zero, so every ring has an
// edge strictly inside any open half-plane of directions. The superset edges through an isolated
// point turn all the way round it. A segment lies on superset edges of both of its directions: so
// one of the two directions of the border is taken as well.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "contributing_vertices.hpp"
#include "contributions.hpp"

namespace gcv {

// The first rank of the half-plane that holds the fewest superset edges: from that on
// counter-clockwise, without the opposite rank. O(n + m + K).
Rank cheapest_half_plane(const Operands& operands);

// Calls visit(edge) for each superset edge, before merging, whose direction is in the half-plane
// that begins with that rank.
template <class Visit>
void for_each_edge_of_half_plane(const Operands& operands, Rank first, Visit visit) {
  const Directions& directions = operands.directions;
  const Rank half = directions.half_turn;
  const Rank turn = 2 * half;
  const Rank last = (first + half - 1) % turn;
  const auto for_each = [&](const Boundary& polygon, const Ranks& ranks, const Ranks& edge_ranks,
                            auto take) {
    const EdgesByRank edges(edge_ranks, half);
    for_each_cone(polygon, ranks, [&](Index v, Rank in, Rank out) {
      const auto take_edges = [&](Rank from, Rank to) {
        edges.for_each(from, to, [&](Index edge) { take(edge, v); });
      };
      const Rank begin = directions.angle(first, in);
      const Rank end = begin + directions.angle(in, out);
      if (begin < half) {
        take_edges(in, end < half ? out : last);
      }
      if (end >= turn) {
        take_edges(first, out);
      }
    });
  };
  for_each(operands.b, directions.rank_b, directions.rank_a,
           [&](Index i, Index j) { visit(operands.translated(i, j)); });
  for_each(operands.a, directions.rank_a, directions.rank_b,
           [&](Index j, Index i) { visit(operands.corner(i, j)); });
}

}  // namespace gcv
