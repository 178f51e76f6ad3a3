// SPDX-License-Identifier: LGPL-3.0-or-later
#include "placements.hpp"

#include <cmath>

#include "shapes.hpp"

namespace gcv::bench {

namespace {

struct Linear {
  double xx;
  double xy;
  double yx;
  double yy;
};

Ring mapped(Ring ring, const Linear& map) {
  for (Point& p : ring) {
    // 0.0 makes -0.0 a positive zero.
    p = {map.xx * p.x + map.xy * p.y + 0.0, map.yx * p.x + map.yy * p.y + 0.0};
  }
  return ring;
}

Placement of_b(const char* name, const Linear& map) {
  return {name, [map](const Rings& pair) { return Rings{pair.first, mapped(pair.second, map)}; }};
}

Placement of_both(const char* name, const Linear& map) {
  return {name, [map](const Rings& pair) {
            return Rings{mapped(pair.first, map), mapped(pair.second, map)};
          }};
}

}  // namespace

std::vector<Placement> placements() {
  const double angle = 0.7;  // no symmetry of any of the shapes
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {of_b("as is", {1, 0, 0, 1}),
          of_b("90°", {0, -1, 1, 0}),
          of_b("180°", {-1, 0, 0, -1}),
          of_b("270°", {0, 1, -1, 0}),
          of_b("mirror x", {-1, 0, 0, 1}),
          of_b("mirror y", {1, 0, 0, -1}),
          of_b("transpose", {0, 1, 1, 0}),
          of_b("anti-transpose", {0, -1, -1, 0}),
          {"swap",
           [](const Rings& pair) {
             return Rings{pair.second, pair.first};
           }},
          of_both("both 90°", {0, -1, 1, 0}),
          of_both("both 180°", {-1, 0, 0, -1}),
          of_both("aspect 10", {10, 0, 0, 1}),
          of_both("aspect 1000", {1000, 0, 0, 1}),
          {"far",
           [](const Rings& pair) {
             return Rings{moved(pair.first, 1e9 + 1 / 3.0, -1e9 / 7),
                          moved(pair.second, -3e9 / 7, 2e9 + 1 / 3.0)};
           }},
          of_b("turned", {c, -s, s, c}),
          of_b("1/16", {0x1p-4, 0, 0, 0x1p-4}),
          of_b("16", {16, 0, 0, 16})};
}

}  // namespace gcv::bench
