// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Boxes that hold the convex pieces of a polygon. A box round a frame, or round a bar in no
// direction of the axes, is empty for the most part: smaller boxes meet fewer others.
#pragma once

#include <span>
#include <vector>

#include "box.hpp"
#include "point.hpp"
#include "ring_layout.hpp"

namespace gcv {

struct Boundary;

// In relative coordinates, as all boxes here.
Box box_of_piece(const Boundary& polygon, std::span<const Index> piece);

// One box for all of the polygon, or one for each piece, or for each of up to 32 slabs of each
// piece: what costs least. `meeting`: how many of the boxes to search meet a box, for each unit of
// its area. Boxes may be off by roundings. One of a vertex where there are no pieces. O(n) for each
// choice.
std::vector<Box> part_boxes(const Boundary& polygon, double meeting);

}  // namespace gcv
