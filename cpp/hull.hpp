// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Vertices of the convex hull of the sum, where walks along the outer face can start.
#pragma once

#include <vector>

#include "directions.hpp"
#include "polygon.hpp"

namespace gcv {

// The sum of vertex i of A and vertex j of B.
struct HullVertex {
  Index i;
  Index j;
};

// Vertices of the hull of the sum, counter-clockwise, each once, the lexicographically
// smallest one first: enough for walks on that many threads, and no more for one.
std::vector<HullVertex> hull_vertices(const Polygon& a, const Polygon& b, unsigned threads);

}  // namespace gcv
