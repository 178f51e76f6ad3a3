// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Pairs of solids of a scene that are near each other.
#pragma once

#include <optional>
#include <vector>

#include "query.hpp"
#include "relation.hpp"
#include "snapshot.hpp"
#include "task.hpp"

namespace gcv {

struct ScenePair {
  Id a;
  Id b;  // a < b; 0 for a polygon that is no member
  Relation relation;

  friend bool operator<(const ScenePair& p, const ScenePair& q) {
    return p.a != q.a ? p.a < q.a : p.b < q.b;
  }
};

struct PairList {
  Snapshot snapshot;
  double distance;
  std::vector<ScenePair> pairs;  // in order
};

// The solids that are no further than a distance from a polygon at a position, as pairs with b = 0.
// Throws Error: cancelled.
std::vector<ScenePair> near_solids(const Scene& scene, const Query& query, const Boundary& moving,
                                   const Point& position, double distance, Task& task);

// All pairs that are no further than a distance from each other. What has not changed since a
// previous list of the same distance and query, which may be nullptr, is taken from there.
// Throws Error: cancelled.
PairList near_pairs(const Scene& scene, const Query& query, double distance,
                    const PairList* previous, Task& task);

}  // namespace gcv
