// SPDX-License-Identifier: LGPL-3.0-or-later
//
// In the sum of vertices i and j, the next edges of both polygons lie ahead of the edge
// that arrived, by less than half a turn each: the one further to the right comes first.
#include "convex_sum.hpp"

#include "predicates.hpp"

namespace gcv {

Walk merge_convex(const Boundary& a, const Boundary& b, Tally& tally) {
  Index i = a.lexicographic_min;
  Index j = b.lexicographic_min;
  Index left_of_a = a.size();
  Index left_of_b = b.size();
  Walk walk;
  EdgeName arriving{EdgeName::translated, i, j};  // of the first vertex, until it is known
  walk.vertices.reserve(left_of_a + left_of_b);
  while (left_of_a + left_of_b > 0) {
    const Index next_i = a.next(i);
    const Index next_j = b.next(j);
    const int order = left_of_b == 0   ? 1
                      : left_of_a == 0 ? -1
                                       : turn(a.vertices[i], a.vertices[next_i], b.vertices[j],
                                              b.vertices[next_j], tally);
    const EdgeName translated{EdgeName::translated, i, j};
    const EdgeName corner{EdgeName::corner, i, j};
    walk.vertices.push_back(RingVertex::sum(i, j, arriving, order >= 0 ? translated : corner));
    if (order >= 0) {
      arriving = translated;
      i = next_i;
      --left_of_a;
    }
    if (order <= 0) {
      arriving = {EdgeName::corner, i, j};  // of the next vertex of A where both are taken
      j = next_j;
      --left_of_b;
    }
  }
  walk.vertices.front().arrive_by(arriving);
  walk.steps = walk.vertices.size();
  return walk;
}

}  // namespace gcv
