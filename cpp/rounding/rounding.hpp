// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Rounds the exact ring to a ring of doubles.
#pragma once

#include <cstdint>

#include "double_double_rounding.hpp"
#include "exact_ring.hpp"
#include "task.hpp"

namespace gcv {

// Doubles for each vertex of an exact ring. Vertices that are rounded to one point have equal
// entries.
struct Placement {
  PointVector places;
  double error_bound = 0;      // the distance of a vertex from its doubles, at most
  std::uint64_t repaired = 0;  // the number of vertices whose doubles are not the nearest ones
};

// A vertex with each coordinate rounded to the nearest double, ties to even.
RoundedVertex rounded_vertex(const Boundary& a, const Boundary& b, const RingVertex& vertex,
                             const Point& shift, Tally& tally);

// Rounds each coordinate to the nearest double, ties to even. That is so many parts of the task.
// Throws Error: range, if one is not finite.
Placement place_nearest(const ExactRing& ring, Task& task, Tally& tally, std::uint64_t parts = 0);

// Makes the ring through the nearest doubles simple, if it is not. Moves vertices that are in the
// way apart (see repair.hpp). Returns false and changes nothing if that does not make it simple.
bool make_simple(const ExactRing& ring, Placement& placement, Task& task, Tally& tally);

struct RoundedRing {
  // Simple and counter-clockwise. The first vertex is the lexicographically smallest.
  PointVector vertices;
  // The distance of any point of either ring from the other ring, at most.
  double error_bound = 0;
  std::uint64_t vertices_repaired = 0;
};

// The simple ring of doubles that is as near as possible. Rounds to nearest and repairs. Features
// may be smaller than a few units in the last place, so that no repair makes the ring simple. Then
// the result is the outer face of the nearest ring, and what that cuts off is left out (see
// snap_rounding.hpp). Throws Error: range, if a coordinate is not finite or nothing with an area is
// left.
RoundedRing round_to_nearest(const ExactRing& ring, Task& task, Tally& tally,
                             std::uint64_t parts = 0);

// The ring through the points, without repetitions, from the lexicographically smallest one.
PointVector ring_through(PointVector places);

}  // namespace gcv
