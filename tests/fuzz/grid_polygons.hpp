// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Bytes -> polygons with holes, on a small grid full of ties.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "fuzz.hpp"

namespace gcv::fuzz {

using Point = std::array<double, 2>;
using Ring = std::vector<Point>;
using Rings = std::vector<Ring>;

inline bool is_finite(const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]); }

inline double grid_coordinate(Input& input, std::size_t extent) {
  return static_cast<double>(input.below(extent + 1));
}

inline Ring grid_points(Input& input, std::size_t extent) {
  constexpr std::size_t most_vertices = 6;
  Ring ring(3 + input.below(most_vertices - 2));
  for (Point& p : ring) {
    p[0] = grid_coordinate(input, extent);
    p[1] = grid_coordinate(input, extent);
  }
  return ring;
}

inline Ring grid_rectangle(Input& input, std::size_t extent) {
  const double x0 = grid_coordinate(input, extent);
  const double y0 = grid_coordinate(input, extent);
  const double x1 = x0 + 1 + grid_coordinate(input, extent / 2);
  const double y1 = y0 + 1 + grid_coordinate(input, extent / 2);
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

// Columns of all heights on one base.
inline Ring grid_comb(Input& input, std::size_t extent) {
  Ring ring{{0, 0}};
  double x = 0;
  for (std::size_t columns = 1 + input.below(5); columns > 0; --columns) {
    const double height = 1 + grid_coordinate(input, extent);
    ring.push_back({x, height});
    x += 1 + grid_coordinate(input, 2);
    ring.push_back({x, height});
  }
  ring.push_back({x, 0});
  return ring;
}

// Pulled out of shape a little, by a whole number: what was upright is not.
inline void shear(Ring& ring, double by) {
  for (Point& p : ring) {
    p[0] += by * p[1];
  }
}

inline Rings read_grid_polygon(Input& input) {
  constexpr std::size_t extent = 9;
  constexpr std::size_t most_holes = 2;
  const auto how = input.take<std::uint8_t>();
  Rings rings;
  const std::size_t holes = (how >> 2U) % (most_holes + 1);
  for (std::size_t k = 0; k <= holes; ++k) {
    const std::size_t shape = k == 0 ? how % 4 : input.below(2);
    rings.push_back(shape == 0   ? grid_points(input, extent)
                    : shape == 1 ? grid_rectangle(input, extent)
                    : shape == 2 ? grid_comb(input, extent)
                                 : Ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  }
  if ((how & 64U) != 0) {
    const double by = grid_coordinate(input, 2) - 1;
    for (Ring& ring : rings) {
      shear(ring, by);
    }
  }
  return rings;
}

}  // namespace gcv::fuzz
