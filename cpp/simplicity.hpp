// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Is a closed ring simple? Exactly, for all finite doubles.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "point.hpp"

namespace gcv {

// Does the ring turn the same way at every vertex, and once round in all? Then it is the
// boundary of a convex polygon, and simple. Turning by less than half a turn each time, it
// goes round once where its edges change once from pointing up to pointing down. turn_at(i) is
// the sign of the turn at vertex i.
template <class TurnAt>
bool is_convex_ring(std::span<const Point> ring, TurnAt turn_at) {
  const std::size_t n = ring.size();
  const int sense = turn_at(0);
  std::size_t changes = 0;
  bool up = points_up(ring[n - 1], ring[0]);
  for (std::size_t i = 0; i < n; ++i) {
    if (sense == 0 || turn_at(i) != sense) {
      return false;
    }
    const bool was_up = std::exchange(up, points_up(ring[i], ring[i + 1 == n ? 0 : i + 1]));
    changes += was_up && !up ? 1 : 0;
  }
  return changes == 1;
}

// Two edges of a ring that meet where they should not; edge i joins vertices i and i+1.
struct Conflict {
  std::size_t first;
  std::size_t second;
};

// Looks for two edges of the closed ring that cross, touch or overlap, other than two
// neighbours in their common vertex; neighbours that overlap, where the ring turns back, count.
// Consecutive vertices must be distinct; collinear ones are allowed. `bounds` is the box of the
// ring, about. O(n log n); on several threads where few edges are near each other.
std::optional<Conflict> find_conflict(std::span<const Point> ring, const Box& bounds,
                                      unsigned threads = 1);
inline std::optional<Conflict> find_conflict(std::span<const Point> ring) {
  return find_conflict(ring, box_of(ring));
}

// Does a simple ring go counter-clockwise?
bool is_counter_clockwise(std::span<const Point> ring);

// All such pairs, by a tree of boxes: fast where edges that are near each other are few.
std::vector<Conflict> find_all_conflicts(std::span<const Point> ring);

// Edges that are in such a pair, in ascending order: none just when there is no such pair; all
// of them, unless that takes more than O(n log n), and then maybe also others.
std::vector<std::size_t> find_conflicting_edges(std::span<const Point> ring);

}  // namespace gcv
