// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Which edges of one polygon the vertices of the other contribute to (the paper, Definition
// 1): for each convex vertex, the edges whose ranks lie in its cone.
#pragma once

#include <boost/container/small_vector.hpp>
#include <cstddef>

#include "boundary.hpp"
#include "contributing_vertices.hpp"
#include "directions.hpp"

namespace gcv {

// The edges of a polygon in the order of their ranks.
class EdgesByRank {
 public:
  EdgesByRank(const Ranks& ranks, Rank half_turn)
      : first_(2 * std::size_t{half_turn} + 1), edges_(ranks.size()) {
    for (const Rank rank : ranks) {
      ++first_[rank];
    }
    for (std::size_t rank = 1; rank < first_.size(); ++rank) {
      first_[rank] += first_[rank - 1];
    }
    // Backwards from the ends, so that first_ comes to be what it says.
    for (std::size_t edge = ranks.size(); edge-- > 0;) {
      edges_[--first_[ranks[edge]]] = static_cast<Index>(edge);
    }
  }

  // How many edges have ranks from `in` counter-clockwise to `out`.
  [[nodiscard]] std::size_t count(Rank in, Rank out) const {
    return in <= out ? first_[out + 1] - first_[in] : edges_.size() - first_[in] + first_[out + 1];
  }

  // Calls visit(edge) for each of them.
  template <class Visit>
  void for_each(Rank in, Rank out, Visit visit) const {
    const std::size_t end = in <= out ? first_[out + 1] : edges_.size();
    for (std::size_t k = first_[in]; k < end; ++k) {
      visit(edges_[k]);
    }
    if (in > out) {  // the cone holds the positive x axis
      for (std::size_t k = 0; k < first_[out + 1]; ++k) {
        visit(edges_[k]);
      }
    }
  }

 private:
  boost::container::small_vector<Index, 64> first_;  // place of the first edge of each rank
  boost::container::small_vector<Index, 32> edges_;
};

// Those of both polygons.
struct RankedEdges {
  explicit RankedEdges(const Directions& directions)
      : a(directions.rank_a, directions.half_turn), b(directions.rank_b, directions.half_turn) {}

  EdgesByRank a;
  EdgesByRank b;
};

// Calls visit(vertex, in, out) for each convex vertex of a polygon, with its cone.
template <class Visit>
void for_each_cone(const Boundary& polygon, const Ranks& ranks, Visit visit) {
  for (Index ring = 0; ring < polygon.layout.ring_count(); ++ring) {
    const Index end = polygon.layout.end(ring);
    Index previous = end - 1;
    for (Index v = polygon.layout.begin(ring); v < end; ++v) {
      if (polygon.corners[v].convex) {
        visit(v, ranks[previous], ranks[v]);
      }
      previous = v;
    }
  }
}

}  // namespace gcv
