// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Makes the rounded ring simple without a change of its topology. A slit may be thinner than
// doubles can show. Then its two sides fall onto each other or cross. They are moved apart by as
// few units in the last place as possible. Closing the slit instead could lose a large pocket
// behind it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "exact_ring.hpp"

namespace gcv {

// A ring of doubles. Vertex k stands for the vertices source[k-1] + 1 to source[k] of the exact
// ring, cyclically: they were rounded to one point.
struct SnappedRing {
  PointVector vertices;
  std::vector<std::size_t> source;
};

// The ring through the rounded vertices, without repetitions.
SnappedRing snap(const PointVector& places);

// New doubles for the vertices, near the nearest ones, such that the ring is simple. Nothing if
// none are found within a few units in the last place. Moves only vertices that are in the way.
std::optional<PointVector> separate(const ExactRing& ring, const PointVector& nearest,
                                    Tally& tally);

}  // namespace gcv
