// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How far two polygons are from each other.
#pragma once

#include "contact.hpp"
#include "relation.hpp"

namespace gcv {

struct Separation {
  Relation relation;
  double distance;  // correctly rounded; 0 unless they are apart
  Contact nearest;  // of several the first in the order of contacts; none unless they are apart
};

// A best-first search by distances in doubles. What these do not tell apart is compared exactly.
Separation distance(const PlacedPair& placed, Tally& tally);

}  // namespace gcv
