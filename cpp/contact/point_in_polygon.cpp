// SPDX-License-Identifier: LGPL-3.0-or-later
#include "point_in_polygon.hpp"

#include <algorithm>

#include "pair_descent.hpp"

namespace gcv {

namespace {

// Follows the ray from a point to the right. An edge with one end above the ray, and one on or
// below it, crosses the line of the ray.
class Ray {
 public:
  Ray(const PlacedPolygon& polygon, const SumPoint& point, const Point& relative, double slack,
      Tally& tally)
      : polygon_(polygon),
        tree_(polygon.tree()),
        point_(point),
        box_{relative.x - slack, relative.y - slack, infinity, relative.y + slack},
        right_(relative.x + slack),
        tally_(tally) {}

  // Does the ray cross the edges of the polygon an odd number of times?
  bool crosses_oddly() { return !are_apart(tree_.box, box_) && crosses_oddly({0, 0}, tree_.box); }

 private:
  // The same for the edges below a node. If all of a chain is to the right of the point, its ends
  // tell.
  bool crosses_oddly(const ChainTree::Node& node, const Box& box) {
    const bool is_edge = tree_.is_edge(node);
    const bool is_right = box.x0 > right_;
    if (is_edge || is_right) {
      const Index first = tree_.first_edge(node);
      const Index last = is_edge ? first : last_edge(node);
      if (is_edge || is_on_one_ring(first, last)) {
        const bool starts_above = is_above(first);
        return starts_above != is_above(polygon_.next(last)) &&
               (is_right || side(polygon_.edge(first), point_, tally_) == (starts_above ? -1 : 1));
      }
    }
    const ChainTree::Block& block = tree_.blocks[tree_.block_below(node)];
    bool is_odd = false;
    for_each_lane(block.overlapping(box_) & children_of(block), [&](std::uint32_t lane) {
      is_odd = is_odd != crosses_oddly(ChainTree::child(node, lane), block.box(lane));
    });
    return is_odd;
  }

  // The last edge below a node.
  [[nodiscard]] Index last_edge(const ChainTree::Node& node) const {
    const ChainTree::Node next{node.depth, node.index + 1};
    const Index end = polygon_.boundary.size();
    // The node may be the last one, and the one behind it beyond the range of numbers.
    const Index first = tree_.first_edge(node);
    const Index behind = tree_.first_edge(next);
    return (behind > first ? std::min(behind, end) : end) - 1;
  }
  [[nodiscard]] bool is_on_one_ring(Index first, Index last) const {
    const RingLayout& layout = polygon_.boundary.layout;
    return layout.ring_of(first) == layout.ring_of(last);
  }
  bool is_above(Index i) {
    const SumPoint vertex = polygon_.vertex(i);
    return compare_sums(vertex.a.y, vertex.b.y, point_.a.y, point_.b.y, tally_) > 0;
  }

  const PlacedPolygon& polygon_;
  const ChainTree& tree_;
  const SumPoint& point_;
  const Box box_;
  const double right_;  // what is further right is so exactly
  Tally& tally_;
};

}  // namespace

bool holds(const PlacedPolygon& polygon, const SumPoint& point, const Point& relative, double slack,
           Tally& tally) {
  return Ray(polygon, point, relative, slack, tally).crosses_oddly() != polygon.is_complement();
}

}  // namespace gcv
