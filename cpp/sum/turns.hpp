// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstdint>

#include "contributing_vertices.hpp"
#include "exact_ring.hpp"
#include "key_numbers.hpp"
#include "tally.hpp"

namespace gcv {

// A turn of a ring: where it goes from one line to another.
struct Turn {
  PairEdge arriving;
  PairEdge leaving;
};

// The turns of the rings that are known. Edges that overlap have several names, so a turn is known
// by its place and its directions: by the ranks and the nearest doubles at first, then exactly.
class KnownTurns {
 public:
  KnownTurns(const Operands& operands, Tally& tally);

  // Is it known?
  [[nodiscard]] bool has(const RingVertex& vertex) const {
    return turns_.find(key(vertex)) != Turns::none;
  }
  void add(const RingVertex& vertex) { turns_.add(key(vertex)); }

 private:
  struct Key {
    std::uint64_t x;  // the bits of the doubles
    std::uint64_t y;
    Turn turn;
  };
  [[nodiscard]] Key key(const RingVertex& vertex) const;

  struct Hash {
    std::uint64_t operator()(const Key& key) const;
  };
  struct Equal {
    const Operands& operands;
    Tally& tally;
    bool operator()(const Key& p, const Key& q) const;
  };

  using Turns = KeyNumbers<Key, Hash, Equal>;

  const Operands& operands_;
  Tally& tally_;
  Turns turns_;
};

}  // namespace gcv
