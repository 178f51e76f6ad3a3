// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Cache of the superset edges in a box round a place. Made for short edges (coasts): steps are
// small, and each begins where the last one ended, so that one tree search serves many steps. The
// size of the box adapts to how many edges it holds. Edges deep inside the sum are left out: only a
// band along the walk is searched.
//
// Off in bench/ as "libgcv without place cache". docs/PERFORMANCE.md has the ratios.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "box.hpp"
#include "point.hpp"
#include "simd.hpp"
#include "tree_product.hpp"

namespace gcv {

class PlaceCache {
 public:
  // `slack`: at least twice what any relative coordinate of the sum is off by.
  PlaceCache(const TreeProduct& superset, double slack);

  // Is every superset edge that passes through the segment among the edges?
  [[nodiscard]] bool covers(const Point& from, const Point& to) const {
    return covers(from) && covers(to);
  }

  // Collects the edges around a segment from `from` to `to`, which is shorter than reach().
  // False where they are too many: then the cache is empty, and the next box is smaller. `met`: as
  // for TreeProduct::search.
  bool gather(const Point& from, const Point& to, VisitedPairs* met);

  // Calls visit(edge) for those of the edges that may touch the segment between `from` and `to`,
  // on the line through `origin` with direction (dx, dy).
  template <class Visit>
  void for_each_near(const Point& origin, double dx, double dy, const Point& from, const Point& to,
                     Visit visit) const {
    const double tolerance = offset_tolerance(dx, dy, slack_);
    const double offset = dx * origin.y - dy * origin.x;
    const Box box = widened(box_of(from, to), slack_);
    for (std::size_t k = 0; k < boxes_.size(); ++k) {
      for_each_lane(boxes_[k].overlapping(box), [&](std::uint32_t lane) {
        const std::size_t number = width * k + lane;
        if (number >= edges_.size()) {  // missing lanes, where numbers have overflowed
          return;
        }
        const Edge& edge = edges_[number];
        const double start = dx * edge.from.y - dy * edge.from.x;
        const double end = dx * edge.to.y - dy * edge.to.x;
        const double beyond_line =
            std::max(std::min(start, end) - offset, offset - std::max(start, end));
        if (!(beyond_line > tolerance)) {
          visit(edge.name);
        }
      });
    }
  }

  [[nodiscard]] double reach() const { return reach_; }

 private:
  using Boxes = BoxBlock<SimdDouble, Box>;
  static constexpr std::uint32_t width = SimdDouble::width;

  // A superset edge with its ends in relative coordinates.
  struct Edge {
    PairEdge name;
    Point from;
    Point to;
  };
  class Band;

  [[nodiscard]] bool covers(const Point& p) const {
    return p.x > bounds_.x0 && p.x < bounds_.x1 && p.y > bounds_.y0 && p.y < bounds_.y1 &&
           dx_ * p.y - dy_ * p.x < leftmost_;
  }
  void add(const PairEdge& edge, const Box& wide);
  void clear();

  const TreeProduct& superset_;
  double slack_;
  double reach_;
  Box bounds_;
  double dx_ = 0;  // the band lies right of the line of the offset `leftmost_`
  double dy_ = 0;
  double leftmost_ = 0;
  std::vector<Edge> edges_;
  std::vector<Boxes> boxes_;  // of as many edges each as they have lanes
};

}  // namespace gcv
