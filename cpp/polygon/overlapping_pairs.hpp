// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Finds the pairs of boxes that overlap. Made for boxes in an order in which neighbours are near,
// such as those of the edges of a ring. Uses a bounding volume hierarchy: a node has up to eight
// children, whose boxes lie side by side and are tested together.
#pragma once

#include <algorithm>
#include <bit>
#include <boost/container/small_vector.hpp>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "box.hpp"
#include "point.hpp"
#include "simd.hpp"
#include "task.hpp"

namespace gcv {

class OverlappingPairs {
 public:
  explicit OverlappingPairs(std::span<const Box> boxes);

  // The boxes of the edges of a closed ring.
  //
  // Neighbours always overlap, so most pairs of neighbours are left out. Let the points of a chain
  // be in lexicographic order: then two of its edges meet only if they are neighbours, in their
  // common vertex. Most pairs within such chains are left out, too.
  //
  // `rounded`: points may be off by up to 2^-22 of their extents. Boxes are made larger for that,
  // and only pairs of neighbours are left out.
  //
  // `bounds` is the bounding box of the ring. It may be off by as much as its extents.
  enum class Points : std::uint8_t { exact, rounded };
  OverlappingPairs(std::span<const Point> ring, const Box& bounds, Points points = Points::exact);

  // A node of level 0 holds up to eight boxes. The one node of the last level holds all boxes.
  [[nodiscard]] std::uint32_t last_level() const { return levels_ - 1; }
  [[nodiscard]] std::uint32_t nodes(std::uint32_t level) const {
    return first_block_[level + 1] - first_block_[level];
  }

  // Calls visit(i, j) for pairs of boxes: at least for all that overlap, and for each pair at most
  // once. One box is in the given node, the other in the same node or in a later one of its level.
  //
  // Returns false if visit() has returned false, or after `most_pairs` pairs of boxes or nodes.
  template <class Visit>
  [[nodiscard]] bool visit_from(std::uint32_t level, std::uint32_t node, std::uint64_t most_pairs,
                                Visit visit) const {
    assert(level < levels_ && node < nodes(level));
    Search<Visit> search{*this, most_pairs, visit};
    if (!search.within(level, node)) {
      return false;
    }
    for (std::uint32_t later = node + 1; later < nodes(level); ++later) {
      const NodeBox box = box_of_node(level, later);
      if (overlap(box_of_node(level, node), box) && !search.between(level, node, later, box)) {
        return false;
      }
    }
    return true;
  }

  // The same for the pairs of all boxes.
  template <class Visit>
  [[nodiscard]] bool visit_some(std::uint64_t most_pairs, Visit visit) const {
    return visit_from(last_level(), 0, most_pairs, visit);
  }
  template <class Visit>
  void visit_all(Visit visit) const {
    const auto visit_and_go_on = [&](std::size_t i, std::size_t j) {
      visit(i, j);
      return true;
    };
    static_cast<void>(visit_some(std::numeric_limits<std::uint64_t>::max(), visit_and_go_on));
  }

 private:
  static constexpr std::uint32_t width = SimdFloat::width;
  static constexpr std::uint32_t most_levels = 11;  // enough for 2^32 boxes

  // The numbers are floats. Coordinates are relative to one point, in a unit that makes the extents
  // about 1. Rounding keeps the order: boxes that are apart in floats are apart. If the extents
  // overflow, all boxes are equal.
  using NodeBox = SimdBox<SimdFloat>;
  static bool overlap(const NodeBox& p, const NodeBox& q) {
    return !(p.x0 > q.x1 || p.x1 < q.x0 || p.y0 > q.y1 || p.y1 < q.y0);
  }

  // The boxes of the children of a node. The box of a missing child holds no point.
  using Block = BoxBlock<SimdFloat, NodeBox>;

  template <class Visit>
  struct Search {
    const OverlappingPairs& pairs;
    std::uint64_t pairs_left;
    Visit& visit;
    Pace pace{};

    // Visits the pairs inside a node.
    bool within(std::uint32_t level, std::uint32_t node) {
      if (pairs.ways(level, node) != 0) {
        return true;
      }
      const Block& block = pairs.block(level, node);
      if (level == 0) {
        return at_distance(node, 1, block.template overlapping_at<1>() & pairs.before_lanes_) &&
               at_distance(node, 2, block.template overlapping_at<2>()) &&
               at_distance(node, 3, block.template overlapping_at<3>()) &&
               at_distance(node, 4, block.template overlapping_at<4>() & 15U);
      }
      const std::uint32_t children = pairs.children(level, node);
      for (std::uint32_t lane = 0; lane < children; ++lane) {
        const std::uint32_t child = width * node + lane;
        if (!with_children(level, child, block, block.box(lane), ~1U << lane, node) ||
            !within(level - 1, child)) {
          return false;
        }
      }
      return true;
    }

    // Visits pairs of boxes in one node of level 0: the box of each given lane, and the box
    // `distance` lanes further on, modulo the width.
    bool at_distance(std::uint32_t node, std::uint32_t distance, unsigned lanes) {
      for (; lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
        const std::uint32_t other = (lane + distance) % width;
        if (pairs_left-- == 0 ||
            !visit(width * node + std::min(lane, other), width * node + std::max(lane, other))) {
          return false;
        }
      }
      return true;
    }

    // Visits the pairs of one box in each of two nodes of a level. `box_of_second` is the box of
    // the second node.
    bool between(std::uint32_t level, std::uint32_t first, std::uint32_t second,
                 const NodeBox& box_of_second) {
      pace.step(width);
      const Block& p = pairs.block(level, first);
      const Block& q = pairs.block(level, second);
      for (unsigned lanes = p.overlapping(box_of_second); lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
        if (!with_children(level, width * first + lane, q, p.box(lane), SimdFloat::all, second)) {
          return false;
        }
      }
      return true;
    }

    // Visits the pairs of one box in a child and another in the children of `node` that `lanes`
    // selects. `child` is a child of a node of the given level; `block` is the block of `node`.
    bool with_children(std::uint32_t level, std::uint32_t child, const Block& block,
                       const NodeBox& box_of_child, unsigned lanes, std::uint32_t node) {
      for (lanes &= block.overlapping(box_of_child); lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
        const std::uint32_t other = width * node + lane;
        if (level > 0 && other == child + 1 &&
            (pairs.ways(level - 1, child) & pairs.ways(level - 1, other)) != 0) {
          continue;
        }
        if (pairs_left-- == 0 ||
            !(level == 0 ? visit(child, other)
                         : between(level - 1, child, other, block.box(lane)))) {
          return false;
        }
      }
      return true;
    }
  };

  class Frame;

  // The ways that all edges of a chain go, as bits. A way is forwards or backwards in lexicographic
  // order, by x first or by y first.
  using Ways = std::uint8_t;
  static constexpr Ways all_ways = 15;

  static Ways ways_of(const PairOfDoubles& from, const PairOfDoubles& to);

  struct alignas(16) Node {
    Block block;
    Ways ways;
  };

  // Builds the tree over so many boxes. fill(block, first, count) writes `count` boxes, from the
  // box `first` on, and returns their ways.
  template <class Fill>
  void build(std::size_t boxes, Fill fill);
  // The same with equal boxes.
  void build_as_one(std::size_t boxes);

  [[nodiscard]] Ways ways(std::uint32_t level, std::uint32_t node) const {
    return nodes_[first_block_[level] + node].ways;
  }
  [[nodiscard]] const Block& block(std::uint32_t level, std::uint32_t node) const {
    return nodes_[first_block_[level] + node].block;
  }
  [[nodiscard]] std::uint32_t children(std::uint32_t level, std::uint32_t node) const {
    const std::uint32_t all = level == 0 ? boxes_ : nodes(level - 1);
    return all - width * node < width ? all - width * node : width;
  }
  // Not for the last level.
  [[nodiscard]] NodeBox box_of_node(std::uint32_t level, std::uint32_t node) const {
    assert(level < last_level());
    return block(level + 1, node / width).box(node % width);
  }

  std::uint32_t boxes_;
  unsigned before_lanes_;  // the lanes whose box may be paired with that of the next lane
  std::uint32_t levels_ = 0;
  std::uint32_t first_block_[most_levels + 1];  // the first block of each level, and the end
  boost::container::small_vector<Node, 32> nodes_;
};

}  // namespace gcv
