// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Two chains are equal if their edges have the same directions and lengths: the teeth of combs and
// gears, the steps of stairs, all chains of a polygon that is summed with itself. Two pairs of
// equal chains whose start points have the same sum produce the same superset edges. The search
// visits one of the pairs.
//
// Off in bench/ as "libgcv without equal chains". docs/PERFORMANCE.md has the ratios.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "chain_tree.hpp"
#include "contributing_vertices.hpp"
#include "double_double.hpp"

namespace gcv {

// Numbers for the chains below the nodes of both trees. Chains have the same number only where
// their edges have the same directions and lengths, exactly, and their convex vertices contribute
// to the same directions.
struct EqualChains {
  // The numbers of the chains of the children in each block of a tree.
  using Numbers = std::vector<std::array<std::uint32_t, ChainTree::width>>;

  Numbers a;  // empty where few chains are equal
  Numbers b;
  bool prevail = false;  // there are four times as many chains as different ones, or more

  [[nodiscard]] bool exist() const { return !a.empty(); }
};

// O(n + m); O(1) where the directions of the edges tell that few are repeated.
EqualChains find_equal_chains(const Operands& operands);

// Numbers for the nodes of both trees of chords. Nodes of one tree have the same number only where
// the edges below them, one after the other, and the edge before these have the same directions and
// lengths, exactly.
struct EqualNodes {
  struct Node {
    std::uint32_t number;
    Index first;  // of the edges below it
  };

  std::vector<Node> a;   // empty where few edges are equal
  std::vector<Node> b;   // with other numbers than those of A
  bool prevail = false;  // chains of both repeat, and are split alike

  [[nodiscard]] bool exist() const { return !a.empty(); }
};

// O(n + m); O(1) where the directions of the edges tell that few are repeated.
EqualNodes find_equal_nodes(const Operands& operands);

// Do the directions of the edges allow that repeated chains prevail? O(1).
bool chains_can_prevail(const Operands& operands);

// The pairs of chains, one of each polygon, that a search has met lately.
class VisitedPairs {
 public:
  // Forgets all of them.
  void clear() { ++search_; }

  // Has it met these chains, or such others, whose starts have the same sum? From now on it has.
  bool meet(std::uint32_t a, std::uint32_t b, const SumPoint& start) {
    const auto [low, high] = std::minmax(a, b);  // of a polygon with itself, both are the same
    Entry& entry = entries_[place(low, high, start)];
    const bool again = entry.search == search_ && entry.low == low && entry.high == high &&
                       are_equal_sums(entry.start, start);
    if (!again) {
      entry = {search_, low, high, start};
    }
    ++meetings_;
    meetings_again_ += again ? 1 : 0;
    return again;
  }

  // Do searches meet one of so many of them again, as far as is known?
  [[nodiscard]] bool is_of_use(std::uint64_t one_of) const {
    return meetings_ < many || meetings_again_ >= meetings_ / one_of;
  }

 private:
  static constexpr unsigned bits = 10;
  static constexpr std::uint64_t many = 4096;

  struct Entry {
    std::uint64_t search = 0;
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    SumPoint start{};
  };

  static std::size_t place(std::uint32_t low, std::uint32_t high, const SumPoint& start) {
    constexpr std::uint64_t factor = 0x9e3779b97f4a7c15;
    const double x = start.a.x + start.b.x + 0.0;
    const double y = start.a.y + start.b.y + 0.0;
    std::uint64_t hash = (std::uint64_t{high} << 32U | low) * factor;
    hash = (hash ^ hash >> 32U ^ std::bit_cast<std::uint64_t>(x)) * factor;
    hash = (hash ^ hash >> 32U ^ std::bit_cast<std::uint64_t>(y)) * factor;
    return hash >> (64 - bits);
  }

  static bool are_equal_sums(const SumPoint& p, const SumPoint& q) {
    const auto are_equal = [](double a, double b, double c, double d) {
      const double sum = a + b;
      return sum == c + d && rounding_error(a, b, sum) == rounding_error(c, d, sum);
    };
    return are_equal(p.a.x, p.b.x, q.a.x, q.b.x) && are_equal(p.a.y, p.b.y, q.a.y, q.b.y);
  }

  std::uint64_t search_ = 1;
  std::uint64_t meetings_ = 0;
  std::uint64_t meetings_again_ = 0;
  std::vector<Entry> entries_ = std::vector<Entry>(std::size_t{1} << bits);
};

}  // namespace gcv
