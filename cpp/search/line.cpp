// SPDX-License-Identifier: LGPL-3.0-or-later
#include "line.hpp"

#include <span>

#include "predicates.hpp"

namespace gcv {

namespace {

OffsetClasses::Direction direction_of(const Operands& operands, const PairEdge& edge) {
  const auto [from, to] = operands.source(edge);
  return {from, to, edge.rank};
}

}  // namespace

LineSearch::LineSearch(const Operands& operands, const PairEdge& edge)
    : operands_(operands),
      direction_(direction_of(operands, edge)),
      a_(operands.a, operands.directions.rank_a, operands.directions, direction_),
      b_(operands.b, operands.directions.rank_b, operands.directions, direction_),
      is_valid_(a_.is_valid() && b_.is_valid()) {}

// As the class of A goes to the left, that of B whose sums lie on the line goes to the right.
void LineSearch::go_to(const PairEdge& edge) {
  const SumEdge line = coordinates(operands_.a, operands_.b, edge);
  Tally tally;
  right_of_b_.resize(a_.size());
  matches_.clear();
  Index right = b_.size();
  for (Index k = 0; k < a_.size(); ++k) {
    const Index i = a_.representative(k);
    int order = -1;
    while (right > 0 &&
           (order = side(line, operands_.point({i, b_.representative(right - 1)}), tally)) >= 0) {
      --right;
      if (order == 0) {
        matches_.push_back({k, right});
      }
    }
    right_of_b_[k] = right;
  }
}

// An edge of one polygon and the vertices of a class of the other make superset edges as long as
// the edge. From the last of them that starts before the place or there, they follow each other
// without a gap as long as the vertices are no further from each other than that length.
template <bool a_has_edges>
bool LineSearch::extend(const OffsetClasses& of_edges, Index edge_class,
                        const OffsetClasses& of_vertices, Index vertex_class,
                        VertexSum& place) const {
  const std::span<const Index> vertices = of_vertices.contributing(vertex_class);
  if (vertices.empty()) {
    return false;
  }
  const Boundary& polygon = a_has_edges ? operands_.a : operands_.b;
  Tally tally;
  bool is_further = false;
  double first = a_.along(place.i);
  double second = b_.along(place.j);
  for (const Index edge : of_edges.edges(edge_class)) {
    const double start = of_edges.along(edge);
    const double end = of_edges.along(polygon.next(edge));
    const auto behind = std::partition_point(vertices.begin(), vertices.end(), [&](Index v) {
      return compare_sums(start, of_vertices.along(v), first, second, tally) <= 0;
    });
    if (behind == vertices.begin()) {
      continue;
    }
    const auto k = static_cast<std::size_t>(behind - vertices.begin()) - 1;
    const Index last = vertices[of_vertices.last_within(vertex_class, k, Gap::between(start, end))];
    if (compare_sums(end, of_vertices.along(last), first, second, tally) > 0) {
      is_further = true;
      const Index edge_end = polygon.next(edge);
      place = a_has_edges ? VertexSum{edge_end, last} : VertexSum{last, edge_end};
      first = a_.along(place.i);
      second = b_.along(place.j);
    }
  }
  return is_further;
}

VertexSum LineSearch::reach(VertexSum place) const {
  bool is_further = is_valid_;
  while (is_further) {
    is_further = false;
    for (const Match& match : matches_) {
      is_further = extend<true>(a_, match.a, b_, match.b, place) || is_further;
      is_further = extend<false>(b_, match.b, a_, match.a, place) || is_further;
    }
  }
  return place;
}

}  // namespace gcv
