// SPDX-License-Identifier: LGPL-3.0-or-later
#include "half_plane.hpp"

#include <cstdint>
#include <vector>

#include "contributions.hpp"
#include "task.hpp"

namespace gcv {

namespace {

// How many edges have each rank, and how many convex vertices contribute to each rank.
struct PairsByRank {
  std::vector<std::uint64_t> edges;
  std::vector<std::uint64_t> cones;

  PairsByRank(const Boundary& polygon, const Ranks& ranks, Rank turn)
      : edges(turn), cones(turn + 1) {
    for (const Rank rank : ranks) {
      ++edges[rank];
    }
    // Differences first, that wrap round.
    for_each_cone(polygon, ranks, [&](Index /*v*/, Rank in, Rank out) {
      ++cones[in];
      --cones[out + 1];
      if (in > out) {
        ++cones[0];
      }
    });
    for (Rank rank = 1; rank < turn; ++rank) {
      cones[rank] += cones[rank - 1];
    }
  }
};

}  // namespace

Rank cheapest_half_plane(const Operands& operands) {
  const Rank half = operands.directions.half_turn;
  const Rank turn = 2 * half;
  const PairsByRank a(operands.a, operands.directions.rank_a, turn);
  const PairsByRank b(operands.b, operands.directions.rank_b, turn);
  const auto count = [&](Rank rank) {
    return a.edges[rank] * b.cones[rank] + b.edges[rank] * a.cones[rank];
  };
  std::uint64_t sum = 0;
  Pace pace;
  for (Rank rank = 0; rank < half; ++rank) {
    pace.step();
    sum += count(rank);
  }
  std::uint64_t least = sum;
  Rank best = 0;
  for (Rank first = 1; first < turn; ++first) {
    pace.step();
    sum = sum + count((first + half - 1) % turn) - count(first - 1);
    if (sum < least) {
      least = sum;
      best = first;
    }
  }
  return best;
}

}  // namespace gcv
