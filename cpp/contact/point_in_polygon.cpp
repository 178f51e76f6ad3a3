// SPDX-License-Identifier: LGPL-3.0-or-later
#include "point_in_polygon.hpp"

#include "box_nodes.hpp"

namespace gcv {

namespace {

// Calls visit(edge) for the edges whose boxes the ray from p to the right may meet.
template <class Visit>
void for_each_edge_on_ray(const ChainTree& tree, const ChainTree::Node& node, const Box& ray,
                          const Visit& visit) {
  if (tree.is_edge(node)) {
    visit(node.index);
    return;
  }
  const ChainTree::Block& block = tree.blocks[tree.block_below(node)];
  for_each_lane(block.overlapping(ray), [&](std::uint32_t lane) {
    if (has_child(block, lane)) {
      for_each_edge_on_ray(tree, ChainTree::child(node, lane), ray, visit);
    }
  });
}

// The point p, seen from the first vertex of the polygon, is `relative`. place(vertex) and
// edge(vertex) are where the vertices and edges of the polygon are.
template <class Place, class Edge>
bool holds(const Boundary& polygon, const ChainTree& tree, double slack, const Point& relative,
           const SumPoint& p, Place place, Edge edge, Tally& tally) {
  const Box ray{relative.x - slack, relative.y - slack, std::numeric_limits<double>::infinity(),
                relative.y + slack};
  if (are_apart(tree.box, ray)) {
    return false;
  }
  bool is_inside = false;
  const auto is_above = [&](Index i) {
    const SumPoint vertex = place(i);
    return compare_sums(vertex.a.y, vertex.b.y, p.a.y, p.b.y, tally) > 0;
  };
  for_each_edge_on_ray(tree, {0, 0}, ray, [&](Index i) {
    const bool starts_above = is_above(i);
    if (starts_above != is_above(polygon.next(i))) {
      is_inside = is_inside != (side(edge(i), p, tally) == (starts_above ? -1 : 1));
    }
  });
  return is_inside;
}

}  // namespace

bool a_holds_b(const PlacedPair& placed, Tally& tally) {
  return holds(
      placed.a, placed.pair.tree_a.tree, placed.pair.slack, placed.offset(), placed.vertex_of_b(0),
      [&](Index i) { return placed.vertex_of_a(i); }, [&](Index i) { return placed.edge_of_a(i); },
      tally);
}

bool b_holds_a(const PlacedPair& placed, Tally& tally) {
  const Point offset = placed.offset();
  return holds(
      placed.b, placed.pair.tree_b.tree, placed.pair.slack, {-offset.x, -offset.y},
      placed.vertex_of_a(0), [&](Index j) { return placed.vertex_of_b(j); },
      [&](Index j) { return placed.edge_of_b(j); }, tally);
}

}  // namespace gcv
