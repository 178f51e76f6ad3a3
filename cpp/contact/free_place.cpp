// SPDX-License-Identifier: LGPL-3.0-or-later
#include "free_place.hpp"

#include <algorithm>
#include <cmath>

#include "gap.hpp"
#include "predicates.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

// How far the nearest side of the box of the sum is, if all is free outside of it.
double distance_from_outside(const Operands& operands, const Point& p) {
  if (operands.a.kind == Boundary::Kind::hole) {
    return infinity;
  }
  const Box box = operands.relative_bounds();
  return std::max(0.0, std::min({p.x - box.x0, box.x1 - p.x, p.y - box.y0, box.y1 - p.y}));
}

// The sign of how far a direction leads in another.
int sign_along(const Point& direction, const Point& from, const Point& to, Tally& tally) {
  return turn({0, 0}, {direction.y, 0.0 - direction.x}, from, to, tally);
}

// What all goals have in common: the best of the free places that covers show (sum/cover.hpp).
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
    if (distance.hi < found_->distance.lo || distance.lo > found_->distance.hi) {
      return distance.hi < found_->distance.lo;
    }
    const int order = best().compare_exactly(point, found_->point);
    return order < 0 || (order == 0 && compare_lexicographically(point, found_->point, tally_) < 0);
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

// Nearest to a point.
class NearestFree : public BestFree<NearestFree> {
 public:
  NearestFree(const Operands& operands, const WantedParts& wanted, EdgeCover& cover,
              const NearestEdges& edges, const Point& from, const Point& relative, double most,
              Tally& tally)
      : BestFree(
            operands, wanted, cover, edges,
            std::min(most, distance_from_outside(operands, relative)) + 8 * cover.search().slack(),
            tally),
        from_(from),
        relative_(relative) {}

  Place ring(const PlacesOnLine& places, const Place& from) {
    const Place to = end_of_ring(places, from);
    if (wanted().holes) {
      take(places, from, to);
    }
    return to;
  }
  // The places from one to another on a line. Of a ring, less the last one: the next edge has that.
  void take(const PlacesOnLine& places, const Place& from, const Place& to,
            bool is_of_ring = false) {
    const SumEdge& s = places.line().at;
    const RelativeLine line = relative_line(places);
    const Interval first = parameters_of(line, from);
    const Interval last = parameters_of(line, to);
    const double nearest = std::max(first.lo, std::min(foot_on(line), last.hi));
    if (distance_at(line, {nearest, nearest}).lo > reach()) {
      return;
    }
    const SumEdge across = perpendicular(s, {from_, {0, 0}});
    if (from_foot_to(s, from, across) >= 0) {
      compare(places, exact_point(s, from), line, first, from);
    } else if (from_foot_to(s, to, across) <= 0) {
      if (!is_of_ring) {
        compare(places, exact_point(s, to), line, last, to);
      }
    } else {
      compare(places, ExactPoint::of_crossing(s, across), line, {nearest, nearest}, std::nullopt);
    }
  }
  void take_fit(const PlacesOnLine& places, const Place& from, const Place& to) {
    take(places, from, to);
  }
  // -1 if p is nearer than q.
  int compare_exactly(const ExactPoint& p, const ExactPoint& q) {
    return compare_distances(p, q, from_, tally_);
  }

 private:
  // The parameter of the foot of the perpendicular from the point.
  [[nodiscard]] double foot_on(const RelativeLine& line) const {
    const double size = length_of(line.dx, line.dy);
    const double x = line.dx / size;
    const double y = line.dy / size;
    return ((relative_.x - line.origin.x) * x + (relative_.y - line.origin.y) * y) / size;
  }
  // Does the place lie ahead of the foot on s (1), behind it (-1), or on it (0)?
  int from_foot_to(const SumEdge& s, const Place& place, const SumEdge& across) {
    return place.is_sum ? -side(across, operands_.point(place.sum), tally_)
                        : compare_crossings(s, line_of(place.crossing), across, tally_);
  }

  const Point from_;
  const Point relative_;
};

// A step takes some microseconds.
constexpr std::uint64_t steps_a_poll = 1U << 12;

// Furthest in a direction.
class FurthestFree : public BestFree<FurthestFree> {
 public:
  FurthestFree(const Operands& operands, const WantedParts& wanted, EdgeCover& cover,
               const NearestEdges& edges, const Point& direction, const FreePlaceSearch::Wish& wish,
               Tally& tally)
      : BestFree(operands, wanted, cover, edges, infinity, tally),
        direction_(direction),
        wish_(wish) {}

  Place ring(const PlacesOnLine& places, const Place& from) {
    if (wish_.is_for_corners) {
      const Place to = end_of_ring(places, from);
      take_wanted(places, from);
      take_wanted(places, to);
      return to;
    }
    // On edges that do not lead on, all others are less far.
    take(places, from);
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
    if (found() && !is_before(free.point, free.distance)) {
      return true;  // as far as that matters
    }
    const bool is_wanted = !(free.distance.lo > reach()) && wish_.is_wanted(free);
    if (is_wanted) {
      compare(free);
    }
    return is_wanted;
  }
  void take(const PlacesOnLine& places, const Place& place) { compare(free_place(places, place)); }
  [[nodiscard]] FreePlace free_place(const PlacesOnLine& places, const Place& place) const {
    const RelativeLine line = relative_line(places);
    const Interval parameter = parameters_of(line, place);
    return {exact_point(places.line().at, place), distance_at(line, parameter), places.line().edge,
            parameter, place};
  }

  const Point direction_;
  const FreePlaceSearch::Wish& wish_;
};

}  // namespace

FreePlaceSearch::FreePlaceSearch(const Operands& operands, const WantedParts& wanted, Tally& tally)
    : operands_(operands),
      wanted_(wanted),
      tally_(tally),
      cover_(operands, tally),
      nearest_edges_(operands, cover_.search()),
      known_(operands, cover_.search().slack(), tally) {}

std::optional<FreePlace> FreePlaceSearch::nearest(const Point& from, double most,
                                                  const std::vector<RingVertex>& outer_ring,
                                                  Task& task, std::uint64_t step,
                                                  std::uint64_t most_steps) {
  const std::uint64_t visits_before = cover_.search().visits();
  last_steps_ = outer_ring.size();
  const Point relative = operands_.relative_place(from);
  nearest_edges_.set_goal(Goal::near(relative));
  NearestFree best(operands_, wanted_, cover_, nearest_edges_, from, relative, most, tally_);
  for (std::size_t k = 0; k < outer_ring.size(); ++k) {
    const RingVertex& start = outer_ring[k];
    const RingVertex& end = outer_ring[k + 1 < outer_ring.size() ? k + 1 : 0];
    const PlacesOnLine places(operands_, operands_.named(start.leaving()), tally_);
    best.take(places, places.place(start, start.arriving()), places.place(end, end.leaving()),
              true);
  }
  const auto steps = [&] { return last_steps_ + cover_.search().visits() - visits_before; };
  if (wanted_.holes || wanted_.fits) {
    known_.clear();
    nearest_edges_.for_each(
        best.reach(), [&](const PairEdge& s) { return known_.hold(s); },
        [&](const PairEdge& s) { cover_.walk(s, best); },
        [&] {
          if (++last_steps_ % steps_a_poll == 0) {
            task.poll();
          }
          task.advance(step);
          return steps() <= most_steps;
        });
  }
  if (wanted_.fits && steps() <= most_steps) {
    cover_.visit_touches(best, [&](const VertexSum& sum) { return best.is_near(sum); });
  }
  last_steps_ = steps();
  return last_steps_ <= most_steps ? best.found() : std::nullopt;
}

std::optional<FreePlace> FreePlaceSearch::nearest(const Point& from, const FreeBoundary& boundary) {
  last_steps_ = 0;
  const Point relative = operands_.relative_place(from);
  nearest_edges_.set_goal(Goal::near(relative));
  NearestFree best(operands_, wanted_, cover_, nearest_edges_, from, relative, infinity, tally_);
  boundary.for_each_near(relative, best.reach(), tally_,
                         [&](const PlacesOnLine& places, const Place& start, const Place& end,
                             bool is_of_ring) { best.take(places, start, end, is_of_ring); });
  return best.found();
}

// The furthest place of a ring, the lexicographically smallest of several, begins an edge that
// leads back, or neither on nor back and to lexicographically larger ones. So do segments, for one
// of two opposite directions.
std::optional<FreePlace> FreePlaceSearch::furthest(const Point& direction, const Wish& wish,
                                                   Task& task, std::uint64_t step) {
  nearest_edges_.set_goal(Goal::far(direction));
  FurthestFree best(operands_, wanted_, cover_, nearest_edges_, direction, wish, tally_);
  known_.clear();
  const auto leads_on = [&](const PairEdge& s) {
    const auto [from, to] = operands_.source(s);
    const int sign = sign_along(direction, from, to, tally_);
    return sign > 0 || (sign == 0 && lexicographically_less(to, from));
  };
  nearest_edges_.for_each(
      best.reach(),
      [&](const PairEdge& s) {
        return (!wish.is_for_corners && leads_on(s)) || best.is_behind(s) || known_.hold(s);
      },
      [&](const PairEdge& s) {
        if (!best.is_behind(s)) {
          cover_.walk(s, best);
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

bool FreePlaceSearch::holds(const PairEdge& edge, const ExactPoint& point) const {
  const SumEdge line = coordinates(operands_.a, operands_.b, edge);
  return side(line, point, tally_) == 0 &&
         side(perpendicular(line, line.origin), point, tally_) <= 0 &&
         side(perpendicular(line, operands_.end(edge)), point, tally_) >= 0;
}

std::vector<WitnessSearch::Pair> FreePlaceSearch::pairs_near(const FreePlace& place) {
  WitnessSearch& search = cover_.search();
  const SumEdge line = coordinates(operands_.a, operands_.b, place.edge);
  const Interval at = search.slack() < infinity ? place.parameter : Interval{0, 1};
  // On an outer ring the place may lie beyond the end of the edge.
  double length = 1;
  while (at.hi > length) {
    length *= 2;
  }
  return search.all_pairs_near(
      {operands_.relative_start(place.edge), length * line.dx, length * line.dy}, at.lo / length,
      at.hi / length);
}

}  // namespace gcv
