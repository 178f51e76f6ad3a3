// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Scenes of a few small polygons on a grid, full of ties, to ask where a polygon is free: with
// holes, rings that touch, and places that are just as large as what moves. A seed gives the same
// scenes everywhere.
#pragma once

#include <array>
#include <optional>

#include "contact_scenes.hpp"

namespace gcv::test {

struct FreeScene {
  MemberScene scene;  // with positions, without motions
  std::optional<std::array<double, 4>> window;
};

// All coordinates are multiples of the unit, rounded: with a unit of 0.1, vertices and positions do
// not add up to doubles. Without a container there is a window.
FreeScene free_scene(Random& random, double unit, int most_members, int positions);

}  // namespace gcv::test
