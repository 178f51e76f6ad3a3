// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "contributing_vertices.hpp"
#include "exact_ring.hpp"

namespace gcv {

// The edges of rings that are known, by the names of the superset edges that they lie on. A hash
// table with linear probing.
class KnownRuns {
 public:
  // From one vertex to the next, along superset edges on one line.
  struct Run {
    RingVertex from;
    RingVertex to;
  };

  void add(const std::vector<RingVertex>& ring) {
    reserve(runs_.size() + 2 * ring.size());
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Run run{ring[k], ring[k + 1 < ring.size() ? k + 1 : 0]};
      const EdgeName first = run.from.leaving();
      const EdgeName last = run.to.arriving();
      add(first, run);
      if (!are_equal(first, last)) {
        add(last, run);
      }
    }
  }

  // Calls visit(run) for the runs of which the edge with that name is the first or the last one.
  template <class Visit>
  void for_each(const EdgeName& edge, Visit visit) const {
    if (slots_.empty()) {
      return;
    }
    for (std::uint32_t k = slots_[slot_of(edge)]; k != none; k = runs_[k].next) {
      visit(runs_[k].run);
    }
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  struct Entry {
    EdgeName edge;
    Run run;
    std::uint32_t next;  // of the same edge
  };

  static bool are_equal(const EdgeName& e, const EdgeName& f) {
    return e.kind == f.kind && e.i == f.i && e.j == f.j;
  }

  // The slot that holds the runs of the edge, or where they would be.
  [[nodiscard]] std::size_t slot_of(const EdgeName& edge) const {
    std::uint64_t hash = (std::uint64_t{edge.i} << 32U | edge.j) * 0x9e3779b97f4a7c15U + edge.kind;
    hash ^= hash >> 32U;
    std::size_t slot = hash & (slots_.size() - 1);
    while (slots_[slot] != none && !are_equal(runs_[slots_[slot]].edge, edge)) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slot;
  }
  void add(const EdgeName& edge, const Run& run) {
    runs_.push_back({edge, run, none});
    insert(static_cast<std::uint32_t>(runs_.size() - 1));
  }
  void insert(std::uint32_t k) {
    std::uint32_t& slot = slots_[slot_of(runs_[k].edge)];
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

  std::vector<Entry> runs_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace gcv
