// SPDX-License-Identifier: LGPL-3.0-or-later
#include "free_place.hpp"

#include <algorithm>
#include <cmath>

#include "best_free.hpp"
#include "gap.hpp"
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

}  // namespace

FreePlaceSearch::FreePlaceSearch(const Operands& operands, const WantedParts& wanted, Tally& tally)
    : operands_(operands),
      wanted_(wanted),
      tally_(tally),
      cover_(operands, tally),
      nearest_edges_(operands, cover_.search()),
      walked_(operands, cover_.search().slack(), tally) {}

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
    walked_.clear();
    nearest_edges_.for_each(
        best.reach(), [](const PairEdge& /*s*/) { return true; },
        [&](const PairEdge& s) { walk(s, best); },
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

std::vector<WitnessSearch::Pair> FreePlaceSearch::pairs_near(const FreePlace& place) {
  WitnessSearch& search = cover_.search();
  const SumEdge edge = coordinates(operands_.a, operands_.b, place.edge);
  const Interval at = search.slack() < infinity ? place.parameter : Interval{0, 1};
  // The place may lie beyond either end of the edge: on an outer ring, or on a segment.
  const double towards = at.hi < 0 ? -1 : 1;
  double length = towards;
  while (std::max(-at.lo, at.hi) > length * towards) {
    length *= 2;
  }
  const RelativeLine line{operands_.relative_start(place.edge), length * edge.dx, length * edge.dy};
  const auto [from, to] = std::minmax({at.lo / length, at.hi / length});
  return search.all_pairs_near(line, from, to);
}

}  // namespace gcv
