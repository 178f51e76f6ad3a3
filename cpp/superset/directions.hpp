// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The directions of the edges of two polygons, as ranks on one circle. With K line
// directions in all, rank r in [0, K) is the r-th of them counter-clockwise from the
// positive x axis, and r + K its opposite. Turns, parallel and opposite edges, and the
// cones of contributing vertices are comparisons of ranks modulo 2K: no arithmetic.
#pragma once

#include <boost/container/small_vector.hpp>

#include "boundary.hpp"
#include "tally.hpp"

namespace gcv {

using Rank = Index;

// The ranks of the edges of a polygon. Those of a small one need no memory of their own.
using Ranks = boost::container::small_vector<Rank, 32>;

struct Directions {
  Rank half_turn = 0;  // K; a full turn is 2K ranks
  Ranks rank_a;        // of each edge of A
  Ranks rank_b;

  // How far counter-clockwise `to` lies from `from`: in [0, 2K). 0 is the same
  // direction, (0, K) to the left, K the opposite, (K, 2K) to the right.
  [[nodiscard]] Rank angle(Rank from, Rank to) const {
    return to >= from ? to - from : to + 2 * half_turn - from;
  }
};

// Merges the two polygons' sorted line directions; O(n + m) exact comparisons.
Directions merge_directions(const Boundary& a, const Boundary& b, Tally& tally);

}  // namespace gcv
