// SPDX-License-Identifier: LGPL-3.0-or-later
#include "known_runs.hpp"

#include <cstddef>

#include "predicates.hpp"
#include "vector.hpp"

namespace gcv {

KnownRuns::KnownRuns(const Operands& operands, double slack, Tally& tally)
    : operands_(operands),
      slack_(slack),
      tally_(tally),
      directions_(2 * std::size_t{operands.directions.half_turn}),
      lines_(operands, slack, tally) {}

void KnownRuns::add(const std::vector<RingVertex>& ring, Task& task) {
  for (std::size_t k = 0; k < ring.size(); ++k) {
    if (k % Task::portion == Task::portion - 1) {
      task.poll();
    }
    const auto number = static_cast<std::uint32_t>(runs_.size());
    const Run run{ring[k], ring[k + 1 < ring.size() ? k + 1 : 0]};
    Direction& direction = directions_[edge_of(run).rank];
    runs_.push_back({run, direction.last});
    direction.last = number;
    ++direction.runs;
    if (direction.runs == few + 1) {  // those before as well
      for (std::uint32_t other = runs_[number].before; other != none; other = runs_[other].before) {
        add_to_line(other);
      }
    }
    if (direction.runs > few) {
      add_to_line(number);
    }
  }
}

bool KnownRuns::lie_on_one_line(const Run& run, const PairEdge& edge) {
  const EdgeName& name = edge;
  const EdgeName first = run.from.leaving();
  return name == first || name == run.to.arriving() ||
         side(coordinates(operands_.a, operands_.b, edge), operands_.start(first), tally_) == 0;
}

void KnownRuns::add_to_line(std::uint32_t number) {
  const Run& run = runs_[number].run;
  lines_.at(edge_of(run)).push_back({places_of(run), number});
}

Interval KnownRuns::places_of(const PairEdge& edge) const {
  const auto [from, to] = operands_.source(edge);
  const Point unit = unit_vector(direction(from, to));
  const auto along = [&](const Point& p) { return unit.x * p.x + unit.y * p.y; };
  return {along(operands_.relative_start(edge)) - slack_,
          along(operands_.relative_end(edge)) + slack_};
}

// A crossing lies on the edge that leaves, or arrives, at that parameter.
Interval KnownRuns::places_of(const Run& run) const {
  const auto at = [&](const EdgeName& e) { return coordinates(operands_.a, operands_.b, e); };
  const auto place = [&](const RingVertex& v, const EdgeName& edge, const EdgeName& other) {
    const Interval whole = places_of(operands_.named(edge));
    if (v.is_sum()) {
      const auto [from, to] = operands_.source(operands_.named(edge));
      const Point unit = unit_vector(direction(from, to));
      const Point p = operands_.relative(v.i(), v.j());
      const double along = unit.x * p.x + unit.y * p.y;
      return Interval{along - slack_, along + slack_};
    }
    const Interval parameter = crossing_parameter(at(edge), at(other));
    const double length = whole.hi - whole.lo;
    return Interval{whole.lo + parameter.lo * length, whole.lo + parameter.hi * length};
  };
  return {place(run.from, run.from.leaving(), run.from.arriving()).lo - 4 * slack_,
          place(run.to, run.to.arriving(), run.to.leaving()).hi + 4 * slack_};
}

}  // namespace gcv
