// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The catalogue of hard cases: families of pairs of polygons, by theme. The same pairs on
// every machine: all randomness is in integers from fixed seeds, and coordinates come from
// + - * / alone.
#pragma once

#include <vector>

#include "invariants.hpp"

namespace gcv::hard {

using invariants::Effort;
using invariants::Polygon;

struct Pair {
  Polygon a;
  Polygon b;
};

using Pairs = std::vector<Pair>;

struct Family {
  const char* name;
  Pairs (*pairs)();
  Effort effort = {};
};

std::vector<Family> fits();          // parts that fit exactly into others
std::vector<Family> directions();    // many edges of nearly, or exactly, the same direction
std::vector<Family> coincidences();  // many edges on one line, or through one point
std::vector<Family> curves();        // long boundaries
std::vector<Family> magnitudes();    // coordinates of all sizes

}  // namespace gcv::hard
