// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The pairs of polygons that are measured, in sets.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "point.hpp"

namespace gcv::bench {

using Rings = std::pair<std::vector<Point>, std::vector<Point>>;

struct Pair {
  std::string name;
  std::function<Rings()> make;
};

struct Set {
  std::string name;
  bool principal_only;  // only systems that are principal run on it
  bool grows;           // in size, so that who is cut off on a pair would be on later ones
  std::vector<Pair> pairs;
};

// All sets; those of data only where the data is. A quick run has fewer and smaller pairs.
std::vector<Set> all_sets(bool quick);

}  // namespace gcv::bench
