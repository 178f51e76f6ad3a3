// SPDX-License-Identifier: LGPL-3.0-or-later
//
// In place of place_cache.cpp: nothing is kept from step to step, so that every step
// searches the implicit superset from the roots of its trees.
#include "place_cache.hpp"

namespace gcv {

PlaceCache::PlaceCache(const TreeProduct& superset, double slack)
    : superset_(superset), slack_(slack), reach_(0), bounds_{0, 0, 0, 0} {}

bool PlaceCache::gather(const Point&, const Point&, VisitedPairs*) { return false; }

}  // namespace gcv
