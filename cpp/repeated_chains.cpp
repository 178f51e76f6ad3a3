// SPDX-License-Identifier: LGPL-3.0-or-later
#include "repeated_chains.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace gcv {

namespace {

// Sums with a polygon of fewer edges are quick as they are.
constexpr Index fewest_edges = 64;

constexpr Rank no_cone = std::numeric_limits<Rank>::max();

// An edge, but for its place: the exact way from its start to its end as two sums of doubles, and
// the rank from which the cone of its start turns to it.
using EdgeKey = std::array<std::uint64_t, 5>;

// The numbers of the chains below a node; 0 stands for a missing one.
using ChainKey = std::array<std::uint32_t, ChainTree::width>;

// Numbers the edges and the chains of both polygons.
class Numbering {
 public:
  explicit Numbering(const Operands& operands)
      : operands_(operands),
        edges_(std::size_t{operands.a.size()} + operands.b.size()),
        chains_(operands.a.index().tree.blocks.size() + operands.b.index().tree.blocks.size()) {}

  // Nothing where few are repeated, or where numbers overflow.
  RepeatedChains run() {
    RepeatedChains numbers;
    const Directions& directions = operands_.directions;
    if (!number_edges(operands_.a, directions.rank_a, numbers.a) ||
        !number_edges(operands_.b, directions.rank_b, numbers.b) ||
        !are_repeated(edge_numbers_.size(), edges_)) {
      return {};
    }
    number_chains(operands_.a.index().tree, numbers.a);
    number_chains(operands_.b.index().tree, numbers.b);
    return are_repeated(chain_numbers_.size(), chains_) ? numbers : RepeatedChains{};
  }

 private:
  static bool are_repeated(std::size_t different, std::size_t all) {
    return different <= all - all / 4;
  }

  template <class Key>
  std::uint32_t number(std::map<Key, std::uint32_t>& numbers, const Key& key) {
    const auto [place, is_new] = numbers.try_emplace(key, last_ + 1);
    last_ += is_new ? 1 : 0;
    return place->second;
  }

  // False where a coordinate of an edge overflows.
  bool number_edges(const Polygon& polygon, const Ranks& ranks, RepeatedChains::Numbers& numbers) {
    const ChainTree& tree = polygon.index().tree;
    numbers.resize(tree.blocks.size());
    for (Index i = 0; i < polygon.size(); ++i) {
      const Point& p = polygon.vertices[i];
      const Point& q = polygon.vertices[polygon.next(i)];
      const DoubledNumber x = doubled_sum(q.x, -p.x);
      const DoubledNumber y = doubled_sum(q.y, -p.y);
      if (!x.is_exact || !y.is_exact) {
        return false;
      }
      const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value + 0.0); };
      const EdgeKey key{bits(x.head), bits(x.tail), bits(y.head), bits(y.tail),
                        polygon.convex[i] != 0 ? ranks[polygon.previous(i)] : no_cone};
      numbers[tree.first_block.back() + i / ChainTree::width][i % ChainTree::width] =
          number(edge_numbers_, key);
    }
    return true;
  }

  void number_chains(const ChainTree& tree, RepeatedChains::Numbers& numbers) {
    for (std::size_t depth = tree.first_block.size() - 1; depth > 0; --depth) {
      const std::uint32_t first = tree.first_block[depth];
      const std::size_t end =
          depth + 1 < tree.first_block.size() ? tree.first_block[depth + 1] : numbers.size();
      for (std::uint32_t k = 0; first + k < end; ++k) {
        numbers[tree.first_block[depth - 1] + k / ChainTree::width][k % ChainTree::width] =
            number(chain_numbers_, numbers[first + k]);
      }
    }
  }

  const Operands& operands_;
  std::size_t edges_;
  std::size_t chains_;
  std::map<EdgeKey, std::uint32_t> edge_numbers_;
  std::map<ChainKey, std::uint32_t> chain_numbers_;
  std::uint32_t last_ = 0;
};

}  // namespace

RepeatedChains find_repeated_chains(const Operands& operands) {
  const Index a = operands.a.size();
  const Index b = operands.b.size();
  const std::size_t directions = operands.directions.half_turn;
  const bool can_exist = std::min(a, b) >= fewest_edges && 2 * directions <= std::size_t{a} + b;
  return can_exist ? Numbering(operands).run() : RepeatedChains{};
}

}  // namespace gcv
