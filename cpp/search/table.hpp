// SPDX-License-Identifier: LGPL-3.0-or-later
//
// All superset edges in a tree of boxes. Made for small operands (nesting parts): where edges are
// few, the tree is soon built, and a search in it takes a fraction of one in the product of two
// trees.
//
// Off in bench/ as "libgcv without table". docs/PERFORMANCE.md has the ratios.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "box.hpp"
#include "contributing_vertices.hpp"
#include "contributions.hpp"
#include "limits.hpp"
#include "point.hpp"
#include "simd.hpp"

namespace gcv {

// How many superset edges there are, before merging: those that are edges of A, and those of B.
struct SupersetCount {
  std::uint64_t a;
  std::uint64_t b;
  [[nodiscard]] std::uint64_t all() const { return a + b; }
};
// O(n + m).
SupersetCount count_superset(const Operands& operands, const RankedEdges& ranked);

// Relative coordinates of the sum as integers of 16 bits, from the middle of its extents. Each axis
// has its own unit, so that stretched polygons have the same places.
class CoarseGrid {
 public:
  explicit CoarseGrid(const Operands& operands);

  // Are all numbers in range, and edges of both polygons that are no longer than two units few?
  // Where they are not, too many edges are in one place. O(n + m).
  [[nodiscard]] bool is_fine_enough(const Operands& operands) const;

  // In units of the grid, not rounded.
  [[nodiscard]] Point place(const Point& p) const {
    return {(p.x - middle_.x) * scale_.x, (p.y - middle_.y) * scale_.y};
  }
  [[nodiscard]] Point direction(const SumEdge& s) const {
    return {s.dx * scale_.x, s.dy * scale_.y};
  }
  // To the nearest integer; for numbers of up to 16 bits.
  [[nodiscard]] static int rounded(double x) { return static_cast<int>(x + 32768.5) - 32768; }

  // Those of one polygon: their places add up to those of the sum.
  [[nodiscard]] CoarseGrid of(const Boundary& polygon) const;

 private:
  CoarseGrid(const Point& scale, const Point& middle) : scale_(scale), middle_(middle) {}

  Point scale_;  // units along x, and along y
  Point middle_;
};

class SupersetTable {
 public:
  // For so many edges as count_superset() says, up to the limit of tables. O(n + m + edges).
  SupersetTable(const Operands& operands, const CoarseGrid& grid, const RankedEdges& ranked,
                std::size_t size);

  // The boxes of the children of one node. Those that are missing hold no point.
  using Block = BoxBlock<SimdShort, SimdBox<SimdShort>>;

  // A piece of an edge, from `from` to `to` in relative coordinates, as a place to search.
  //
  // In units of the grid: a side of a box, the sum of two rounded numbers, is off by 1, an end of
  // the piece by 1/2; `box_slack` is 2. Offsets from the line of the edge are in units of 2^16,
  // the larger part of its direction being 2^15 - 1: an offset is off by 1/2 for the other part of
  // the direction, which was rounded, by 1 for the point, by 1 for two products that were rounded
  // down, and the offset of the line by 1; `line_slack` is 4.
  class Piece {
   public:
    Piece(const SupersetTable& tree, const SumEdge& s, const Point& from, const Point& to)
        : grid_(tree.grid_), from_(grid_.place(from)) {
      const Point direction = grid_.direction(s);
      const double size = std::max(std::abs(direction.x), std::abs(direction.y));
      const bool is_known = size >= 0x1p-900;  // else 0, which leaves nothing out
      const int dx = is_known ? CoarseGrid::rounded(direction.x / size * 0x7fff) : 0;
      const int dy = is_known ? CoarseGrid::rounded(direction.y / size * 0x7fff) : 0;
      const auto offset = static_cast<int>((dx * from_.y - dy * from_.x) * 0x1p-16);
      dx_ = SimdShort::of(dx);
      dy_ = SimdShort::of(dy);
      leftmost_ = SimdShort::of(std::min(offset + line_slack, most));
      rightmost_ = SimdShort::of(std::max(offset - line_slack, -most));
      ascends_ = std::abs(dx) > std::abs(dy) ? dx > 0 : dy > 0;
      near_x_ = dy > 0 ? &Block::x0 : &Block::x1;
      far_x_ = dy > 0 ? &Block::x1 : &Block::x0;
      near_y_ = dx > 0 ? &Block::y0 : &Block::y1;
      far_y_ = dx > 0 ? &Block::y1 : &Block::y0;
      shorten(to);
    }

    void shorten(const Point& to) {
      const Box box = box_of(from_, grid_.place(to));
      x_low_ = SimdShort::of(std::max(CoarseGrid::rounded(box.x0) - box_slack, -most));
      y_low_ = SimdShort::of(std::max(CoarseGrid::rounded(box.y0) - box_slack, -most));
      x_high_ = SimdShort::of(std::min(CoarseGrid::rounded(box.x1) + box_slack, most));
      y_high_ = SimdShort::of(std::min(CoarseGrid::rounded(box.y1) + box_slack, most));
    }

    // The lanes whose boxes reach that of the piece, and the line of the edge or both of its
    // sides.
    [[nodiscard]] unsigned overlapping(const Block& block) const {
      const auto lanes = [&](Side side) { return SimdShort::load(block.*side); };
      const SimdShort offset_high =
          high_product(dx_, lanes(far_y_)) - high_product(dy_, lanes(near_x_));
      const SimdShort offset_low =
          high_product(dx_, lanes(near_y_)) - high_product(dy_, lanes(far_x_));
      const SimdShort apart = (lanes(&Block::x0) > x_high_) | (lanes(&Block::x1) < x_low_) |
                              (lanes(&Block::y0) > y_high_) | (lanes(&Block::y1) < y_low_) |
                              (offset_high < rightmost_) | (offset_low > leftmost_);
      return ~apart.bits() & SimdShort::all;
    }

    // Are boxes with larger coordinates to come last?
    [[nodiscard]] bool ascends() const { return ascends_; }

   private:
    using Side = SimdShort::Number (Block::*)[SimdShort::width];

    static constexpr int box_slack = 2;
    static constexpr int line_slack = 4;
    static constexpr int most = SimdShort::highest - 1;  // where nothing is missing

    const CoarseGrid& grid_;
    Point from_;
    SimdShort dx_;
    SimdShort dy_;
    SimdShort leftmost_;
    SimdShort rightmost_;
    SimdShort x_low_;
    SimdShort y_low_;
    SimdShort x_high_;
    SimdShort y_high_;
    Side near_x_;  // where the offsets are largest
    Side far_x_;
    Side near_y_;
    Side far_y_;
    bool ascends_;
  };

  // Calls visit(edge) for superset edges, among them all that have a point in the piece, which
  // visit() may shorten.
  template <class Visit>
  void search(const Piece& piece, Visit visit) const {
    constexpr std::uint32_t width = SimdShort::width;
    std::uint32_t stack[most_levels * width];
    stack[0] = 0;
    for (std::uint32_t count = 1; count > 0;) {
      const std::uint32_t node = stack[--count];
      unsigned lanes = piece.overlapping(blocks_[node]);
      if (node >= first_leaf_) {
        const PairEdge* const edges = &edges_[std::size_t{width} * (node - first_leaf_)];
        for_each_lane(lanes, [&](std::uint32_t lane) { visit(edges[lane]); });
        continue;
      }
      const std::uint32_t children = width * node + 1;
      if (!piece.ascends()) {
        for_each_lane(lanes, [&](std::uint32_t lane) { stack[count++] = children + lane; });
        continue;
      }
      while (lanes != 0) {
        const auto last = static_cast<std::uint32_t>(std::bit_width(lanes)) - 1;
        stack[count++] = children + last;
        lanes ^= 1U << last;
      }
    }
  }

 private:
  static constexpr std::uint32_t most_levels = 6;
  static_assert(limits::most_linear_edges <= std::uint64_t{1} << (3 * most_levels) &&
                SimdShort::width == 8);

  CoarseGrid grid_;
  Buffer<PairEdge> edges_;  // in the order of their boxes
  // Of the root, node 0, and of all others: the children of node k are 8k + 1 to 8k + 8.
  Buffer<Block> blocks_;
  std::uint32_t first_leaf_ = 0;  // the first node with edges for children
};

}  // namespace gcv
