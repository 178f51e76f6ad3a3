// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Is a closed ring simple? Exactly, for all finite doubles.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "point.hpp"

namespace gcv {

// Two edges of a ring that meet where they should not; edge i joins vertices i and i+1.
struct Conflict {
  std::size_t first;
  std::size_t second;
};

// Looks for two edges of the closed ring that cross, touch or overlap, other than two
// neighbours in their common vertex. Consecutive vertices must be distinct, and no
// vertex may be a spike (an edge turning back on the one before); collinear vertices
// are allowed. O(n log n); on several threads where few edges are near each other.
std::optional<Conflict> find_conflict(std::span<const Point> ring, unsigned threads = 1);

// Does a simple ring go counter-clockwise?
bool is_counter_clockwise(std::span<const Point> ring);

// All such pairs, by a tree of boxes: fast where edges that are near each other are few.
std::vector<Conflict> find_all_conflicts(std::span<const Point> ring);

// Edges that are in such a pair, in ascending order: none just when there is no such pair; all
// of them, unless that takes more than O(n log n), and then maybe also others.
std::vector<std::size_t> find_conflicting_edges(std::span<const Point> ring);

}  // namespace gcv
