// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Two polygons of the families of regions, of any size and anywhere, with translations and motions
// of the second one: near contact, in contact but for roundings, far away, along edges, from
// contact to contact. And scenes of many such polygons. A seed gives the same scenes everywhere.
#pragma once

#include <cstdint>
#include <optional>
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

struct MemberScene {
  std::vector<std::vector<invariants::Polygon>> shapes;  // the rings of each

  struct Member {
    std::size_t shape;
    invariants::Point position;
    std::uint32_t layers;
  };
  std::vector<Member> members;
  std::optional<std::size_t> container;  // a shape
  std::size_t moving = 0;                // a shape
  std::vector<invariants::Point> positions;
  std::vector<invariants::Point> motions;
};

// Members in contact with one another, far from there, in a container of the family or round all of
// them. In some scenes positions and vertices do not add up to doubles. Otherwise as above.
MemberScene member_scene(const RegionFamily& family, Random& random, int most_members,
                         int positions);

}  // namespace gcv::test
