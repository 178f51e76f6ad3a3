// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The superset edges near a place. The walk stays near its last step most of the time, so
// one search for all edges that come near serves many steps.
#pragma once

#include <cstddef>
#include <vector>

#include "implicit_superset.hpp"
#include "point.hpp"

namespace gcv {

class LocalSuperset {
 public:
  // `slack`: at least twice what any relative coordinate of the sum is off by.
  LocalSuperset(const ImplicitSuperset& superset, double slack);

  // Is every superset edge that passes through the point among the edges?
  [[nodiscard]] bool covers(const Point& p) const {
    return p.x > window_.x0 && p.x < window_.x1 && p.y > window_.y0 && p.y < window_.y1;
  }

  // Collects the edges around `centre`. False where they are too many within reach(): then
  // the collection is empty, and the next one looks less far around.
  bool gather(const Point& centre);

  // Calls visit(edge) for those of the edges in the range that may begin on the line
  // through `origin` with direction (dx, dy), or left of it, and end right of it.
  template <class Visit>
  void for_each_to_the_right(const RankRange& range, const Point& origin, double dx, double dy,
                             Visit visit) const {
    const double tolerance = tolerance_of(dx, dy);
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      const double start = dx * (y0_[k] - origin.y) - dy * (x0_[k] - origin.x);
      const double end = dx * (y1_[k] - origin.y) - dy * (x1_[k] - origin.x);
      if (!(end > tolerance) && !(start < -tolerance) && in_range(range, ranks_[k])) {
        visit(edges_[k]);
      }
    }
  }

  // Calls visit(edge) for those of the edges in the range that may pass through p.
  template <class Visit>
  void for_each_through(const RankRange& range, const Point& p, Visit visit) const {
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      const double dx = x1_[k] - x0_[k];
      const double dy = y1_[k] - y0_[k];
      const double offset = dx * (p.y - y0_[k]) - dy * (p.x - x0_[k]);
      const double tolerance = tolerance_of(dx, dy);
      if (!(offset > tolerance) && !(offset < -tolerance) && in_range(range, ranks_[k])) {
        visit(edges_[k]);
      }
    }
  }

  [[nodiscard]] double reach() const { return reach_; }

 private:
  [[nodiscard]] double tolerance_of(double dx, double dy) const;
  [[nodiscard]] bool in_range(const RankRange& range, Rank rank) const {
    const Directions& directions = superset_.operands().directions;
    return directions.angle(range.first, rank) <= directions.angle(range.first, range.last);
  }

  const ImplicitSuperset& superset_;
  double slack_;
  double reach_;
  Box window_;
  std::vector<PairEdge> edges_;
  std::vector<Rank> ranks_;
  std::vector<double> x0_, y0_, x1_, y1_;
};

}  // namespace gcv
