// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The free place that is furthest in a direction.
#include <cmath>

#include "best_free.hpp"
#include "free_place.hpp"
#include "predicates.hpp"

namespace gcv {

namespace {

// The sign of how far a direction leads in another.
int sign_along(const Point& direction, const Point& from, const Point& to, Tally& tally) {
  return turn({0, 0}, {direction.y, 0.0 - direction.x}, from, to, tally);
}

// Furthest in a direction.
class FurthestFree : public BestFree<FurthestFree> {
 public:
  FurthestFree(const Operands& operands, const WantedParts& wanted, EdgeCover& cover,
               const NearestEdges& edges, const Point& direction, const FreePlaceSearch::Wish& wish,
               const std::optional<ExactPoint>& first, Tally& tally)
      : BestFree(operands, wanted, cover, edges, infinity, tally),
        direction_(direction),
        wish_(wish),
        first_(first) {
    if (first) {
      distance_of_first_ = distance_of(*first);
    }
  }

  [[nodiscard]] const Interval& distance_of_first() const { return distance_of_first_; }

  Place ring(const PlacesOnLine& places, const Place& from) {
    if (wish_.is_for_corners) {
      const Place to = end_of_ring(places, from);
      take_wanted(places, from);
      take_wanted(places, to);
      return to;
    }
    const FreePlace free = free_place(places, from);
    if (is_before_first(free)) {
      return end_of_ring(places, from);
    }
    // On edges that do not lead on, all others are less far.
    compare(free);
    return places.end();
  }
  // Its first place, if that is wanted; else the last one.
  void take_fit(const PlacesOnLine& places, const Place& from, const Place& to) {
    if (!take_wanted(places, from) && places.compare(from, to) != 0) {
      take_wanted(places, to);
    }
  }
  int compare_exactly(const ExactPoint& p, const ExactPoint& q) {
    return -compare_along(direction_, p, q, tally_);
  }
  // Is nothing on the edge better than what is found? One of its ends is its best place.
  [[nodiscard]] bool is_behind(const PairEdge& s) {
    const auto is_better = [&](const VertexSum& sum) {
      const double distance = edges_.distance(operands_.relative(sum.i, sum.j));
      return is_before(ExactPoint::of_sum(operands_.point(sum)),
                       {distance - 8 * slack_, distance + 8 * slack_});
    };
    return found() && !is_better(start_of(s)) && !is_better(end_of(operands_, s));
  }

 private:
  bool take_wanted(const PlacesOnLine& places, const Place& place) {
    const FreePlace free = free_place(places, place);
    if (is_before_first(free)) {
      return false;
    }
    if (found() && !is_before(free.point, free.distance)) {
      return true;  // as far as that matters
    }
    const bool is_wanted = !(free.distance.lo > reach()) && wish_.is_wanted(free);
    if (is_wanted) {
      compare(free);
    }
    return is_wanted;
  }
  // Then it is not free.
  bool is_before_first(const FreePlace& place) {
    return first_ && is_before(place.point, place.distance, *first_, distance_of_first_);
  }
  // Of the double next to the point, which is off by half a unit in the last place.
  [[nodiscard]] Interval distance_of(const ExactPoint& point) const {
    const Point p = nearest_point(point, {0, 0}, tally_);
    const double distance = edges_.distance(operands_.relative_place(p));
    const double error = 16 * slack_ + 0x1p-50 * (std::abs(p.x) + std::abs(p.y));
    return std::isfinite(distance + error) ? Interval{distance - error, distance + error}
                                           : Interval{-infinity, infinity};
  }
  [[nodiscard]] FreePlace free_place(const PlacesOnLine& places, const Place& place) const {
    const RelativeLine line = relative_line(places);
    const Interval parameter = parameters_of(line, place);
    return {exact_point(places.line().at, place), distance_at(line, parameter), places.line().edge,
            parameter, place};
  }

  const Point direction_;
  const FreePlaceSearch::Wish& wish_;
  const std::optional<ExactPoint>& first_;
  Interval distance_of_first_{-infinity, infinity};
};

}  // namespace

// The furthest place of a ring, the lexicographically smallest of several, begins an edge that
// leads back, or neither on nor back and to lexicographically larger ones. So do segments, for one
// of two opposite directions.
std::optional<FreePlace> FreePlaceSearch::furthest(const Point& direction, const Wish& wish,
                                                   Task& task, std::uint64_t step,
                                                   const std::optional<ExactPoint>& first) {
  nearest_edges_.set_goal(Goal::far(direction));
  FurthestFree best(operands_, wanted_, cover_, nearest_edges_, direction, wish, first, tally_);
  nearest_edges_.leave_out_before(best.distance_of_first().lo);
  walked_.clear();
  const auto leads_on = [&](const PairEdge& s) {
    const auto [from, to] = operands_.source(s);
    const int sign = sign_along(direction, from, to, tally_);
    return sign > 0 || (sign == 0 && lexicographically_less(to, from));
  };
  nearest_edges_.for_each(
      best.reach(),
      [&](const PairEdge& s) {
        return (wish.is_for_corners || !leads_on(s)) && !best.is_behind(s);
      },
      [&](const PairEdge& s) {
        if (!best.is_behind(s)) {
          walk(s, best);
        }
      },
      [&] {
        task.advance(step);
        return true;
      });
  if (wanted_.fits) {
    cover_.visit_touches(best, [&](const VertexSum& sum) { return best.is_near(sum); });
  }
  return best.found();
}

}  // namespace gcv
