// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The directions of a polygon's edges up to sign, sorted exactly.
#pragma once

#include <cstdint>

#include "buffer.hpp"

namespace gcv {

struct Polygon;

// The line directions (angles in [0, pi)) that occur are numbered in counter-clockwise order.
struct LineDirections {
  struct Line {
    double key;          // that of direction_key.hpp
    std::uint32_t edge;  // one edge with that line direction
  };
  struct Edge {
    std::uint32_t line;
    bool points_up;  // along its line direction, or else against it
  };
  Buffer<Line> lines;
  Buffer<Edge> edges;
};

// O(n log n), of a convex polygon O(n).
LineDirections sort_line_directions(const Polygon& polygon);

}  // namespace gcv
