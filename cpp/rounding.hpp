// SPDX-License-Identifier: LGPL-3.0-or-later
//
// From the exact ring to a ring of doubles.
#pragma once

#include <cstdint>
#include <vector>

#include "exact_ring.hpp"
#include "task.hpp"

namespace gcv {

// Places in doubles for the vertices of an exact ring, one each; vertices that fall
// together have the same place.
struct Placement {
  PointVector places;
  double error_bound = 0;      // no vertex is further than this from its place
  std::uint64_t repaired = 0;  // vertices whose place is not the nearest one
};

// The nearest doubles, ties to even, for each coordinate. Throws Error: range, where one is
// not finite.
Placement place_nearest(const ExactRing& ring, Task& task, Tally& tally);

// Given the nearest doubles: where the ring through them is not simple, vertices in the way are
// moved apart (repair.hpp). False, and nothing is changed, where that does not make it simple.
bool make_simple(const ExactRing& ring, Placement& placement, Task& task, Tally& tally);

struct RoundedRing {
  // A simple ring, counter-clockwise, from its lexicographically smallest vertex.
  PointVector vertices;
  // No point of either ring is further than this from the other ring.
  double error_bound = 0;
  std::uint64_t vertices_repaired = 0;
};

// The ring through places that are as near as possible. Where no few units in the last
// place make it simple, because features are smaller than those, the outer face of the
// nearest one, without what it cuts off (untangle.hpp). Throws Error: range, where a
// coordinate is not finite, or where nothing with an area is left.
RoundedRing round_to_nearest(const ExactRing& ring, Task& task, Tally& tally);

// The ring through the places, each once, from the lexicographically smallest one.
PointVector ring_through(PointVector places);

// The distance from |x| to the next double.
double unit_in_last_place(double x);

// That of the largest x and of the largest y of the points.
Point units_in_last_place(const PointVector& points);

// At least x + y, for numbers that are not negative.
double sum_bound(double x, double y);

}  // namespace gcv
