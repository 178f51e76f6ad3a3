// SPDX-License-Identifier: LGPL-3.0-or-later
#include "walked_lines.hpp"

#include <algorithm>
#include <iterator>

#include "predicates.hpp"

namespace gcv {

WalkedLines::WalkedLines(const Operands& operands, double slack, Tally& tally)
    : operands_(operands),
      tally_(tally),
      edges_of_rank_(2 * std::size_t{operands.directions.half_turn}),
      lines_(operands, slack, tally) {
  for (const Ranks* ranks : {&operands.directions.rank_a, &operands.directions.rank_b}) {
    for (const Rank rank : *ranks) {
      ++edges_of_rank_[rank];
    }
  }
}

int WalkedLines::compare_along(const PairEdge& s, const VertexSum& p, const VertexSum& q) {
  return p == q ? 0
                : gcv::compare_along(operands_, s, operands_.point(p), operands_.point(q), tally_);
}

std::span<const WalkedLines::Part> WalkedLines::left_of(const PairEdge& s) {
  const Part part{start_of(s), end_of(operands_, s)};
  left_.clear();
  if (edges_of_rank_[s.rank] == 1) {
    left_.push_back(part);
    return left_;
  }
  std::vector<Part>& parts = lines_.at(s);
  // Those that end before it begins, and then those that begin before it ends.
  const auto first = std::partition_point(parts.begin(), parts.end(), [&](const Part& other) {
    return compare_along(s, other.to, part.from) > 0;
  });
  const auto last = std::partition_point(first, parts.end(), [&](const Part& other) {
    return compare_along(s, other.from, part.to) >= 0;
  });
  VertexSum from = part.from;
  std::for_each(first, last, [&](const Part& other) {
    if (compare_along(s, from, other.from) > 0) {
      left_.push_back({from, other.from});
    }
    from = other.to;
  });
  if (compare_along(s, from, part.to) > 0) {
    left_.push_back({from, part.to});
  }
  if (first == last) {
    parts.insert(first, part);
  } else if (!left_.empty()) {
    const Part& one = *first;
    const Part& other = *std::prev(last);
    *first = {compare_along(s, part.from, one.from) > 0 ? part.from : one.from,
              compare_along(s, other.to, part.to) > 0 ? part.to : other.to};
    parts.erase(std::next(first), last);
  }
  return left_;
}

}  // namespace gcv
