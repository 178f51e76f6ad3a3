// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Two polygons of the families of regions, of any size and anywhere, with translations and motions
// of the second one: near contact, in contact but for roundings, far away, along edges, from
// contact to contact. A seed gives the same scenes everywhere.
#pragma once

#include <span>
#include <vector>

#include "invariants.hpp"
#include "region_families.hpp"

namespace gcv::test {

struct ContactScene {
  std::vector<invariants::Polygon> a;  // rings, the outer one first
  std::vector<invariants::Polygon> b;
  std::vector<invariants::Point> translations;
  std::vector<invariants::Point> motions;  // one for each translation
};

// The families of regions, and some with more vertices.
std::span<const RegionFamily> contact_families();

// Coordinates may be infinite, and roundings may have made rings that are not simple: scenes that
// are to be left out.
ContactScene contact_scene(const RegionFamily& family, Random& random, int translations);

}  // namespace gcv::test
