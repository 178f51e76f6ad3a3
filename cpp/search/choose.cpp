// SPDX-License-Identifier: LGPL-3.0-or-later
#include "choose.hpp"

#include <cmath>
#include <cstdint>
#include <utility>

#include "box.hpp"
#include "limits.hpp"

namespace gcv {

namespace {

// Of the boxes of a polygon's edges, the mean area.
double mean_box_of_edges(const Boundary& polygon) {
  double sum = 0;
  polygon.layout.for_each_edge([&](Index i, Index next) {
    const Point& p = polygon.vertices[i];
    const Point& q = polygon.vertices[next];
    sum += std::abs((q.x - p.x) * (q.y - p.y));
  });
  return sum / polygon.size();
}

// How many of the boxes of the superset edges lie over a place of the sum, on average.
double boxes_over_a_place(const Operands& operands, const SupersetCount& count) {
  const Box& a = operands.a.bounds;
  const Box& b = operands.b.bounds;
  const double area = ((a.x1 - a.x0) + (b.x1 - b.x0)) * ((a.y1 - a.y0) + (b.y1 - b.y0));
  return (static_cast<double>(count.a) * mean_box_of_edges(operands.a) +
          static_cast<double>(count.b) * mean_box_of_edges(operands.b)) /
         area;
}

// Of the sums of an edge of one polygon and a vertex of the other, the share whose boxes hold the
// middle of one: of some of these, spread over both rings by multiples of the golden ratio (Weyl,
// 1916). O(n + m).
double share_of_boxes(const Boundary& edges, const Boundary& vertices) {
  constexpr std::uint64_t places = 8;
  const std::uint64_t boxes = 32 + (edges.size() + vertices.size()) / 16;
  // In the middle of one of so many parts of the ring.
  const auto edge_at = [&](std::uint64_t part, std::uint64_t parts) {
    const auto i = static_cast<Index>((2 * part + 1) * edges.size() / (2 * parts));
    return box_of(edges.relative(i), edges.relative(edges.next(i)));
  };
  const auto vertex_at = [&](std::uint64_t k) {
    const auto part = static_cast<std::uint32_t>(k * 0x9e3779b9U);  // of 2^32
    return vertices.relative(static_cast<Index>(std::uint64_t{part} * vertices.size() >> 32U));
  };
  int held = 0;
  for (std::uint64_t n = 0; n < places; ++n) {
    const Box edge = edge_at(n, places);
    const Point q = vertex_at(boxes + n);
    const Point middle{(edge.x0 + edge.x1) / 2 + q.x, (edge.y0 + edge.y1) / 2 + q.y};
    for (std::uint64_t k = 0; k < boxes; ++k) {
      const Point v = vertex_at(k);
      const Point place{middle.x - v.x, middle.y - v.y};
      held += holds(edge_at(k, boxes), box_of(place, place)) ? 1 : 0;
    }
  }
  return held / static_cast<double>(boxes * places);
}

// How many of the boxes of the superset edges lie over a place on one of them, on average: many,
// where all of them lie along a curve.
double boxes_over_an_edge(const Operands& operands, const SupersetCount& count) {
  return static_cast<double>(count.a) * share_of_boxes(operands.a, operands.b) +
         static_cast<double>(count.b) * share_of_boxes(operands.b, operands.a);
}

// Are the superset edges few enough for a table?
bool suits_table(const Operands& operands, const SupersetCount& count, std::uint64_t vertices) {
  if (count.all() > limits::edges_a_vertex * vertices) {
    return count.all() <= limits::most_table_edges;
  }
  return count.all() <= limits::most_boxes_over_a_place ||
         (count.all() <= limits::most_linear_edges &&
          !(boxes_over_a_place(operands, count) > limits::most_boxes_over_a_place) &&
          !(count.all() > limits::fewest_edges_to_sample &&
            boxes_over_an_edge(operands, count) > limits::most_boxes_over_a_place));
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
