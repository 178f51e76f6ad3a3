// SPDX-License-Identifier: LGPL-3.0-or-later
#include "point_in_polygon.hpp"

#include "pair_descent.hpp"

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
  for_each_lane(block.overlapping(ray) & children_of(block), [&](std::uint32_t lane) {
    for_each_edge_on_ray(tree, ChainTree::child(node, lane), ray, visit);
  });
}

}  // namespace

bool holds(const PlacedPolygon& polygon, const SumPoint& point, const Point& relative, double slack,
           Tally& tally) {
  const Box ray{relative.x - slack, relative.y - slack, std::numeric_limits<double>::infinity(),
                relative.y + slack};
  if (are_apart(polygon.tree.box, ray)) {
    return false;
  }
  bool is_inside = false;
  const auto is_above = [&](Index i) {
    const SumPoint vertex = polygon.vertex(i);
    return compare_sums(vertex.a.y, vertex.b.y, point.a.y, point.b.y, tally) > 0;
  };
  for_each_edge_on_ray(polygon.tree, {0, 0}, ray, [&](Index i) {
    const bool starts_above = is_above(i);
    if (starts_above != is_above(polygon.next(i))) {
      is_inside = is_inside != (side(polygon.edge(i), point, tally) == (starts_above ? -1 : 1));
    }
  });
  return is_inside;
}

}  // namespace gcv
