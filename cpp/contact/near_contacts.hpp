// SPDX-License-Identifier: LGPL-3.0-or-later
//
// All contacts of two polygons within a distance.
#pragma once

#include <vector>

#include "contact.hpp"
#include "task.hpp"

namespace gcv {

// The contacts that Definition 1 admits for touching whose |gap| is at most `distance`: by the
// sizes of their gaps, then in the order of contacts. The gap of an edge is negative where the
// vertex lies on the solid side of its line.
//
// An edge and a vertex: the vertex is convex, and neither of its edges leads to the solid side of
// the edge. Two vertices: both are convex, and one of them is admitted for an edge of the other.
// With a slope they are admitted too if one of the edges of the vertex is off the edge by an angle
// of at most this tangent.
//
// Counts the pairs of edges near each other as steps of the task. Throws Error: cancelled.
std::vector<Contact> near_contacts(const PlacedPair& placed, double distance, double slope,
                                   Task& task, Tally& tally);

}  // namespace gcv
