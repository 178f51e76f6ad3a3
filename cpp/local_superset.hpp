// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The superset edges near a place. The walk goes by small steps most of the time, and each
// begins where the last one ended, so one search for all edges that come near serves many
// steps. Edges deep inside the sum are left out: only a band along the walk is searched.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "implicit_superset.hpp"
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
                     Visit visit) {
    const double tolerance = offset_tolerance(dx, dy, slack_);
    const double offset = dx * origin.y - dy * origin.x;
    const Box box = box_of(from, to);
    const std::size_t count = edges_.size();
    for (std::size_t k = 0; k < count; ++k) {
      const double start = dx * y0_[k] - dy * x0_[k];
      const double stop = dx * y1_[k] - dy * x1_[k];
      beyond_line_[k] = std::max(std::min(start, stop) - offset, offset - std::max(start, stop));
      const double x =
          std::max(std::min(x0_[k], x1_[k]) - box.x1, box.x0 - std::max(x0_[k], x1_[k]));
      const double y =
          std::max(std::min(y0_[k], y1_[k]) - box.y1, box.y0 - std::max(y0_[k], y1_[k]));
      beyond_box_[k] = std::max(x, y);
    }
    for (std::size_t k = 0; k < count; ++k) {
      if (!(beyond_line_[k] > tolerance) && !(beyond_box_[k] > slack_)) {
        visit(edges_[k]);
      }
    }
  }

  [[nodiscard]] double reach() const { return reach_; }

 private:
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
  std::vector<PairEdge> edges_;
  std::vector<double> x0_, y0_, x1_, y1_;
  Buffer<double> beyond_line_, beyond_box_;
};

}  // namespace gcv
