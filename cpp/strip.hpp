// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The superset edges in a strip ahead of the walk. Where edges are long and lie dense, as those of
// spikes, a window holds too many of them, and each search of the implicit superset goes through a
// crowd of nodes. The walk goes on as it went: one search for a strip of its way and swing serves
// the next steps, a hundred or more, where that pays.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "capsules.hpp"
#include "implicit_superset.hpp"
#include "lanes.hpp"
#include "piece.hpp"
#include "point.hpp"

namespace gcv {

// When a strip may be gathered, and at what cost. Costs are counted in looks at blocks and visits
// of pairs of edges. An eighth of what searches have cost may be spent on strips, and half of what
// these have spared; but a 32nd of it where strips have not spared half of what they have cost.
class StripFund {
 public:
  void add_search(std::int64_t cost) {
    ++searches_;
    costs_ += cost;
    mean_ = costs_ / searches_;
    credit_ += is_losing() ? cost / 4 : cost;
  }
  // A strip has spared a search, at that cost.
  void add_spared(std::int64_t cost) {
    const std::int64_t spared = mean_ - cost;
    spared_ += spared;
    credit_ = std::max<std::int64_t>(credit_ + share / 2 * spared, 0);
  }
  // A window has: where windows do, no strips are needed.
  void add_window() { credit_ -= std::min(credit_, mean_); }

  // What a strip may cost; 0 where there is to be none, since another one is too likely to cost
  // more than there is.
  [[nodiscard]] std::int64_t most() const;
  // A strip has cost that much; or else the attempt has, and it would have cost more.
  void spend(std::int64_t cost, bool is_gathered);
  // There is no place for a strip.
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
  std::int64_t price_ = least_price;  // what a strip is likely to cost
};

class Strip {
 public:
  // `slack`: as for pieces.
  Strip(const ImplicitSuperset& superset, double slack)
      : superset_(superset), tolerance_(2 * slack) {}

  [[nodiscard]] StripFund& fund() { return fund_; }

  // The walk has come to a place.
  void pass(const Point& place) { places_[count_++ % places_.size()] = place; }

  // Does the strip hold the place? If not, it is given up, and another one is gathered from there
  // on where that pays. `met`: as for ImplicitSuperset::search.
  bool keep_up(const Point& place, PairsMet* met);

  [[nodiscard]] bool is_gathered() const { return is_gathered_; }
  // Is every superset edge that passes through the place in the strip?
  [[nodiscard]] bool holds(const Point& place) const {
    const Point p = in_strip(place);
    return p.x > bounds_.x0 && p.x < bounds_.x1 && p.y > bounds_.y0 && p.y < bounds_.y1;
  }
  // How far the strip goes from a place that it holds, as a multiple of (dx, dy), or a bit less.
  [[nodiscard]] double room(const Point& place, double dx, double dy) const;

  // Calls visit(edge) for those of its edges that may touch a piece that it holds, some of them
  // several times. visit() may shorten the piece.
  template <class Visit>
  void search(const Piece& piece, Visit visit) {
    std::int64_t boxes = 0;
    const Point from = in_strip(piece.from());
    Point to = in_strip(piece.to());
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
          to = in_strip(piece.to());
        });
      }
    }
    fund_.add_spared(boxes / 8);
  }

 private:
  static constexpr std::uint32_t width = DoubleLanes::width;
  static constexpr int slab_count = 24;
  // Of so many places each, three blocks of them tell where the walk goes; of less, at its start.
  static constexpr std::size_t most_places = 128;
  static constexpr std::size_t least_places = 32;

  // Edges, their boxes in the strip as far as they lie in the slab, and their ends.
  struct Block {
    BoxBlock<DoubleLanes, Box> boxes;
    SegmentBlock segments;
    PairEdge edges[width];
  };
  // A part of the strip, from side to side.
  struct Slab {
    std::vector<Block> blocks;
    std::uint32_t size = 0;
  };
  class Place;

  // A point in the coordinates of the strip: along it, and to its left.
  [[nodiscard]] Point in_strip(const Point& p) const {
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
  bool lay_out(const Point& place);
  void gather(std::int64_t most, PairsMet* met);
  void add(const PairEdge& edge);
  void clear();

  const ImplicitSuperset& superset_;
  double tolerance_;
  StripFund fund_;
  std::array<Point, 4 * most_places> places_{};  // the last ones, round and round
  std::size_t count_ = 0;                        // of all places
  bool is_gathered_ = false;
  double stretch_ = 1;  // less where strips would be too large
  Point unit_{0, 0};
  Box bounds_ = empty_box;  // in its own coordinates
  double slab_length_ = 0;
  double slabs_per_length_ = 0;
  std::array<Slab, slab_count> slabs_;
};

}  // namespace gcv
