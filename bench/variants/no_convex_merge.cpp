// SPDX-License-Identifier: LGPL-3.0-or-later
//
// In place of convex_sum.cpp: two convex polygons are walked round like any others.
#include <utility>

#include "choose.hpp"
#include "convex_sum.hpp"
#include "search.hpp"
#include "walker.hpp"

namespace gcv {

Walk merge_convex(const Boundary& a, const Boundary& b, Tally& tally) {
  const Operands operands{a, b, merge_directions(a, b, tally)};
  const SearchableSuperset superset(operands);
  const VertexSum start{a.lexicographic_min, b.lexicographic_min};
  Task task;
  Arc arc = Walker(operands, Search(superset), superset.slack(), task).arc(start, start);
  arc.walk.vertices.front().arrive_by(arc.last);
  tally += arc.tally;
  return std::move(arc.walk);
}

}  // namespace gcv
