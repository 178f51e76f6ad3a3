// SPDX-License-Identifier: LGPL-3.0-or-later
//
// In the sum of vertices i and j, the next edges of both polygons lie ahead of the edge
// that arrived, by less than half a turn each: the one further to the right comes first.
#include "convex_sum.hpp"

namespace gcv {

Walk merge_convex(const Operands& operands) {
  const Polygon& a = operands.a;
  const Polygon& b = operands.b;
  const Directions& directions = operands.directions;
  Index i = a.lexicographic_min;
  Index j = b.lexicographic_min;
  Index left_of_a = a.size();
  Index left_of_b = b.size();
  Walk walk;
  EdgeName arriving = operands.translated(i, j);  // of the first vertex, until it is known
  walk.vertices.reserve(left_of_a + left_of_b);
  while (left_of_a + left_of_b > 0) {
    const PairEdge translated = operands.translated(i, j);
    const PairEdge corner = operands.corner(i, j);
    const Rank angle = directions.angle(translated.rank, corner.rank);
    const bool take_a = left_of_b == 0 || (left_of_a > 0 && angle < directions.half_turn);
    const bool take_b = left_of_a == 0 || (left_of_b > 0 && (!take_a || angle == 0));
    walk.vertices.push_back(RingVertex::sum(i, j, arriving, take_a ? translated : corner));
    if (take_a) {
      arriving = translated;
      i = a.next(i);
      --left_of_a;
    }
    if (take_b) {
      arriving = operands.corner(i, j);  // of the next vertex of A where both are taken
      j = b.next(j);
      --left_of_b;
    }
  }
  walk.vertices.front().arrive_by(arriving);
  walk.steps = walk.vertices.size();
  return walk;
}

}  // namespace gcv
