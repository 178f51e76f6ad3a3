// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The solid cones of two polygons in a point where they touch, and what they do to each other. All
// exact. They are told by vectors, not by ranks: nothing is sorted for a pair of polygons.
#pragma once

#include "point.hpp"
#include "polygon_pair.hpp"
#include "tally.hpp"

namespace gcv {

// The direction from one point to another.
struct Direction {
  Point from;
  Point to;

  [[nodiscard]] Direction reversed() const { return {to, from}; }
};

// An open arc of directions, counter-clockwise: less than a full turn, and not empty.
struct DirectionRange {
  Direction from;
  Direction to;
};

using SolidCones = ConesInPoint<DirectionRange>;

Direction direction_of_edge(const PreparedPolygon& polygon, Index edge);
// The solid cones in a vertex, and that in a point on the inside of an edge where no ring touches.
SolidCones cones_of_vertex(const PreparedPolygon& polygon, Index vertex, Tally& tally);
SolidCones cones_of_edge(const PreparedPolygon& polygon, Index edge);

// Does a cone of A overlap one of B?
bool overlap(const SolidCones& a, const SolidCones& b, Tally& tally);
// The apexes of the cones are in one point. Does a cone of A overlap one of B once B is moved, by
// as little as you like?
bool overlap_once_moved(const SolidCones& a, const SolidCones& b, const Direction& motion,
                        Tally& tally);

}  // namespace gcv
