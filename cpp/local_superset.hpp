// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The superset edges near a place. The walk goes by small steps most of the time, and each
// begins where the last one ended, so one search for all edges that come near serves many
// steps. Edges deep inside the sum are left out: only a band along the walk is searched.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "implicit_superset.hpp"
#include "lanes.hpp"
#include "point.hpp"

namespace gcv {

class LocalSuperset {
 public:
  // `slack`: at least twice what any relative coordinate of the sum is off by.
  LocalSuperset(const ImplicitSuperset& superset, double slack);

  // Is every superset edge that passes through the segment among the edges?
  [[nodiscard]] bool covers(const Point& from, const Point& to) const {
    return covers(from) && covers(to);
  }

  // Collects the edges around a segment from `from` to `to`, which is shorter than reach().
  // False where they are too many: then the collection is empty, and the next one looks less
  // far around. `met`: as for ImplicitSuperset::search.
  bool gather(const Point& from, const Point& to, PairsMet* met);

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
  using Boxes = BoxBlock<DoubleLanes, Box>;
  static constexpr std::uint32_t width = DoubleLanes::width;

  // A superset edge with its ends in relative coordinates.
  struct Edge {
    PairEdge name;
    Point from;
    Point to;
  };
  class Band;

  [[nodiscard]] bool covers(const Point& p) const {
    return p.x > window_.x0 && p.x < window_.x1 && p.y > window_.y0 && p.y < window_.y1 &&
           dx_ * p.y - dy_ * p.x < leftmost_;
  }
  void add(const PairEdge& edge, const Box& wide);
  void clear();

  const ImplicitSuperset& superset_;
  double slack_;
  double reach_;
  Box window_;
  double dx_ = 0;  // the band lies right of the line of the offset `leftmost_`
  double dy_ = 0;
  double leftmost_ = 0;
  std::vector<Edge> edges_;
  std::vector<Boxes> boxes_;  // of as many edges each as they have lanes
};

}  // namespace gcv
