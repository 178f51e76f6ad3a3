// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "contributing_vertices.hpp"
#include "exact_ring.hpp"
#include "predicates.hpp"
#include "tally.hpp"

namespace gcv {

// The edges of rings that are known. Found by the names of the superset edges that they lie on, in
// a hash table with linear probing. Where several edges have one direction, an edge can lie on the
// line of a run that has no name of it: if the direction has few runs, they are found by that.
class KnownRuns {
 public:
  KnownRuns(const Operands& operands, Tally& tally)
      : operands_(operands),
        tally_(tally),
        directions_(2 * std::size_t{operands.directions.half_turn}) {}

  // From one vertex to the next, along superset edges on one line.
  struct Run {
    RingVertex from;
    RingVertex to;
  };

  void add(const std::vector<RingVertex>& ring) {
    reserve(runs_.size() + ring.size());
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const auto number = static_cast<std::uint32_t>(runs_.size());
      const Run run{ring[k], ring[k + 1 < ring.size() ? k + 1 : 0]};
      Direction& direction = directions_[operands_.named(run.from.leaving()).rank];
      runs_.push_back({run, none, direction.last});
      direction.last = number;
      ++direction.runs;
      insert(number);
    }
  }

  // Calls visit(run) for the runs along the edge: all of them, or those that begin by its name.
  template <class Visit>
  void for_each(const PairEdge& edge, Visit visit) const {
    const Direction& direction = directions_[edge.rank];
    if (direction.runs <= few) {
      const SumEdge line = coordinates(operands_.a, operands_.b, edge);
      for (std::uint32_t k = direction.last; k != none; k = runs_[k].before) {
        const Run& run = runs_[k].run;
        const EdgeName other = run.from.leaving();
        if (are_equal(other, edge) || are_equal(run.to.arriving(), edge) ||
            side(line, operands_.start(other), tally_) == 0) {
          visit(run);
        }
      }
    } else if (!slots_.empty()) {
      for (std::uint32_t k = slots_[slot_of(edge)]; k != none; k = runs_[k].next) {
        visit(runs_[k].run);
      }
    }
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  static constexpr std::uint32_t few = 16;

  struct Entry {
    Run run;
    std::uint32_t next;    // of the same edge
    std::uint32_t before;  // in the same direction
  };
  struct Direction {
    std::uint32_t runs = 0;
    std::uint32_t last = none;
  };

  static bool are_equal(const EdgeName& e, const EdgeName& f) {
    return e.kind == f.kind && e.i == f.i && e.j == f.j;
  }

  // The slot that holds the runs of the edge, or where they would be.
  [[nodiscard]] std::size_t slot_of(const EdgeName& edge) const {
    std::uint64_t hash = (std::uint64_t{edge.i} << 32U | edge.j) * 0x9e3779b97f4a7c15U + edge.kind;
    hash ^= hash >> 32U;
    std::size_t slot = hash & (slots_.size() - 1);
    while (slots_[slot] != none && !are_equal(runs_[slots_[slot]].run.from.leaving(), edge)) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slot;
  }
  void insert(std::uint32_t k) {
    std::uint32_t& slot = slots_[slot_of(runs_[k].run.from.leaving())];
    runs_[k].next = slot;
    slot = k;
  }
  // At least twice as many slots as runs, a power of two.
  void reserve(std::size_t count) {
    if (slots_.size() >= 2 * count) {
      return;
    }
    std::size_t size = slots_.empty() ? 64 : slots_.size();
    while (size < 2 * count) {
      size *= 2;
    }
    slots_.assign(size, none);
    for (std::uint32_t k = 0; k < runs_.size(); ++k) {
      insert(k);
    }
  }

  const Operands& operands_;
  Tally& tally_;
  std::vector<Direction> directions_;  // by rank
  std::vector<Entry> runs_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace gcv
