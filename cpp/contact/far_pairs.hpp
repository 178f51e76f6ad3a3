// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Polygons so far apart that their distances in doubles are all alike.
//
// With D from the first vertex of A to that of B, and v from a point of A to one of B, each seen
// from the first vertex of its polygon, their distance is |D| + u v + at most |v|^2 / |D|, where u
// is the unit vector of D. So the nearest ones are those whose u v is least, but for |v|^2 / |D|.
#pragma once

#include <vector>

#include "contact.hpp"
#include "polygon_pair.hpp"

namespace gcv {

// Is D more than 2^42 times the extents of both?
bool are_far_apart(const PlacedPair& placed);

// The pairs of an edge and a vertex that may be nearest to each other, some of them several times.
// O(n + m), and O(1) for each pair.
std::vector<ContactName> nearest_of_far_pair(const PlacedPair& placed);

}  // namespace gcv
