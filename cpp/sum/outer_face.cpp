// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The walk starts in lexmin(A) + lexmin(B), which is the sum of those two vertices alone, and ends
// there: the interior of A + B is connected, so the boundary of the unbounded face is one ring that
// visits no point twice.
#include "outer_face.hpp"

#include <boost/container/small_vector.hpp>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "choose.hpp"
#include "convex_sum.hpp"
#include "convolution_cycle.hpp"
#include "cycle_search.hpp"
#include "hull.hpp"
#include "operands_in_range.hpp"
#include "parallel.hpp"
#include "search.hpp"
#include "walker.hpp"

namespace gcv {

namespace {

// The ring of the arcs.
Walk join(std::span<Arc> arcs, Tally& tally) {
  const EdgeName* arriving = &arcs.back().last;
  std::size_t size = 0;
  for (Arc& arc : arcs) {
    arc.walk.vertices.front().arrive_by(*arriving);
    arriving = &arc.last;
    size += arc.walk.vertices.size();
    tally += arc.tally;
  }
  Walk walk = std::move(arcs.front().walk);
  walk.vertices.reserve(size);
  for (std::size_t k = 1; k < arcs.size(); ++k) {
    const Walk& part = arcs[k].walk;
    walk.vertices.insert(walk.vertices.end(), part.vertices.begin(), part.vertices.end());
    walk.steps += part.steps;
    walk.candidates += part.candidates;
  }
  return walk;
}

// Walks from each vertex of the hull to the next one, on several threads where there are several.
template <class MakeSearch>
Walk walk_arcs(const Operands& operands, double slack, Task& task, Tally& tally,
               MakeSearch make_search) {
  const auto starts = hull_vertices(operands.a, operands.b, task.threads());
  boost::container::small_vector<Arc, 1> arcs(starts.size());
  const auto walk_arc = [&](std::size_t k) {
    arcs[k] = Walker(operands, make_search(), slack, task)
                  .arc(starts[k], starts[(k + 1) % starts.size()]);
  };
  for_each_in_parallel(arcs.size(), task.threads(), walk_arc, [&] { task.watch(); });
  return join({arcs.data(), arcs.size()}, tally);
}

}  // namespace

Walk walk_outer_face(const Boundary& a, const Boundary& b, Task& task, Tally& tally) {
  if (a.is_convex && b.is_convex) {
    return merge_convex(a, b, tally);
  }
  const Operands given{a, b, {}};
  const OperandsInRange in_range(given);
  const Operands& unranked = in_range.operands();
  const double slack = slack_of(unranked);
  if (const auto cycle = ConvolutionCycle::find(unranked, tally)) {
    return walk_arcs(unranked, slack, task, tally, [&] { return CycleSearch(unranked, *cycle); });
  }
  const Operands operands{unranked.a, unranked.b, merge_directions(unranked.a, unranked.b, tally)};
  const SearchableSuperset superset(operands);
  Walk walk = walk_arcs(operands, slack, task, tally, [&] { return Search(superset); });
  walk.chains_are_repeated = superset.product() && superset.product()->has_equal_chains();
  return walk;
}

}  // namespace gcv
