// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "contributing_vertices.hpp"
#include "places_on_line.hpp"

namespace gcv {

// Is one of x - B and a solid of A inside the other, where each ring of A has a solid of its own?
// The first ring has it outside.
struct Containment {
  bool of_place;  // for the place x; false if the boundaries touch where it is looked at
  bool of_germ;   // for what follows the place on its line, to the right
};

// The box holds the place, in relative coordinates. O(1) for each ring that is far from it, else
// O(n + m).
Containment containment_at(const Operands& operands, const PlacesOnLine& places, const Place& place,
                           const Box& around, Tally& tally);

}  // namespace gcv
