// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Every threshold by which a search is chosen, and what it weighs. What the caches keep adapts by
// rules of their own, in place_cache.cpp and ahead_cache.cpp.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gcv::limits {

// A table holds so many superset edges. With 25,000 spiky stars take 1.4 times as long as by trees,
// uneven combs, which need but few of them, 7 times.
inline constexpr std::uint64_t most_table_edges = 16384;
// And so many where a vertex of the polygons has so many at most, as where one of them is small or
// convex. Combs and spirals, whose trees have boxes that lie one in another, take 0.01 to 0.55 of
// the time by trees then, stars and coasts 0.44 to 1.15.
inline constexpr std::uint64_t most_linear_edges = 65536;
inline constexpr std::uint64_t edges_a_vertex = 4;
// Unless more of their boxes than that lie over a place, on average, as those of long edges in no
// direction of the axes do: a table looks at them one by one. Turned zigzags of 1,000 to 32,000
// vertices and a small square take 0.2 to 0.01 of the time by trees then, combs 0.75 to 0.05, stars
// 1.05 to 0.13. With fewer boxes tables are quicker, up to three times.
inline constexpr std::uint64_t most_boxes_over_a_place = 64;
// Of more edges than that, so many over an edge count as well: stairs of 4,000 to 12,000 vertices
// and a slanting bar take 0.25 to 0.06 of the time by trees then. Stars of 2,000 would take twice
// the time.
inline constexpr std::uint64_t fewest_edges_to_sample = 4096;
// At most so many edges of each polygon may be too short for its grid, or one of so many. They may
// all lie in one place, as those of a small polygon beside a large one do. With 16 of them sums by
// tables take 0.03 to 1.05 of the time by trees, with 24 up to 1.15, with 48 up to 1.9.
inline constexpr std::uint32_t most_short_edges = 16;
inline constexpr std::uint32_t edges_a_short_one = 8;

// Trees may be in the order of a curve where a polygon has so many times the edges of the other.
// Sums of spirals with themselves take 1.3 to 1.5 times as long then, beside small polygons 0.14 to
// 0.02 of the time.
inline constexpr std::uint32_t edges_a_small_one = 16;
constexpr bool is_small_beside(std::uint32_t edges, std::uint32_t edges_of_other) {
  return edges <= edges_of_other / edges_a_small_one;
}
constexpr bool is_one_small(std::uint32_t edges_a, std::uint32_t edges_b) {
  return is_small_beside(edges_a, edges_b) || is_small_beside(edges_b, edges_a);
}

// Equal chains are looked for where both polygons have so many edges: smaller sums are quick as
// they are.
inline constexpr std::uint32_t fewest_edges_with_equal_chains = 64;
// And where so many edges on average have the same line direction: equal edges need equal
// directions, and directions are counted already.
inline constexpr std::size_t edges_a_direction = 2;
// They are used where so many of four edges, and of four chains, differ at most: else a search
// meets few of them again, and pays for asking.
inline constexpr std::size_t different_of_four = 3;
// A search asks on where it has met one of so many chains before; a search for witnesses where
// equal nodes prevail, or where it has met one of so many. Mazes took 5 % longer with fewer.
inline constexpr std::uint64_t chains_a_repeated_one = 64;
inline constexpr std::uint64_t nodes_a_repeated_one = 5;
// They prevail, so that the trees with equal chains are searched in place of a table, where one of
// so many chains differs, and where so many edges have the same line direction.
inline constexpr std::size_t chains_a_different_one = 4;
inline constexpr std::size_t edges_a_direction_to_prevail = 8;

// Sorting both polygons along a line costs about as much as looking at so many superset edges for
// each of their vertices. It is done once as much has been spent on steps that went straight on,
// where a step costs as much as looking at so many edges.
inline constexpr std::uint64_t line_price_a_vertex = 2;
inline constexpr std::uint64_t line_cost_of_a_step = 8;

}  // namespace gcv::limits
