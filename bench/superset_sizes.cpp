// SPDX-License-Identifier: LGPL-3.0-or-later
#include "superset_sizes.hpp"

#include "contributions.hpp"
#include "superset.hpp"

namespace gcv::bench {

namespace {

// Adds the edges of one polygon that the turns of the other one hold. Of its two ends, a turn has
// only one: the clockwise one or the other.
void add_turns(const EdgesByRank& edges, const gcv::Boundary& polygon, const Ranks& ranks,
               bool has_clockwise_end, SupersetSizes& sizes) {
  const auto count = [&](Rank from, Rank to) -> std::uint64_t {
    const Rank missing = has_clockwise_end ? to : from;
    return edges.count(from, to) - edges.count(missing, missing);
  };
  for (Index v = 0; v < polygon.size(); ++v) {
    const Rank in = ranks[polygon.previous(v)];
    const Rank out = ranks[v];
    const std::uint64_t to_the_left = count(in, out);
    const bool is_convex = polygon.corners[v].convex;
    sizes.full_convolution += to_the_left;
    sizes.convolution_cycles += is_convex ? to_the_left : count(out, in);
    sizes.reduced_convolution += is_convex ? to_the_left : 0;
  }
}

}  // namespace

SupersetSizes superset_sizes(const Ring& a, const Ring& b) {
  const gcv::Boundary p = make_ring(a, "a");
  const gcv::Boundary q = make_ring(b, "b");
  Tally tally;
  const Operands operands{p, q, merge_directions(p, q, tally)};
  const RankedEdges ranked(operands.directions);
  SupersetSizes sizes{.all_pairs = 2 * std::uint64_t{p.size()} * q.size()};
  add_turns(ranked.a, q, operands.directions.rank_b, true, sizes);
  add_turns(ranked.b, p, operands.directions.rank_a, false, sizes);
  sizes.gcv = enumerate_superset(operands).size();
  return sizes;
}

}  // namespace gcv::bench
