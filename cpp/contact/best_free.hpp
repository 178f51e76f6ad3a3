// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What searches for free places have in common.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "cover.hpp"
#include "exact_point.hpp"
#include "exact_region.hpp"
#include "gap.hpp"
#include "nearest_edges.hpp"
#include "vector.hpp"

namespace gcv {

struct FreePlace {
  ExactPoint point;
  Interval distance;           // from the goal
  PairEdge edge;               // it lies on the line of this superset edge,
  Interval parameter;          // here
  std::optional<Place> place;  // likewise, unless it is a foot
};

// The point of a free place that a search among scaled operands has found. `from`: what a foot is
// nearest to.
inline ExactPoint unscaled_point(const Operands& operands, const FreePlace& found,
                                 const Point& from = {0, 0}) {
  const SumEdge line = coordinates(operands.a, operands.b, found.edge);
  if (!found.place) {
    return ExactPoint::of_crossing(line, perpendicular(line, {from, {0, 0}}));
  }
  return found.place->is_sum ? ExactPoint::of_sum(operands.point(found.place->sum))
                             : ExactPoint::of_crossing(line, coordinates(operands.a, operands.b,
                                                                         found.place->crossing));
}

// The best of the free places that covers show (sum/cover.hpp). `Best`, which derives from this,
// says what is better: compare_exactly(p, q) is -1 if p is; and which of a fit's places count:
// take_fit(places, from, to).
template <class Best>
class BestFree {
 public:
  static constexpr bool knows_rings = false;

  BestFree(const Operands& operands, const WantedParts& wanted, EdgeCover& cover,
           const NearestEdges& edges, double reach, Tally& tally)
      : operands_(operands),
        cover_(cover),
        edges_(edges),
        tally_(tally),
        slack_(cover.search().slack()),
        wanted_(wanted),
        reach_(reach) {}

  [[nodiscard]] const std::optional<FreePlace>& found() const { return found_; }
  // Places further from the goal than this do not matter.
  [[nodiscard]] const double& reach() const { return reach_; }

  void segment(const PlacesOnLine& places, const Place& from, const Place& to) {
    if (wanted_.fits) {
      best().take_fit(places, from, to);
    }
  }
  void point(const PlacesOnLine& places, const Place& place) { segment(places, place, place); }

  // May the sum of two vertices be within reach?
  [[nodiscard]] bool is_near(const VertexSum& sum) const {
    return !(edges_.distance(operands_.relative(sum.i, sum.j)) - 8 * slack_ > reach_);
  }

 protected:
  [[nodiscard]] const WantedParts& wanted() const { return wanted_; }
  // Where a ring leaves the line. A fit may go on where the free side ends.
  [[nodiscard]] Place end_of_ring(const PlacesOnLine& places, const Place& from) {
    return cover_.end_of_free(places, from, !wanted_.fits);
  }
  [[nodiscard]] RelativeLine relative_line(const PlacesOnLine& places) const {
    const SumEdge& s = places.line().at;
    return {operands_.relative_start(places.line().edge), s.dx, s.dy};
  }
  [[nodiscard]] Interval parameters_of(const RelativeLine& line, const Place& place) const {
    if (!place.is_sum) {
      return place.parameter;
    }
    const Point p = operands_.relative(place.sum.i, place.sum.j);
    const double t = std::abs(line.dx) >= std::abs(line.dy) ? (p.x - line.origin.x) / line.dx
                                                            : (p.y - line.origin.y) / line.dy;
    const double error = 2 * slack_ / std::max(std::abs(line.dx), std::abs(line.dy));
    return {t - error, t + error};
  }
  // The distance from the goal of a place with a parameter in that interval.
  [[nodiscard]] Interval distance_at(const RelativeLine& line, const Interval& parameter) const {
    const double distance = edges_.distance(line.at(parameter.lo));
    const double error =
        8 * slack_ + 2 * (parameter.hi - parameter.lo) * length_of(line.dx, line.dy);
    return {distance - error, distance + error};
  }
  [[nodiscard]] SumEdge line_of(const EdgeName& edge) const {
    return coordinates(operands_.a, operands_.b, edge);
  }
  [[nodiscard]] ExactPoint exact_point(const SumEdge& s, const Place& place) const {
    return place.is_sum ? ExactPoint::of_sum(operands_.point(place.sum))
                        : ExactPoint::of_crossing(s, line_of(place.crossing));
  }

  void compare(const PlacesOnLine& places, const ExactPoint& point, const RelativeLine& line,
               const Interval& parameter, const std::optional<Place>& place) {
    compare({point, distance_at(line, parameter), places.line().edge, parameter, place});
  }
  void compare(const FreePlace& place) {
    if (found_ && (place.point == found_->point || !is_before(place.point, place.distance))) {
      return;
    }
    found_ = place;
    reach_ = std::min(reach_, place.distance.hi);
  }

  // Is it better than the one that is found?
  bool is_before(const ExactPoint& point, const Interval& distance) {
    return is_before(point, distance, found_->point, found_->distance);
  }
  // Is the first point better than the second one?
  bool is_before(const ExactPoint& p, const Interval& distance_p, const ExactPoint& q,
                 const Interval& distance_q) {
    if (const int order = order_of(distance_p, distance_q); order != 0) {
      return order < 0;
    }
    const int order = best().compare_exactly(p, q);
    return order < 0 || (order == 0 && compare_lexicographically(p, q, tally_) < 0);
  }

  const Operands& operands_;
  EdgeCover& cover_;
  const NearestEdges& edges_;
  Tally& tally_;
  const double slack_;

 private:
  Best& best() { return static_cast<Best&>(*this); }

  const WantedParts wanted_;
  double reach_;
  std::optional<FreePlace> found_;
};

}  // namespace gcv
