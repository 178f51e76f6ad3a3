// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Cache of the superset edges in a box ahead of the walk, along its direction of travel. Made for
// long, dense edges (spiky stars), where a box round the current place would hold too many. One
// tree search fills it; about 100 steps then need none. CostBudget decides when to fill it.
//
// Off in bench/ as "libgcv without ahead cache". docs/PERFORMANCE.md has the ratios.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "box.hpp"
#include "piece.hpp"
#include "point.hpp"
#include "simd.hpp"
#include "swept_spheres.hpp"
#include "tree_product.hpp"

namespace gcv {

// Decides when filling the cache pays. Unit: one node visit or one visit of a pair of edges.
// Budget = 1/8 of the cost of all searches + 1/2 of what earlier fills saved. While fills have
// saved less than half of their cost: 1/32 in place of 1/8.
class CostBudget {
 public:
  void add_search(std::int64_t cost) {
    ++searches_;
    costs_ += cost;
    mean_ = costs_ / searches_;
    credit_ += is_losing() ? cost / 4 : cost;
  }
  // The cache has answered in place of a search, at that cost.
  void add_spared(std::int64_t cost) {
    const std::int64_t spared = mean_ - cost;
    spared_ += spared;
    credit_ = std::max<std::int64_t>(credit_ + share / 2 * spared, 0);
  }
  // The place cache has answered: the budget shrinks by one mean search.
  void add_near() { credit_ -= std::min(credit_, mean_); }

  // What a fill may cost. 0: none is allowed, since it is likely to cost more than the budget has.
  [[nodiscard]] std::int64_t most() const;
  // A fill has cost that much, or an attempt that was given up.
  void spend(std::int64_t cost, bool is_filled);
  // No box can be laid out now.
  void postpone() { credit_ = 0; }

 private:
  static constexpr std::int64_t share = 8;
  static constexpr std::int64_t least_price = 512;
  static constexpr std::int64_t trials = 4096;  // that need not spare anything

  [[nodiscard]] bool is_losing() const { return spent_ > trials + 2 * spared_; }

  std::int64_t searches_ = 0;
  std::int64_t costs_ = 0;
  std::int64_t mean_ = 0;
  std::int64_t spent_ = 0;
  std::int64_t spared_ = 0;
  std::int64_t credit_ = 0;           // times `share`
  std::int64_t price_ = least_price;  // what a fill is likely to cost
};

class AheadCache {
 public:
  // `slack`: as for pieces.
  AheadCache(const TreeProduct& superset, double slack)
      : superset_(superset), tolerance_(2 * slack) {}

  [[nodiscard]] CostBudget& budget() { return budget_; }

  // The walk has come to a place.
  void pass(const Point& place) { places_[count_++ % places_.size()] = place; }

  // Does the box hold the place? If not, the cache is emptied, and filled anew from the place on
  // where that pays. `met`: as for TreeProduct::search.
  bool keep_up(const Point& place, VisitedPairs* met);

  [[nodiscard]] bool is_filled() const { return is_filled_; }
  // Is every superset edge that passes through the place in the cache?
  [[nodiscard]] bool holds(const Point& place) const {
    const Point p = in_frame(place);
    return p.x > bounds_.x0 && p.x < bounds_.x1 && p.y > bounds_.y0 && p.y < bounds_.y1;
  }
  // How far the box goes from a place in it, as a multiple of (dx, dy), or a bit less.
  [[nodiscard]] double room(const Point& place, double dx, double dy) const;

  // Calls visit(edge) for the edges that may touch a piece inside the box, for some of them several
  // times. visit() may shorten the piece.
  template <class Visit>
  void search(const Piece& piece, Visit visit) {
    std::int64_t boxes = 0;
    const Point from = in_frame(piece.from());
    Point to = in_frame(piece.to());
    const int step = from.x <= to.x ? 1 : -1;
    for (int k = slab_of(from.x); step * (slab_of(to.x) - k) >= 0; k += step) {
      const std::vector<Block>& blocks = slabs_[static_cast<std::size_t>(k)].blocks;
      boxes += static_cast<std::int64_t>(blocks.size());
      for (const Block& block : blocks) {
        unsigned lanes = block.boxes.overlapping(box_of(from, to));
        if (lanes == 0) {
          continue;
        }
        lanes &= piece.touching(block.segments);
        for_each_lane(lanes, [&](std::uint32_t lane) {
          visit(block.edges[lane]);
          to = in_frame(piece.to());
        });
      }
    }
    budget_.add_spared(boxes / 8);
  }

 private:
  static constexpr std::uint32_t width = SimdDouble::width;
  static constexpr int slab_count = 24;
  // Three blocks of places tell where the walk goes. Blocks are shorter at its start.
  static constexpr std::size_t most_places = 128;
  static constexpr std::size_t least_places = 32;

  // Edges, the boxes of their parts in the slab, and their ends.
  struct Block {
    BoxBlock<SimdDouble, Box> boxes;
    SegmentBlock segments;
    PairEdge edges[width];
  };
  // A part of the box, from side to side.
  struct Slab {
    std::vector<Block> blocks;
    std::uint32_t size = 0;
  };
  class Place;

  // A point in the frame of the box: along the direction of travel, and to its left.
  [[nodiscard]] Point in_frame(const Point& p) const {
    return {unit_.x * p.x + unit_.y * p.y, unit_.x * p.y - unit_.y * p.x};
  }
  [[nodiscard]] int slab_of(double x) const {
    const double number = (x - bounds_.x0) * slabs_per_length_;
    return number > 0 ? static_cast<int>(std::min<double>(number, slab_count - 1)) : 0;
  }
  // A place that the walk has passed, the last one where `back` is 0.
  [[nodiscard]] const Point& passed(std::size_t back) const {
    return places_[(count_ - 1 - back) % places_.size()];
  }
  // The mean of a block of such places.
  [[nodiscard]] Point mean_place(std::size_t block, std::size_t back) const;
  // Where a block of places goes, given the mean of the one before and its own.
  [[nodiscard]] Point heading(std::size_t block, std::size_t back, const Point& before,
                              const Point& mean) const;
  bool lay_out(const Point& place);
  void gather(std::int64_t most, VisitedPairs* met);
  void add(const PairEdge& edge);
  void clear();

  const TreeProduct& superset_;
  double tolerance_;
  CostBudget budget_;
  std::array<Point, 4 * most_places> places_{};  // the last ones, round and round
  std::size_t count_ = 0;                        // of all places
  bool is_filled_ = false;
  double stretch_ = 1;  // less where boxes would hold too much
  Point unit_{0, 0};
  Box bounds_ = empty_box;  // of the box, in its frame
  double slab_length_ = 0;
  double slabs_per_length_ = 0;
  std::array<Slab, slab_count> slabs_;
};

}  // namespace gcv
