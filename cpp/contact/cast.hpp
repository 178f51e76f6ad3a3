// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How far B can move before it overlaps A.
#pragma once

#include <optional>

#include "contact.hpp"
#include "exact_point.hpp"
#include "predicates.hpp"
#include "usable_position.hpp"

namespace gcv {

struct Impact {
  bool hit;
  double time;  // rounded down
  UsablePosition place;
  Contact contact;  // none without a hit, and where they overlap at the start
};

// A contact that a motion enters: its features meet, and their cones overlap right after that. The
// path is that of the translation of B less that of A, and it crosses the line of those at which
// the features meet.
struct Entry {
  ContactName name;
  SumEdge path;
  SumEdge line;
  Interval time;  // encloses that of the crossing

  // Where the path and the line cross. That, moved by the translation of A, is B's.
  [[nodiscard]] ExactPoint place() const { return ExactPoint::of_crossing(path, line); }
};

// Which of the entries of two motions comes first: the sign of the difference of their times.
int compare_times(const Entry& p, const Entry& q, Tally& tally);
// Is its time 0?
bool is_at_start(const Entry& entry, Tally& tally);
// The time of an entry, rounded down.
double time_of(const Entry& entry, Tally& tally);
// The contact when it is entered: its features meet in one point.
Contact contact_on_entry(const PlacedPair& placed, const ContactName& name, const Point& motion,
                         Tally& tally);

// The first entry before the end of a motion of B, of several the first one in the order of
// contacts. The polygons must not overlap at the start, and the motion must not be 0. A best-first
// search by times in doubles finds it. What these do not tell apart is compared exactly.
std::optional<Entry> first_entry(const PlacedPair& placed, const Point& motion, Tally& tally);

// B moves by t motion, for t from 0 to 1.
//
// Whether the motion enters a contact can be told of each contact alone. If the polygons do not
// overlap at the start, they first overlap where the motion first enters a contact.
Impact cast(const PlacedPair& placed, const Point& motion, Tally& tally);

}  // namespace gcv
