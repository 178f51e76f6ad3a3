// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Descends the trees of two placed polygons at once, to the pairs of edges that come near each
// other.
#pragma once

#include "box_nodes.hpp"

namespace gcv {

// Calls visit(i, j) for the pairs of edges whose boxes meet or nearly do: at least those of edges
// that have a point in common. Stops when it returns true. Returns what the last call returned.
template <class Visit>
class NearPairs {
 public:
  NearPairs(const PlacedPair& placed, Visit visit)
      : a_(placed.pair.tree_a.tree),
        b_(placed.pair.tree_b.tree),
        offset_(placed.offset()),
        slack_(placed.pair.slack),
        visit_(visit) {}

  bool run() {
    const Box box = widened(moved(b_.box, offset_), slack_);
    return !are_apart(a_.box, box) && descend({{0, 0}, a_.box}, {{0, 0}, box});
  }

 private:
  // The box of `a` is that of its tree, the box of `b` is moved and widened.
  bool descend(const BoxedNode& a, const BoxedNode& b) {
    const bool a_is_edge = a_.is_edge(a.node);
    const bool b_is_edge = b_.is_edge(b.node);
    if (a_is_edge && b_is_edge) {
      return visit_(a.node.index, b.node.index);
    }
    if (b_is_edge || (!a_is_edge && extent(a.box) >= extent(b.box))) {
      const ChainTree::Block& block = a_.blocks[a_.block_below(a.node)];
      for (unsigned lanes = block.overlapping(b.box); lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
        if (has_child(block, lane) &&
            descend({ChainTree::child(a.node, lane), block.box(lane)}, b)) {
          return true;
        }
      }
      return false;
    }
    const ChainTree::Block& block = b_.blocks[b_.block_below(b.node)];
    const Box around = widened(moved(a.box, {-offset_.x, -offset_.y}), slack_);
    for (unsigned lanes = block.overlapping(around); lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
      const Box box = widened(moved(block.box(lane), offset_), slack_);
      if (has_child(block, lane) && descend(a, {ChainTree::child(b.node, lane), box})) {
        return true;
      }
    }
    return false;
  }

  const ChainTree& a_;
  const ChainTree& b_;
  const Point offset_;
  const double slack_;
  Visit visit_;
};

// Do pairs of near edges make visit(i, j) return true?
template <class Visit>
bool any_near_pair(const PlacedPair& placed, Visit visit) {
  return NearPairs<Visit>(placed, visit).run();
}

}  // namespace gcv
