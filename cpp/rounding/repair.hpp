// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Makes rounded rings simple without a change of their topology, and keeps them from crossing each
// other. A slit may be thinner than
// doubles can show. Then its two sides fall onto each other or cross. They are moved apart by as
// few units in the last place as possible. Closing the slit instead could lose a large pocket
// behind it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "exact_ring.hpp"

namespace gcv {

// Vertices of an exact ring that are one of its rings: those from `first` on.
struct RingRange {
  std::size_t first;
  std::size_t size;
  bool is_counter_clockwise;
  bool is_fixed;  // its vertices do not move
};

// A ring of doubles. Vertex k stands for the vertices source[k-1] + 1 to source[k] of the exact
// ring, cyclically: they were rounded to one point.
struct SnappedRing {
  PointVector vertices;
  std::vector<std::size_t> source;
};

// The ring through the rounded vertices, without repetitions.
SnappedRing snap(std::span<const Point> places);

// New doubles for the vertices, near the nearest ones, such that the ring is simple. Nothing if
// none are found within a few units in the last place. Moves only vertices that are in the way. The
// vertices are those of several rings, some of which may be left out: no vertex of these moves.
std::optional<PointVector> separate(const ExactRing& ring, std::span<const RingRange> rings,
                                    const PointVector& nearest, Tally& tally);
inline std::optional<PointVector> separate(const ExactRing& ring, const PointVector& nearest,
                                           Tally& tally) {
  const RingRange all{0, ring.size(), true, false};
  return separate(ring, {&all, 1}, nearest, tally);
}

}  // namespace gcv
