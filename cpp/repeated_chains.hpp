// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Chains of edges that occur more than once in two polygons, but for their places: the teeth of
// combs and gears, steps of stairs, and all chains of a polygon that is summed with itself. Where
// chains are exchanged for such others, and the sums of their starts are equal, the superset edges
// made from both pairs coincide, and a search needs to meet only one of them.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "chain_tree.hpp"
#include "contributing_vertices.hpp"
#include "doubled.hpp"

namespace gcv {

// Numbers for the chains below the nodes of both trees. Chains have the same number only where
// their edges have the same directions and lengths, exactly, and their convex vertices contribute
// to the same directions.
struct RepeatedChains {
  // The numbers of the chains of the children in each block of a tree.
  using Numbers = std::vector<std::array<std::uint32_t, ChainTree::width>>;

  Numbers a;  // empty where few chains are repeated
  Numbers b;
  bool prevail = false;  // there are four times as many chains as different ones, or more

  [[nodiscard]] bool exist() const { return !a.empty(); }
};

// O((n + m) log(n + m)); O(1) where the directions of the edges tell that few are repeated.
RepeatedChains find_repeated_chains(const Operands& operands);

// Do the directions of the edges allow that repeated chains prevail? O(1).
bool chains_can_prevail(const Operands& operands);

// The pairs of chains, one of each polygon, that a search has met lately.
class PairsMet {
 public:
  // Forgets all of them.
  void clear() { ++search_; }

  // Has it met these chains, or such others, whose starts have the same sum? From now on it has.
  bool meet(std::uint32_t a, std::uint32_t b, const SumPoint& start) {
    const auto [low, high] = std::minmax(a, b);  // of a polygon with itself, both are the same
    const DoubledNumber x = doubled_sum(start.a.x, start.b.x);
    const DoubledNumber y = doubled_sum(start.a.y, start.b.y);
    Entry& entry = entries_[place(low, high, x.head, y.head)];
    const bool met = entry.search == search_ && entry.low == low && entry.high == high &&
                     entry.x == x.head && entry.x_tail == x.tail && entry.y == y.head &&
                     entry.y_tail == y.tail;
    if (!met) {
      entry = {search_, low, high, x.head, x.tail, y.head, y.tail};
    }
    return met;
  }

 private:
  static constexpr unsigned bits = 10;

  struct Entry {
    std::uint64_t search = 0;
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    double x = 0;  // of the start
    double x_tail = 0;
    double y = 0;
    double y_tail = 0;
  };

  static std::size_t place(std::uint32_t low, std::uint32_t high, double x, double y) {
    constexpr std::uint64_t factor = 0x9e3779b97f4a7c15;
    std::uint64_t hash = (std::uint64_t{high} << 32U | low) * factor;
    hash = (hash ^ hash >> 32U ^ std::bit_cast<std::uint64_t>(x + 0.0)) * factor;
    hash = (hash ^ hash >> 32U ^ std::bit_cast<std::uint64_t>(y + 0.0)) * factor;
    return hash >> (64 - bits);
  }

  std::uint64_t search_ = 1;
  std::vector<Entry> entries_ = std::vector<Entry>(std::size_t{1} << bits);
};

}  // namespace gcv
