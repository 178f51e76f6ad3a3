// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Changes of a pair of polygons that should not change the time of their sum much.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sets.hpp"

namespace gcv::bench {

struct Placement {
  std::string name;
  std::function<Rings(const Rings&)> apply;
};

// The first one leaves the pair as it is.
std::vector<Placement> placements();

}  // namespace gcv::bench
