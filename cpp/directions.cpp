// SPDX-License-Identifier: LGPL-3.0-or-later
#include "directions.hpp"

namespace gcv {

namespace {

// The sign of the turn from line direction `la` of A to line direction `lb` of B, both
// taken at angles in [0, pi).
int compare_lines(const Polygon& a, Index la, const Polygon& b, Index lb, Tally& tally) {
  const Index i = a.edge_of_line[la];
  const Index j = b.edge_of_line[lb];
  const Index i1 = a.next(i);
  const Index j1 = b.next(j);
  // Both taken as they point up.
  return turn(a.vertices[a.upper[i] != 0 ? i : i1], a.vertices[a.upper[i] != 0 ? i1 : i],
              b.vertices[b.upper[j] != 0 ? j : j1], b.vertices[b.upper[j] != 0 ? j1 : j], tally);
}

Ranks ranks_of(const Polygon& polygon, const Rank* rank_of_line, Rank half_turn) {
  Ranks result(polygon.size(), boost::container::default_init);
  for (Index i = 0; i < polygon.size(); ++i) {
    result[i] = rank_of_line[polygon.line_of_edge[i]] + (polygon.upper[i] != 0 ? 0 : half_turn);
  }
  return result;
}

}  // namespace

Directions merge_directions(const Polygon& a, const Polygon& b, Tally& tally) {
  const auto lines_a = static_cast<Index>(a.edge_of_line.size());
  const auto lines_b = static_cast<Index>(b.edge_of_line.size());
  boost::container::small_vector<Rank, 64> rank_of_line(std::size_t{lines_a} + lines_b,
                                                        boost::container::default_init);
  Rank* const rank_of_line_a = rank_of_line.data();
  Rank* const rank_of_line_b = rank_of_line_a + lines_a;
  Rank rank = 0;
  Index la = 0;
  Index lb = 0;
  for (; la < lines_a || lb < lines_b; ++rank) {
    const int order = la == lines_a ? -1 : lb == lines_b ? 1 : compare_lines(a, la, b, lb, tally);
    if (order >= 0) {
      rank_of_line_a[la++] = rank;
    }
    if (order <= 0) {
      rank_of_line_b[lb++] = rank;
    }
  }
  return {rank, ranks_of(a, rank_of_line_a, rank), ranks_of(b, rank_of_line_b, rank)};
}

}  // namespace gcv
