// SPDX-License-Identifier: LGPL-3.0-or-later
#include "turns.hpp"

#include <bit>

#include "predicates.hpp"
#include "rounding.hpp"

namespace gcv {

KnownTurns::KnownTurns(const Operands& operands, Tally& tally)
    : operands_(operands), tally_(tally), turns_(Hash{}, Equal{operands, tally}) {}

KnownTurns::Key KnownTurns::key(const RingVertex& vertex) const {
  const RoundedVertex p = rounded_vertex(operands_.a, operands_.b, vertex, {0, 0}, tally_);
  return {std::bit_cast<std::uint64_t>(p.x.value),
          std::bit_cast<std::uint64_t>(p.y.value),
          {operands_.named(vertex.arriving()), operands_.named(vertex.leaving())}};
}

std::uint64_t KnownTurns::Hash::operator()(const Key& key) const {
  std::uint64_t hash = 0;
  for (const std::uint64_t part :
       {key.x, key.y, std::uint64_t{key.turn.arriving.rank} << 32U | key.turn.leaving.rank}) {
    hash = (hash ^ part) * 0x9e3779b97f4a7c15U;
    hash ^= hash >> 29U;
  }
  return hash;
}

bool KnownTurns::Equal::operator()(const Key& p, const Key& q) const {
  const auto are_on_one_line = [&](const PairEdge& e, const PairEdge& f) {
    return e.rank == f.rank &&
           side(coordinates(operands.a, operands.b, f), operands.start(e), tally) == 0;
  };
  return p.x == q.x && p.y == q.y && are_on_one_line(p.turn.arriving, q.turn.arriving) &&
         are_on_one_line(p.turn.leaving, q.turn.leaving);
}

}  // namespace gcv
