// SPDX-License-Identifier: LGPL-3.0-or-later
#include "free_scenes.hpp"

#include <cstddef>

namespace gcv::test {

namespace {

using Polygons = std::vector<invariants::Polygon>;

bool one_in(Random& random, int count) { return uniform(random, 1, count) == 1; }

// With holes: in the middle, in a corner, and touching all sides, so that the interior falls apart.
// With a slot. And a square.
Polygons special_shape(Random& random) {
  static const std::array<Polygons, 5> shapes{
      Polygons{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}},
      Polygons{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 0}, {2, 1}, {1, 2}}},
      Polygons{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 2}, {2, 0}, {4, 2}, {2, 4}}},
      Polygons{{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {3, 2}, {3, 3}, {0, 3}}},
      Polygons{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}};
  return shapes[static_cast<std::size_t>(uniform(random, 0, 4))];
}

Polygons random_shape(Random& random, int extent) {
  const int most = extent == 1 ? 4 : 6;
  invariants::Polygon ring;
  for (const Point& p : random_small_integer_polygon(random, uniform(random, 3, most), extent)) {
    ring.push_back({p.x, p.y});
  }
  return {ring};
}

Polygons random_container(Random& random) {
  switch (uniform(random, 0, 3)) {
    case 0:
      return {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}};
    case 1:
      return {{{0, 0}, {10, 0}, {10, 4}, {6, 4}, {6, 6}, {10, 6}, {10, 10}, {0, 10}},
              {{2, 2}, {4, 2}, {4, 4}, {2, 4}}};
    case 2:  // with two holes that touch
      return {
          {{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{5, 5}, {7, 5}, {6, 7}}, {{6, 7}, {8, 8}, {6, 8}}};
    default:
      return random_shape(random, 10);
  }
}

Polygons in_unit(double unit, Polygons rings) {
  for (invariants::Polygon& ring : rings) {
    for (invariants::Point& p : ring) {
      p = {unit * p[0], unit * p[1]};
    }
  }
  return rings;
}

}  // namespace

FreeScene free_scene(Random& random, double unit, int most_members, int positions) {
  FreeScene result;
  MemberScene& scene = result.scene;
  const auto place = [&](int low, int high, double step) {
    const double x = step * unit * uniform(random, low, high);
    return invariants::Point{x, step * unit * uniform(random, low, high)};
  };
  for (int k = uniform(random, 0, most_members); k > 0; --k) {
    const Polygons shape =
        one_in(random, 3) ? special_shape(random) : random_shape(random, uniform(random, 1, 4));
    const std::uint32_t layers =
        one_in(random, 4) ? static_cast<std::uint32_t>(uniform(random, 0, 7)) : UINT32_MAX;
    scene.members.push_back({scene.shapes.size(), place(-1, 9, 1), layers});
    scene.shapes.push_back(in_unit(unit, shape));
  }
  if (!one_in(random, 3)) {
    scene.container = scene.shapes.size();
    scene.shapes.push_back(in_unit(unit, random_container(random)));
  }
  scene.moving = scene.shapes.size();
  scene.shapes.push_back(in_unit(unit, one_in(random, 4)
                                           ? special_shape(random)
                                           : random_shape(random, uniform(random, 1, 3))));
  for (int k = 0; k < positions; ++k) {
    scene.positions.push_back(place(-6, 26, 0.5));
  }
  if (!scene.container || one_in(random, 2)) {
    const invariants::Point low = place(-2, 5, 1);
    const invariants::Point size = place(1, 8, 1);
    result.window = {low[0], low[1], low[0] + size[0], low[1] + size[1]};
  }
  return result;
}

}  // namespace gcv::test
