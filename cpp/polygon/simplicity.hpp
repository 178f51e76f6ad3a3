// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Tests whether a closed ring is simple. Exact for all finite doubles.
#pragma once

#include <cassert>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "box.hpp"
#include "cycle.hpp"
#include "point.hpp"

namespace gcv {

// Does the ring turn the same way at every vertex, and go round once? Then it is simple and the
// boundary of a convex polygon. turn_at(i) is the sign of the turn at vertex i.
//
// Why it is enough to count: each turn is less than half a turn. So the ring goes round once if its
// edges change exactly once from pointing up to pointing down.
template <class TurnAt>
bool is_convex_ring(std::span<const Point> ring, TurnAt turn_at) {
  const std::size_t n = ring.size();
  assert(n >= 3);
  const int sense = turn_at(0);
  std::size_t changes = 0;
  bool up = points_up(ring[n - 1], ring[0]);
  for (std::size_t i = 0; i < n; ++i) {
    if (sense == 0 || turn_at(i) != sense) {
      return false;
    }
    const bool was_up = std::exchange(up, points_up(ring[i], ring[cyclic_next(i, n)]));
    changes += was_up && !up ? 1 : 0;
  }
  return changes == 1;
}

// Two edges of a ring that must not meet, but do. Edge i joins vertices i and i+1.
struct Conflict {
  std::size_t first;
  std::size_t second;
};

// Finds two edges of the closed ring that cross, touch or overlap. Two neighbours may meet in their
// common vertex, but must not overlap, as they do where the ring turns back. Consecutive vertices
// must be distinct. They may be collinear. `bounds` is about the bounding box of the ring. O(n log
// n). Uses several threads if few edges are near each other.
std::optional<Conflict> find_conflict(std::span<const Point> ring, const Box& bounds,
                                      unsigned threads = 1);
inline std::optional<Conflict> find_conflict(std::span<const Point> ring) {
  return find_conflict(ring, box_of(ring));
}

// Is a simple ring counter-clockwise?
bool is_counter_clockwise(std::span<const Point> ring);

// All conflicts. Uses a bounding volume hierarchy: fast if few edges are near each other.
std::vector<Conflict> find_all_conflicts(std::span<const Point> ring);

// Edges that have a conflict, in ascending order. The list is empty if and only if there is no
// conflict. It holds all such edges, unless finding them takes more than O(n log n). Then it may
// also hold others.
std::vector<std::size_t> find_conflicting_edges(std::span<const Point> ring);

}  // namespace gcv
