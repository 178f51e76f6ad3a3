// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "contributing_vertices.hpp"
#include "edge_lines.hpp"
#include "exact_ring.hpp"
#include "tally.hpp"
#include "task.hpp"

namespace gcv {

// The edges of rings that are known, by the lines that they lie on. Superset edges overlap, so that
// an edge can lie on the line of a run that has no name of it. If a direction has few runs, these
// are asked one by one.
class KnownRuns {
 public:
  // `slack`: how far coordinates of points in relative coordinates may be off.
  KnownRuns(const Operands& operands, double slack, Tally& tally);

  // From one vertex to the next, along superset edges on one line.
  struct Run {
    RingVertex from;
    RingVertex to;
  };

  void add(const std::vector<RingVertex>& ring, Task& task);

  // Calls visit(run) for the runs on the line of the edge that come near it.
  template <class Visit>
  void for_each(const PairEdge& edge, Visit visit) {
    const Direction& direction = directions_[edge.rank];
    if (direction.runs <= few) {
      for (std::uint32_t k = direction.last; k != none; k = runs_[k].before) {
        if (lie_on_one_line(runs_[k].run, edge)) {
          visit(runs_[k].run);
        }
      }
    } else if (const std::vector<Stretch>* const stretches = lines_.find(edge)) {
      const Interval along = places_of(edge);
      for (const Stretch& stretch : *stretches) {
        if (order_of(stretch.places, along) == 0) {
          visit(runs_[stretch.run].run);
        }
      }
    }
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  // bench/regions takes the same time with 6 and with 16.
  static constexpr std::uint32_t few = 16;

  struct Entry {
    Run run;
    std::uint32_t before;  // in the same direction
  };
  struct Direction {
    std::uint32_t runs = 0;
    std::uint32_t last = none;
  };
  // Where a run lies on its line, in doubles.
  struct Stretch {
    Interval places;
    std::uint32_t run;
  };

  [[nodiscard]] PairEdge edge_of(const Run& run) const {
    return operands_.named(run.from.leaving());
  }
  bool lie_on_one_line(const Run& run, const PairEdge& edge);
  void add_to_line(std::uint32_t number);
  // From the start of an edge to its end; of a run.
  [[nodiscard]] Interval places_of(const PairEdge& edge) const;
  [[nodiscard]] Interval places_of(const Run& run) const;

  const Operands& operands_;
  double slack_;
  Tally& tally_;
  std::vector<Direction> directions_;  // by rank
  std::vector<Entry> runs_;
  EdgeLines<std::vector<Stretch>> lines_;  // in directions of many runs
};

}  // namespace gcv
