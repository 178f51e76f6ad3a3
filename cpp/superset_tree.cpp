// SPDX-License-Identifier: LGPL-3.0-or-later
#include "superset_tree.hpp"

#include <algorithm>

namespace gcv {

namespace {

std::uint64_t count_contributions(const EdgesByRank& edges, const Polygon& polygon,
                                  const std::vector<Rank>& ranks) {
  std::uint64_t count = 0;
  for_each_cone(polygon, ranks,
                [&](Index /*v*/, Rank in, Rank out) { count += edges.count(in, out); });
  return count;
}

// Points in the order of a Z-shaped curve (Morton, 1966), in which neighbours are near.
class ZOrder {
 public:
  explicit ZOrder(const Box& box)
      : box_(box), cells_x_(cells / (box.x1 - box.x0)), cells_y_(cells / (box.y1 - box.y0)) {}

  [[nodiscard]] std::uint32_t key(const Point& p) const {
    return spread(cell((p.x - box_.x0) * cells_x_)) | spread(cell((p.y - box_.y0) * cells_y_))
                                                          << 1U;
  }

 private:
  static constexpr double cells = 65535;

  // Where numbers have overflowed, any order will do.
  static std::uint32_t cell(double x) {
    return x > 0 && x <= cells ? static_cast<std::uint32_t>(x) : 0;
  }
  // The bits of a number below 2^16, with zeros between them.
  static std::uint32_t spread(std::uint32_t x) {
    x = (x | x << 8U) & 0x00ff00ffU;
    x = (x | x << 4U) & 0x0f0f0f0fU;
    x = (x | x << 2U) & 0x33333333U;
    return (x | x << 1U) & 0x55555555U;
  }

  Box box_;
  double cells_x_;
  double cells_y_;
};

Point sum(const Point& p, const Point& q) { return {p.x + q.x, p.y + q.y}; }

Box box_of_edge(const Operands& operands, const PairEdge& e) {
  const Polygon& a = operands.a;
  const Polygon& b = operands.b;
  const bool translated = e.kind == PairEdge::translated;
  return box_of(
      sum(a.relative[e.i], b.relative[e.j]),
      sum(a.relative[translated ? a.next(e.i) : e.i], b.relative[translated ? e.j : b.next(e.j)]));
}

}  // namespace

std::uint64_t count_superset(const Operands& operands, const RankedEdges& ranked) {
  return count_contributions(ranked.a, operands.b, operands.directions.rank_b) +
         count_contributions(ranked.b, operands.a, operands.directions.rank_a);
}

SupersetTree::SupersetTree(const Operands& operands, const RankedEdges& ranked) {
  std::vector<PairEdge> edges;
  edges.reserve(count_superset(operands, ranked));
  for_each_cone(operands.b, operands.directions.rank_b, [&](Index j, Rank in, Rank out) {
    ranked.a.for_each(in, out, [&](Index i) { edges.push_back({PairEdge::translated, i, j}); });
  });
  for_each_cone(operands.a, operands.directions.rank_a, [&](Index i, Rank in, Rank out) {
    ranked.b.for_each(in, out, [&](Index j) { edges.push_back({PairEdge::corner, i, j}); });
  });
  const Box& box_a = operands.a.tree.box;
  const Box& box_b = operands.b.tree.box;
  const ZOrder order(
      {box_a.x0 + box_b.x0, box_a.y0 + box_b.y0, box_a.x1 + box_b.x1, box_a.y1 + box_b.y1});
  std::vector<Box> boxes;
  std::vector<std::uint64_t> keys;  // with the number of the edge
  boxes.reserve(edges.size());
  keys.reserve(edges.size());
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const Box box = box_of_edge(operands, edges[k]);
    boxes.push_back(box);
    const Point middle{box.x0 + (box.x1 - box.x0) / 2, box.y0 + (box.y1 - box.y0) / 2};
    keys.push_back(std::uint64_t{order.key(middle)} << 32U | k);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<Box> ordered;
  ordered.reserve(edges.size());
  edges_.reserve(edges.size());
  for (const std::uint64_t key : keys) {
    const std::uint64_t k = key & 0xffffffffU;
    edges_.push_back(edges[k]);
    ordered.push_back(boxes[k]);
  }
  tree_ = build_chain_tree(ordered);
}

}  // namespace gcv
