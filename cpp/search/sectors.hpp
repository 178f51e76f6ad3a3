// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Sets of directions, as up to 64 sectors of consecutive ranks: one rank each where there are no
// more. Trees tell by them what is below a node.
#pragma once

#include <cstdint>

#include "directions.hpp"

namespace gcv {

using Sectors = std::uint64_t;

// Those of the ranks counter-clockwise from the first to the last, less than a full turn. Sector
// numbers grow with ranks, so a rank in the range lies in one of them.
inline Sectors sectors_of(const Directions& directions, Rank first, Rank last) {
  constexpr std::uint64_t most = 64;
  const std::uint64_t turn = 2 * std::uint64_t{directions.half_turn};
  const auto sector = [&](Rank rank) { return turn <= most ? rank : rank * most / turn; };
  const Sectors from_first = ~Sectors{0} << sector(first);
  const Sectors to_last = ~Sectors{0} >> (most - 1 - sector(last));
  return first <= last ? from_first & to_last : from_first | to_last;
}

}  // namespace gcv
