// SPDX-License-Identifier: LGPL-3.0-or-later
#include "equal_chains.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>

#include "limits.hpp"

namespace gcv {

namespace {

constexpr Rank no_turn = std::numeric_limits<Rank>::max();

// An edge, but for its place: the exact way from its start to its end as two sums of doubles, and
// the rank from which the boundary turns to it, if that matters.
using EdgeKey = std::array<std::uint64_t, 5>;

// The numbers of the chains below a node; 0 stands for a missing one.
using ChainKey = std::array<std::uint32_t, ChainTree::width>;

struct Hash {
  template <class Key>
  std::size_t operator()(const Key& key) const {
    std::uint64_t hash = 0;
    for (const auto part : key) {
      hash = (hash ^ part) * 0x9e3779b97f4a7c15;
      hash ^= hash >> 32U;
    }
    return static_cast<std::size_t>(hash);
  }
};

template <class Key>
using NumberOf = std::unordered_map<Key, std::uint32_t, Hash>;

// Numbers the edges and the chains of both polygons.
class Numbering {
 public:
  explicit Numbering(const Operands& operands) : operands_(operands) {}

  // Nothing where few are repeated, or where numbers overflow.
  EqualChains chains() {
    const Directions& directions = operands_.directions;
    const std::optional<Edges> a = number_edges(operands_.a, directions.rank_a, Turns::convex);
    const std::optional<Edges> b = number_edges(operands_.b, directions.rank_b, Turns::convex);
    if (!a || !b || edge_numbers_.size() > at_most(a->size() + b->size())) {
      return {};
    }
    EqualChains chains{number_chains(operands_.a.index().tree, *a),
                       number_chains(operands_.b.index().tree, *b), false};
    const std::size_t all = chains.a.size() + chains.b.size();
    if (chain_numbers_.size() > at_most(all)) {
      return {};
    }
    chains.prevail = limits::chains_a_different_one * chain_numbers_.size() <= all;
    return chains;
  }

  // Likewise.
  EqualNodes nodes() {
    const Directions& directions = operands_.directions;
    const std::optional<Edges> a = number_edges(operands_.a, directions.rank_a, Turns::all);
    const std::size_t different = std::exchange(edge_numbers_, {}).size();
    const std::optional<Edges> b = number_edges(operands_.b, directions.rank_b, Turns::all);
    if (!a || !b || different + edge_numbers_.size() > at_most(a->size() + b->size())) {
      return {};
    }
    const ChordTree& tree_a = operands_.a.cover_index().chords;
    const ChordTree& tree_b = operands_.b.cover_index().chords;
    return {number_nodes(tree_a, *a), number_nodes(tree_b, *b),
            tree_a.chains_repeat && tree_b.chains_repeat};
  }

 private:
  using Edges = std::vector<std::uint32_t>;
  enum class Turns { convex, all };  // that matter

  // How many different ones there may be of so many.
  static std::size_t at_most(std::size_t all) {
    return all - all / 4 * (4 - limits::different_of_four);
  }

  template <class Key>
  std::uint32_t number(NumberOf<Key>& numbers, const Key& key) {
    const auto [place, is_new] = numbers.try_emplace(key, last_ + 1);
    last_ += is_new ? 1 : 0;
    return place->second;
  }

  // Nothing where a coordinate of an edge overflows.
  std::optional<Edges> number_edges(const Boundary& polygon, const Ranks& ranks, Turns turns) {
    Edges edges(polygon.size());
    for (Index i = 0; i < polygon.size(); ++i) {
      const Point& p = polygon.vertices[i];
      const Point& q = polygon.vertices[polygon.next(i)];
      const DoubleDouble x = two_sum(q.x, -p.x);
      const DoubleDouble y = two_sum(q.y, -p.y);
      if (!x.is_exact || !y.is_exact) {
        return std::nullopt;
      }
      const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value + 0.0); };
      const bool matters = turns == Turns::all || polygon.corners[i].convex;
      const EdgeKey key{bits(x.hi), bits(x.lo), bits(y.hi), bits(y.lo),
                        matters ? ranks[polygon.previous(i)] : no_turn};
      // Where another ring starts, chains go on elsewhere.
      edges[i] = polygon.layout.starts_another(i) ? ++last_ : number(edge_numbers_, key);
    }
    return edges;
  }

  EqualChains::Numbers number_chains(const ChainTree& tree, const Edges& edges) {
    constexpr std::uint32_t width = ChainTree::width;
    EqualChains::Numbers numbers(tree.blocks.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
      numbers[tree.first_block.back() + i / width][i % width] = edges[i];
    }
    for (std::size_t depth = tree.first_block.size() - 1; depth > 0; --depth) {
      const std::uint32_t first = tree.first_block[depth];
      const std::size_t end =
          depth + 1 < tree.first_block.size() ? tree.first_block[depth + 1] : numbers.size();
      for (std::uint32_t k = 0; first + k < end; ++k) {
        numbers[tree.first_block[depth - 1] + k / width][k % width] =
            number(chain_numbers_, numbers[first + k]);
      }
    }
    return numbers;
  }

  std::vector<EqualNodes::Node> number_nodes(const ChordTree& tree, const Edges& edges) {
    constexpr std::uint32_t width = ChordTree::width;
    std::vector<EqualNodes::Node> nodes(tree.blocks.size() * width);
    for (std::size_t k = nodes.size(); k-- > 0;) {
      const auto node = static_cast<ChordTree::Node>(k);
      if ((tree.block_of(node).lanes >> ChordTree::lane_of(node) & 1U) == 0) {
        continue;
      }
      const std::uint32_t below = tree.below(node);
      if (tree.is_edge(node)) {
        nodes[k] = {edges[below], below};
        continue;
      }
      ChainKey key;
      for (std::uint32_t lane = 0; lane < width; ++lane) {
        key[lane] = nodes[ChordTree::node(below, lane)].number;
      }
      nodes[k] = {number(chain_numbers_, key), nodes[ChordTree::node(below, 0)].first};
    }
    return nodes;
  }

  const Operands& operands_;
  NumberOf<EdgeKey> edge_numbers_;
  NumberOf<ChainKey> chain_numbers_;
  std::uint32_t last_ = 0;
};

// Does each line direction belong to so many edges on average, and has each polygon enough of them?
bool directions_are_repeated(const Operands& operands, std::size_t times) {
  const Index a = operands.a.size();
  const Index b = operands.b.size();
  // Chains are found by differences of vertices, and their places by sums of two.
  if (!operands.a.positions.empty()) {
    return false;
  }
  return std::min(a, b) >= limits::fewest_edges_with_equal_chains &&
         times * operands.directions.half_turn <= std::size_t{a} + b;
}

}  // namespace

bool chains_can_prevail(const Operands& operands) {
  return directions_are_repeated(operands, limits::edges_a_direction_to_prevail);
}

EqualChains find_equal_chains(const Operands& operands) {
  return directions_are_repeated(operands, limits::edges_a_direction) ? Numbering(operands).chains()
                                                                      : EqualChains{};
}

EqualNodes find_equal_nodes(const Operands& operands) {
  return directions_are_repeated(operands, limits::edges_a_direction) ? Numbering(operands).nodes()
                                                                      : EqualNodes{};
}

}  // namespace gcv
