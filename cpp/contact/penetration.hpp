// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How B gets out of an overlap.
#pragma once

#include <vector>

#include "contact.hpp"
#include "cover.hpp"
#include "exact_region.hpp"
#include "nearest_edges.hpp"
#include "usable_position.hpp"
#include "walked_lines.hpp"

namespace gcv {

struct Escape {
  double depth;       // correctly rounded; 0 if they do not overlap
  Point translation;  // the shortest way out, each coordinate correctly rounded
  UsablePosition place;
  Contact contact;  // that is there; none if they do not overlap
};

// What the ways out at all translations have in common. With holes left out there is the outer ring
// to go to.
class WaysOut {
 public:
  // The polygons must live longer.
  WaysOut(const Polygon& a, const Polygon& reflected_b, const WantedParts& wanted, Task& task,
          Tally& tally);

  [[nodiscard]] const Operands& operands() const { return operands_; }
  [[nodiscard]] const WantedParts& wanted() const { return wanted_; }
  [[nodiscard]] const std::vector<RingVertex>& outer_ring() const { return outer_ring_; }

 private:
  Operands operands_;
  WantedParts wanted_;
  std::vector<RingVertex> outer_ring_;
};

// Finds ways out, one after the other. A translation lies in the open sum of A and the reflection
// of B just where they overlap there. So the way out leads to the nearest place that the open sum
// leaves of a superset edge. A best-first search by distances in doubles finds it. What these do
// not tell apart is compared exactly.
class EscapeSearch {
 public:
  EscapeSearch(const WaysOut& ways, Tally& tally)
      : ways_(ways),
        tally_(tally),
        cover_(ways.operands(), tally),
        nearest_edges_(ways.operands(), cover_.search()),
        known_(ways.operands(), cover_.search().slack(), tally) {}

  // Of several ways out, the lexicographically smallest one. Throws Error: cancelled, internal.
  Escape find(const PlacedPair& placed, Task& task);

 private:
  const WaysOut& ways_;
  Tally& tally_;
  EdgeCover cover_;
  NearestEdges nearest_edges_;
  WalkedLines known_;  // superset edges that were looked at: what they have within reach is found
};

}  // namespace gcv
