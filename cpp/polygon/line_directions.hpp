// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The line directions of the edges of a polygon, sorted exactly. The line direction of an edge is
// its direction up to the sign.
#pragma once

#include <cstdint>
#include <span>

#include "buffer.hpp"
#include "point.hpp"
#include "ring_layout.hpp"

namespace gcv {

// The line directions that occur, as angles in [0, pi). They are numbered counter-clockwise.
struct LineDirections {
  struct Line {
    double key;          // see direction_key.hpp
    std::uint32_t edge;  // one edge with that line direction
  };
  struct Edge {
    std::uint32_t line;
    bool points_up;  // in its line direction, or else against it
  };
  Buffer<Line> lines;
  Buffer<Edge> edges;
};

// Sorts the line directions of the edges of closed rings. O(n log n); O(n) for one convex ring.
LineDirections sort_line_directions(std::span<const Point> vertices, const RingLayout& layout,
                                    bool is_convex);

}  // namespace gcv
