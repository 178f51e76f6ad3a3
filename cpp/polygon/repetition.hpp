// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How chains of a polygon repeat: those of combs, stairs and zigzags do. Where trees split equal
// chains alike, what a search has found for one serves the others (search/equal_chains.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "ring_layout.hpp"

namespace gcv {

class EdgeChain;

class Repetition {
 public:
  // The layout must live longer. Edges are compared by how far they lead in doubles. O(n log n).
  Repetition(const EdgeChain& chain, const RingLayout& layout);

  // Do most chains of some edges, side by side, have an equal one?
  [[nodiscard]] bool exists() const { return exists_; }

  // If so, where to split a chain of at least two edges of a ring, so that equal chains are split
  // alike, as a rule: beside an edge that equals no other one, or else at the number that is
  // divided by the largest power of two. In each ring, 0 stands for the start of a tooth.
  [[nodiscard]] Index cut(Index first, Index last) const;

 private:
  using Hashes = std::vector<std::uint64_t>;  // of edges

  [[nodiscard]] bool do_chains_repeat(const Hashes& edges) const;
  void find_single(const Hashes& edges);
  void find_starts(const EdgeChain& chain);

  const RingLayout& layout_;
  bool exists_ = false;
  std::vector<Index> single_;  // edges that equal no other one
  std::vector<Index> starts_;  // of rings, modulo 2^32
};

}  // namespace gcv
