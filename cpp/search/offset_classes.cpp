// SPDX-License-Identifier: LGPL-3.0-or-later
#include "offset_classes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "predicates.hpp"

namespace gcv {

OffsetClasses::OffsetClasses(const Boundary& polygon, const Ranks& ranks,
                             const Directions& directions, const Direction& direction)
    : polygon_(polygon),
      by_x_(direction.from.x != direction.to.x),
      sign_(by_x_ ? (direction.from.x < direction.to.x ? 1 : -1)
                  : (direction.from.y < direction.to.y ? 1 : -1)) {
  number_classes(direction);
  take_ranges();
  take_members(ranks, directions, direction.rank);
}

// By offsets in doubles first. Where that is not the exact order, by exact comparisons.
void OffsetClasses::number_classes(const Direction& direction) {
  const double dx = direction.to.x - direction.from.x;
  const double dy = direction.to.y - direction.from.y;
  const Index n = polygon_.size();
  std::vector<double> offsets(n);
  for (Index v = 0; v < n; ++v) {
    const Point p = polygon_.relative(v);
    offsets[v] = dx * p.y - dy * p.x;
  }
  is_valid_ =
      std::all_of(offsets.begin(), offsets.end(), [](double x) { return std::isfinite(x); });
  Tally tally;
  // 1 where v is further to the left than u.
  const auto compare = [&](Index u, Index v) {
    return turn(direction.from, direction.to, polygon_.vertices[u], polygon_.vertices[v], tally);
  };
  std::vector<Index> order(n);
  std::iota(order.begin(), order.end(), Index{0});
  if (is_valid_) {
    std::sort(order.begin(), order.end(),
              [&](Index u, Index v) { return offsets[u] < offsets[v]; });
    const bool is_in_order = std::adjacent_find(order.begin(), order.end(), [&](Index u, Index v) {
                               return compare(u, v) < 0;
                             }) == order.end();
    if (!is_in_order) {
      std::sort(order.begin(), order.end(), [&](Index u, Index v) { return compare(u, v) > 0; });
    }
  }
  class_of_.resize(n);
  for (const Index v : order) {
    if (representatives_.empty() || compare(representatives_.back(), v) != 0) {
      representatives_.push_back(v);
    }
    class_of_[v] = size() - 1;
  }
}

void OffsetClasses::take_ranges() {
  constexpr std::uint32_t width = ChainTree::width;
  const ChainTree& tree = polygon_.index().tree;
  const std::vector<std::uint32_t>& first_block = tree.first_block;
  constexpr Range none{std::numeric_limits<Index>::max(), 0};
  ranges_.assign(tree.blocks.size(), {none, none, none, none});
  for (Index i = 0; i < polygon_.size(); ++i) {
    const auto [low, high] = std::minmax(class_of_[i], class_of_[polygon_.next(i)]);
    ranges_[first_block.back() + i / width][i % width] = {low, high};
  }
  for (std::size_t depth = first_block.size() - 1; depth-- > 0;) {
    const std::uint32_t children = first_block[depth + 1];
    const std::size_t end =
        depth + 2 < first_block.size() ? first_block[depth + 2] : ranges_.size();
    for (std::uint32_t k = 0; children + k < end; ++k) {
      Range& range = ranges_[first_block[depth] + k / width][k % width];
      for (const Range& child : ranges_[children + k]) {
        range = {std::min(range.lowest, child.lowest), std::max(range.highest, child.highest)};
      }
    }
  }
}

OffsetClasses::Range OffsetClasses::range(const ChainTree::Node& node) const {
  if (node.depth == 0) {
    return {0, size() - 1};
  }
  const std::uint32_t block =
      polygon_.index().tree.first_block[node.depth - 1] + node.index / ChainTree::width;
  return ranges_[block][node.index % ChainTree::width];
}

void OffsetClasses::take_members(const Ranks& ranks, const Directions& directions, Rank rank) {
  for (Index v = 0; v < polygon_.size(); ++v) {
    if (ranks[v] == rank) {
      edges_.push_back(v);
    }
    const Rank in = ranks[polygon_.previous(v)];
    if (polygon_.corners[v].convex &&
        directions.angle(in, rank) <= directions.angle(in, ranks[v])) {
      contributing_.push_back(v);
    }
  }
  const auto comes_before = [&](Index u, Index v) {
    return class_of_[u] < class_of_[v] || (class_of_[u] == class_of_[v] && along(u) < along(v));
  };
  // Where the members of each class begin.
  const auto first_of_classes = [&](std::vector<Index>& members) {
    std::sort(members.begin(), members.end(), comes_before);
    std::vector<std::size_t> first(representatives_.size() + 1);
    for (const Index v : members) {
      ++first[class_of_[v] + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    return first;
  };
  first_edge_ = first_of_classes(edges_);
  first_contributing_ = first_of_classes(contributing_);
  std::vector<Gap> gaps(contributing_.size(), Gap::infinite());
  for (std::size_t k = 0; k + 1 < gaps.size(); ++k) {
    const Index u = contributing_[k];
    const Index v = contributing_[k + 1];
    if (class_of_[u] == class_of_[v]) {
      gaps[k] = Gap::between(along(u), along(v));
      is_valid_ = is_valid_ && std::isfinite(gaps[k].hi);
    }
  }
  gaps_ = GapTree(gaps);
}

}  // namespace gcv
