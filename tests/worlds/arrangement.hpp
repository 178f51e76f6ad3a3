// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The edges and vertices that some segments cut one another into.
#pragma once

#include <vector>

#include "open_sum.hpp"

namespace worlds {

// From the lexicographically smaller end on; places.
struct SmallEdge {
  Point from;
  Point to;
  Point direction;
  auto operator<=>(const SmallEdge&) const = default;
};

// Each edge once, sorted.
std::vector<SmallEdge> arrange(const std::vector<Segment>& segments);

}  // namespace worlds
