// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Vertices of the convex hull of the sum, where walks along the outer face can start.
#pragma once

#include <boost/container/small_vector.hpp>

#include "boundary.hpp"
#include "place.hpp"

namespace gcv {

using HullVertices = boost::container::small_vector<VertexSum, 1>;

// Vertices of the hull of the sum, counter-clockwise, each once, the lexicographically
// smallest one first: enough for walks on that many threads, and no more for one.
HullVertices hull_vertices(const Boundary& a, const Boundary& b, unsigned threads);

}  // namespace gcv
