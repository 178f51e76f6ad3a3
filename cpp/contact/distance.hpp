// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How far two polygons are from each other.
#pragma once

#include <optional>

#include "box.hpp"
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

// The features of two polygons that are nearest to each other; of several, the first in the order
// of contacts.
struct NearestFeatures {
  ContactName name;
  Gap gap;
};
// The relation, and those features, if the polygons are apart. Perhaps none where they are further
// from each other than a distance, by more than roundings.
struct NearestOfPair {
  Relation relation;
  std::optional<NearestFeatures> features;
};
NearestOfPair nearest_of_pair(const PlacedPair& placed, double distance, Tally& tally);

// The relation, if they are no further than a distance from each other.
std::optional<Relation> relation_within(const PlacedPair& placed, double distance, Tally& tally);

}  // namespace gcv
