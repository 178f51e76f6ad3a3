// SPDX-License-Identifier: LGPL-3.0-or-later
#include "repetition.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <numeric>
#include <span>

#include "chain_tree.hpp"

namespace gcv {

namespace {

constexpr Index compared = 16;  // edges of a chain

std::uint64_t bits_of(double value) { return std::bit_cast<std::uint64_t>(value + 0.0); }

std::uint64_t hash_of(std::uint64_t hash, std::uint64_t other) {
  hash = (hash ^ other) * 0x9e3779b97f4a7c15;
  return hash ^ hash >> 32U;
}

}  // namespace

Repetition::Repetition(const EdgeChain& chain, const RingLayout& layout) : layout_(layout) {
  Hashes edges(chain.size());
  for (Index k = 0; k < chain.size(); ++k) {
    const std::span<const Point> ends = chain.ends(k, 1);
    edges[k] = hash_of(hash_of(0, bits_of(ends[1].x - ends[0].x)), bits_of(ends[1].y - ends[0].y));
  }
  exists_ = do_chains_repeat(edges);
  if (exists_) {
    find_single(edges);
    find_starts(chain);
  }
}

bool Repetition::do_chains_repeat(const Hashes& edges) const {
  Hashes chains;
  for (Index ring = 0; ring < layout_.ring_count(); ++ring) {
    for (Index first = layout_.begin(ring); first + compared <= layout_.end(ring);
         first += compared) {
      chains.push_back(
          std::accumulate(&edges[first], &edges[first] + compared, std::uint64_t{0}, hash_of));
    }
  }
  const std::size_t all = chains.size();
  std::sort(chains.begin(), chains.end());
  chains.erase(std::unique(chains.begin(), chains.end()), chains.end());
  return 2 * chains.size() <= all && all > 0;
}

void Repetition::find_single(const Hashes& edges) {
  Hashes sorted = edges;
  std::sort(sorted.begin(), sorted.end());
  for (Index k = 0; k < edges.size(); ++k) {
    const auto [from, to] = std::equal_range(sorted.begin(), sorted.end(), edges[k]);
    if (to - from == 1) {
      single_.push_back(k);
    }
  }
}

// The first vertex of each ring that is reflex, with a convex one behind it. Less a number of whole
// chains, so that it is not behind the first vertex.
void Repetition::find_starts(const EdgeChain& chain) {
  for (Index ring = 0; ring < layout_.ring_count(); ++ring) {
    const Index begin = layout_.begin(ring);
    const Index count = layout_.end(ring) - begin;
    const std::span<const Point> points = chain.ends(begin, count);
    const auto is_convex = [&](Index k) {
      const Point& p = points[k - 1];
      const Point& q = points[k];
      const Point& r = points[k + 1];
      return (q.x - p.x) * (r.y - q.y) - (q.y - p.y) * (r.x - q.x) > 0;
    };
    Index start = 1;
    while (start + 1 < count && (is_convex(start) || !is_convex(start + 1))) {
      ++start;
    }
    starts_.push_back(begin + start % compared - compared);
  }
}

Index Repetition::cut(Index first, Index last) const {
  const Index middle = first + (last - first) / 2;
  const auto after = std::lower_bound(single_.begin(), single_.end(), middle);
  if (after != single_.end() && *after < last) {
    return *after;
  }
  if (after != single_.begin() && *(after - 1) >= first) {
    return *(after - 1) + 1;
  }
  const Index start = starts_[layout_.ring_of(first)];
  const Index before = first - start;
  const Index behind = last - 1 - start;
  return start + (behind & ~(std::bit_floor(before ^ behind) - 1));
}

}  // namespace gcv
