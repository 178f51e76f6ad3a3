// SPDX-License-Identifier: LGPL-3.0-or-later
//
// All superset edges in a tree of boxes. Where they are few, that is soon built, and a search
// in it takes a fraction of one in the implicit superset.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "contributing_vertices.hpp"
#include "contributions.hpp"
#include "lanes.hpp"
#include "point.hpp"

namespace gcv {

// How many superset edges there are, before merging. O(n + m).
std::uint64_t count_superset(const Operands& operands, const RankedEdges& ranked);

class SupersetTree {
 public:
  static constexpr std::uint64_t most_edges = 16384;

  // For so many edges as count_superset() says, most_edges at most. O(n + m + edges).
  SupersetTree(const Operands& operands, const RankedEdges& ranked, std::size_t size);

  // The boxes of the children of one node, in the unit of the tree. Those that are missing hold
  // no point.
  struct Block {
    enum Side : std::uint8_t { x_low, y_low, x_high, y_high };
    float sides[4][EightLanes::width];

    [[nodiscard]] EightLanes lanes(Side side) const { return EightLanes::load(sides[side]); }
  };

  // A piece of an edge, from `from` to `to` in relative coordinates, as a place to search.
  //
  // The unit of the tree is a power of two from the extents of the sum on: in it, all coordinates
  // are 1 at most. With v = 2^-24, half the distance from 1 to the next float: a side of a box, the
  // sum of two floats, is off by 3v, an end of the piece by v, and `slack` is 32v. The direction of
  // the edge, its larger part being 1, is off by v, so that an offset from its line, at most 2
  // away, is off by 2v for the direction, 6v for the point and 8v for products and sums; `slack`
  // is more.
  class Piece {
   public:
    Piece(const SupersetTree& tree, const SumEdge& s, const Point& origin, const Point& from,
          const Point& to)
        : scale_(tree.scale_), from_(from) {
      const double size = std::max(std::abs(s.dx), std::abs(s.dy));
      dx_ = static_cast<float>(s.dx / size);
      dy_ = static_cast<float>(s.dy / size);
      offset_ =
          static_cast<float>(double{dx_} * (origin.y * scale_) - double{dy_} * (origin.x * scale_));
      ascends_ = std::abs(dx_) > std::abs(dy_) ? dx_ > 0 : dy_ > 0;
      near_x_ = dy_ > 0 ? Block::x_low : Block::x_high;
      far_x_ = dy_ > 0 ? Block::x_high : Block::x_low;
      near_y_ = dx_ > 0 ? Block::y_low : Block::y_high;
      far_y_ = dx_ > 0 ? Block::y_high : Block::y_low;
      shorten(to);
    }

    void shorten(const Point& to) {
      x_low_ = scaled(std::min(from_.x, to.x)) - slack;
      y_low_ = scaled(std::min(from_.y, to.y)) - slack;
      x_high_ = scaled(std::max(from_.x, to.x)) + slack;
      y_high_ = scaled(std::max(from_.y, to.y)) + slack;
    }

    // The lanes whose boxes reach that of the piece, and the line of the edge or both of its
    // sides.
    [[nodiscard]] unsigned overlapping(const Block& block) const {
      const EightLanes offset_high = dx_ * block.lanes(far_y_) - dy_ * block.lanes(near_x_);
      const EightLanes offset_low = dx_ * block.lanes(near_y_) - dy_ * block.lanes(far_x_);
      const EightMask apart =
          (block.lanes(Block::x_low) > x_high_) | (block.lanes(Block::x_high) < x_low_) |
          (block.lanes(Block::y_low) > y_high_) | (block.lanes(Block::y_high) < y_low_) |
          (offset_high < offset_ - slack) | (offset_low > offset_ + slack);
      return ~apart.bits() & EightLanes::all;
    }

    // Are boxes with larger coordinates to come last?
    [[nodiscard]] bool ascends() const { return ascends_; }

   private:
    static constexpr float slack = 0x1p-19F;

    [[nodiscard]] float scaled(double x) const { return static_cast<float>(x * scale_); }

    double scale_;
    Point from_;
    float dx_;
    float dy_;
    float offset_;  // of the line of the edge, from the relative origin
    float x_low_ = 0;
    float y_low_ = 0;
    float x_high_ = 0;
    float y_high_ = 0;
    Block::Side near_x_;  // where the offsets are largest
    Block::Side far_x_;
    Block::Side near_y_;
    Block::Side far_y_;
    bool ascends_;
  };

  // Calls visit(edge) for superset edges, among them all that have a point in the piece, which
  // visit() may shorten.
  template <class Visit>
  void search(const Piece& piece, Visit visit) const {
    Node stack[most_levels * EightLanes::width];
    stack[0] = {0, 0};
    for (std::uint32_t count = 1; count > 0;) {
      const Node node = stack[--count];
      const std::uint32_t children = EightLanes::width * node.index;
      // Missing ones overlap where numbers have overflowed.
      const std::uint32_t existing = std::min(nodes_[node.level + 1] - children, EightLanes::width);
      const unsigned lanes = piece.overlapping(blocks_[first_block_[node.level] + node.index]) &
                             (EightLanes::all >> (EightLanes::width - existing));
      if (node.level + 1 == levels_) {
        for_each_lane(lanes, [&](std::uint32_t lane) { visit(edges_[children + lane]); });
        continue;
      }
      const std::uint32_t first = count;
      for_each_lane(lanes, [&](std::uint32_t lane) {
        stack[count++] = {node.level + 1, children + lane};
      });
      if (piece.ascends()) {
        std::reverse(stack + first, stack + count);
      }
    }
  }

 private:
  static constexpr std::uint32_t most_levels = 5;

  struct Node {
    std::uint32_t level;
    std::uint32_t index;
  };

  double scale_;                            // 1 / unit
  std::vector<PairEdge> edges_;             // in the order of the boxes of the last level
  std::vector<Block> blocks_;               // from the root's to those of edges
  std::uint32_t nodes_[most_levels + 1];    // of each level, and the edges
  std::uint32_t first_block_[most_levels];  // of each level
  std::uint32_t levels_;
};

}  // namespace gcv
