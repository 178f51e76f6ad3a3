// SPDX-License-Identifier: LGPL-3.0-or-later
#include "directions.hpp"

#include "direction_key.hpp"

namespace gcv {

namespace {

// A line direction, at an angle in [0, pi), as that from one point to another.
struct LineDirection {
  const Point& from;
  const Point& to;
};

LineDirection line_direction(const Polygon& polygon, Index line) {
  const Index i = polygon.lines[line].edge;
  const Point& start = polygon.vertices[i];
  const Point& end = polygon.vertices[polygon.next(i)];
  return polygon.corners[i].upper ? LineDirection{start, end} : LineDirection{end, start};
}

// 1 where line direction la of A comes before lb of B, -1 where it comes after it, 0 where they are
// the same.
int compare_lines(const Polygon& a, Index la, const Polygon& b, Index lb, Tally& tally) {
  if (const int order = compare_keys(a.lines[la].key, b.lines[lb].key)) {
    ++tally.filtered;
    return order;
  }
  const LineDirection of_a = line_direction(a, la);
  const LineDirection of_b = line_direction(b, lb);
  return turn(of_a.from, of_a.to, of_b.from, of_b.to, tally);
}

Ranks ranks_of(const Polygon& polygon, const Rank* rank_of_line, Rank half_turn) {
  Ranks result(polygon.size(), boost::container::default_init);
  for (Index i = 0; i < polygon.size(); ++i) {
    result[i] = rank_of_line[polygon.corners[i].line] + (polygon.corners[i].upper ? 0 : half_turn);
  }
  return result;
}

}  // namespace

Directions merge_directions(const Polygon& a, const Polygon& b, Tally& tally) {
  const auto lines_a = static_cast<Index>(a.lines.size());
  const auto lines_b = static_cast<Index>(b.lines.size());
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
