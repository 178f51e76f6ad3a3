// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Questions about vertices of an exact ring: the side of a line, and the coordinates as fractions.
#pragma once

#include <cstddef>
#include <string>

#include "exact_ring.hpp"
#include "tally.hpp"

namespace gcv {

// The side of a line on which a vertex lies, exactly: 1 left, -1 right, 0 on the line.
int side_of_vertex(const Boundary& a, const Boundary& b, const SumEdge& line, const RingVertex& v,
                   Tally& tally);

// The side of the line of ring edge `edge` on which vertex `vertex` lies, exactly: 1 left, -1
// right, 0 on the line.
int exact_side(const ExactRing& ring, std::size_t edge, std::size_t vertex, Tally& tally);

// The vertex as "p/q r/s", in lowest terms with positive denominators.
std::string exact_vertex(const Boundary& a, const Boundary& b, const RingVertex& v,
                         const Point& shift);
std::string exact_vertex(const ExactRing& ring, std::size_t k);

}  // namespace gcv
