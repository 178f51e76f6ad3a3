// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <optional>

#include "contributing_vertices.hpp"
#include "places_on_line.hpp"

namespace gcv {

// Is one of x - B and a solid of A inside the other, where A has several solids?
struct Containment {
  bool of_place;  // for the place x; false if the boundaries touch where it is looked at
  bool of_germ;   // for what follows the place on its line, to the right
  bool of_line;   // for what follows the place on its line, itself
  // How far on the line the last is sure to be so, if it is: up to here, else for ever.
  std::optional<Place> end;
};

// The box holds the place, in relative coordinates. Solids of the vertices of A from `seen` on do
// not count. For each solid whose box is near, what the line meets behind the place is looked at.
Containment containment_at(const Operands& operands, const PlacesOnLine& places, const Place& place,
                           const Box& around, Index seen, Tally& tally);

}  // namespace gcv
