// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How far B can move before it overlaps A.
#pragma once

#include "contact.hpp"
#include "usable_position.hpp"

namespace gcv {

struct Impact {
  bool hit;
  double time;  // rounded down
  UsablePosition place;
  Contact contact;  // none without a hit, and where they overlap at the start
};

// B moves by t motion, for t from 0 to 1.
//
// The motion enters a contact at a time when two features meet, and their cones overlap right after
// that. This can be told of each contact alone. If the polygons do not overlap at the start, they
// first overlap where the motion first enters a contact. A best-first search by times in doubles
// finds it. What these do not tell apart is compared exactly.
Impact cast(const PlacedPair& placed, const Point& motion, Tally& tally);

}  // namespace gcv
