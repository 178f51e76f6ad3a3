// SPDX-License-Identifier: LGPL-3.0-or-later
#include "directions.hpp"

#include <algorithm>
#include <span>

#include "direction_key.hpp"
#include "predicates.hpp"
#include "task.hpp"

namespace gcv {

namespace {

// 1 where line direction la of A comes before lb of B, -1 where it comes after it, 0 where they are
// the same.
int compare_lines(const Boundary& a, const LineDirections::Line& la, const Boundary& b,
                  const LineDirections::Line& lb, Tally& tally) {
  if (const int order = compare_keys(la.key, lb.key)) {
    ++tally.filtered;
    return order;
  }
  const auto of_a = a.line_direction(la.edge);
  const auto of_b = b.line_direction(lb.edge);
  return turn(of_a.from, of_a.to, of_b.from, of_b.to, tally);
}

Ranks ranks_of(std::span<const LineDirections::Edge> edges, const Rank* rank_of_line,
               Rank half_turn) {
  Ranks ranks(edges.size(), boost::container::default_init);
  std::transform(edges.begin(), edges.end(), ranks.begin(), [=](const LineDirections::Edge& edge) {
    return rank_of_line[edge.line] + (edge.points_up ? 0 : half_turn);
  });
  return ranks;
}

}  // namespace

Directions merge_directions(const Boundary& a, const Boundary& b, Tally& tally) {
  const LineDirections& of_a = a.line_directions();
  const LineDirections& of_b = b.line_directions();
  const auto lines_a = static_cast<Index>(of_a.lines.size());
  const auto lines_b = static_cast<Index>(of_b.lines.size());
  boost::container::small_vector<Rank, 64> rank_of_line(std::size_t{lines_a} + lines_b,
                                                        boost::container::default_init);
  Rank* const rank_of_line_a = rank_of_line.data();
  Rank* const rank_of_line_b = rank_of_line_a + lines_a;
  Rank rank = 0;
  Index la = 0;
  Index lb = 0;
  Pace pace;
  for (; la < lines_a || lb < lines_b; ++rank) {
    pace.step();
    const int order = la == lines_a   ? -1
                      : lb == lines_b ? 1
                                      : compare_lines(a, of_a.lines[la], b, of_b.lines[lb], tally);
    if (order >= 0) {
      rank_of_line_a[la++] = rank;
    }
    if (order <= 0) {
      rank_of_line_b[lb++] = rank;
    }
  }
  return {rank, ranks_of(of_a.edges, rank_of_line_a, rank),
          ranks_of(of_b.edges, rank_of_line_b, rank)};
}

}  // namespace gcv
