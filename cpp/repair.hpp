// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Making the rounded ring simple without changing its topology. Where two walls of a slit
// that is thinner than the doubles can show fall onto each other or cross, they are moved
// apart, by as few units in the last place as it takes: a large pocket may lie behind the
// slit, which closing it would lose.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "exact_ring.hpp"

namespace gcv {

// A ring of doubles, whose vertex k stands for the vertices of the exact ring that are
// numbered `source[k-1] + 1` to `source[k]`, cyclically: those that fell together.
struct SnappedRing {
  PointVector vertices;
  std::vector<std::size_t> source;
};

// The ring through the given places of the exact vertices, each place once.
SnappedRing snap(const PointVector& places);

// New places, near the nearest ones, for which the snapped ring is simple, if they are
// found within a few units in the last place. Only vertices that are in the way move.
std::optional<PointVector> separate(const ExactRing& ring, const PointVector& nearest,
                                    Tally& tally);

}  // namespace gcv
