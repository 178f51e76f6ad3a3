// SPDX-License-Identifier: LGPL-3.0-or-later
#include "choose.hpp"

#include <cstdint>
#include <utility>

#include "box.hpp"
#include "limits.hpp"

namespace gcv {

namespace {

// Of the sums of an edge of one polygon and a vertex of the other, the share whose boxes hold a sum
// of two vertices: of some of these, spread over both rings. O(n + m).
double share_of_boxes(const Boundary& edges, const Boundary& vertices) {
  constexpr std::uint64_t places = 16;
  const std::uint64_t boxes = 64 + (edges.size() + vertices.size()) / 16;
  // In the middle of one of so many parts of a ring.
  const auto at = [](const Boundary& polygon, std::uint64_t part, std::uint64_t parts) {
    return static_cast<Index>((2 * (part % parts) + 1) * polygon.size() / (2 * parts));
  };
  int held = 0;
  for (std::uint64_t k = 0; k < boxes; ++k) {
    const Index i = at(edges, k, boxes);
    const Point v = vertices.relative(at(vertices, 37 * k, boxes));
    const Box edge = box_of(edges.relative(i), edges.relative(edges.next(i)));
    for (std::uint64_t n = 0; n < places; ++n) {
      const Point p = edges.relative(at(edges, n, places));
      const Point q = vertices.relative(at(vertices, 11 * n + 3, places));
      const Point place{p.x + (q.x - v.x), p.y + (q.y - v.y)};
      held += holds(edge, box_of(place, place)) ? 1 : 0;
    }
  }
  return held / static_cast<double>(boxes * places);
}

// How many of the boxes of the superset edges lie over a place of the sum, on average.
double boxes_over_a_place(const Operands& operands, const SupersetCount& count) {
  return static_cast<double>(count.a) * share_of_boxes(operands.a, operands.b) +
         static_cast<double>(count.b) * share_of_boxes(operands.b, operands.a);
}

// Are the superset edges few enough for a table?
bool suits_table(const Operands& operands, const SupersetCount& count, std::uint64_t vertices) {
  if (count.all() > limits::edges_a_vertex * vertices) {
    return count.all() <= limits::most_table_edges;
  }
  return count.all() <= limits::fewest_edges_to_ask ||
         (count.all() <= limits::most_linear_edges &&
          !(boxes_over_a_place(operands, count) > limits::most_boxes_over_a_place));
}

}  // namespace

SearchableSuperset::SearchableSuperset(const Operands& operands)
    : operands_(operands), slack_(slack_of(operands)) {
  const CoarseGrid grid(operands);
  std::optional<RankedEdges> ranked;
  // At least: a vertex contributes to every edge.
  const std::uint64_t vertices = std::uint64_t{operands.a.size()} + operands.b.size();
  SupersetCount count{};
  if (vertices <= limits::most_linear_edges && grid.is_fine_enough(operands)) {
    ranked.emplace(operands.directions);
    count = count_superset(operands, *ranked);
  }
  const bool is_small = ranked && suits_table(operands, count, vertices);
  EqualChains chains;
  if (!is_small || chains_can_prevail(operands)) {
    chains = find_equal_chains(operands);
  }
  if (is_small && !chains.prevail) {
    table_.emplace(operands, grid, *ranked, count.all());
  } else {
    product_.emplace(operands, std::move(chains));
  }
}

}  // namespace gcv
