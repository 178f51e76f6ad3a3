// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Bytes -> polygons with holes, on a small grid or anywhere among the doubles, and vectors to
// contacts of them and beside.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "placement.hpp"
#include "question_pair.hpp"

namespace gcv::fuzz {

// Any doubles.
inline Ring any_ring(Input& input) {
  Ring ring(3 + input.below(4));
  for (Point& p : ring) {
    p = input.take<Point>();
  }
  return ring;
}

// Many teeth: more vertices than the definitions are tried on.
inline Ring long_comb(Input& input) {
  const std::size_t teeth = 1 + input.below(40);
  double heights[4];
  for (double& height : heights) {
    height = 1 + static_cast<double>(input.below(16));
  }
  Ring ring{{0, 0}};
  double x = 0;
  for (std::size_t k = 0; k < teeth; ++k) {
    const double height = heights[k % 4];
    ring.insert(ring.end(), {{x, height}, {x + 1, height}, {x + 1, 0.5}, {x + 2, 0.5}});
    x += 2;
  }
  ring.push_back({x, 0});
  return ring;
}

// The first byte says how the polygon is made. `placement` is that of the polygon before, and can
// be used again.
inline Rings read_polygon(Input& input, Placement& placement) {
  enum { any, on_grid, also_on_grid, teeth };
  const auto how = input.take<std::uint8_t>();
  const int shape = how & 3;
  if (shape == any) {
    return {any_ring(input)};
  }
  if ((how & 4) == 0) {
    placement = Placement::read(input, how & 8, how & 16, how & 32);
  }
  Rings rings = shape == teeth ? Rings{long_comb(input)} : read_grid_polygon(input);
  for (Ring& ring : rings) {
    for (Point& p : ring) {
      p = placement(p[0], p[1]);
      if ((how & 64) != 0) {
        add_ulps(input, p[0]);
        add_ulps(input, p[1]);
      }
    }
  }
  return rings;
}

// A vertex, or a point of an edge at an eighth of it.
inline Point boundary_point(Input& input, const Rings& rings) {
  const Ring& ring = rings[input.below(rings.size())];
  const std::size_t k = input.below(ring.size());
  const Point way = minus(ring[(k + 1) % ring.size()], ring[k]);
  const double share = static_cast<double>(input.below(8)) / 8;
  return {ring[k][0] + share * way[0], ring[k][1] + share * way[1]};
}

// To a place on the grid, to a contact but for roundings, beside one, or anywhere.
inline Point read_vector(Input& input, const Rings& a, const Rings& b, int exponent) {
  enum { on_grid, contact, near_contact, beside_contact, along_edge, anywhere };
  const std::size_t kind = input.below(6);
  if (kind == anywhere) {
    return input.take<Point>();
  }
  if (kind == along_edge) {
    const Point from = boundary_point(input, a);
    return minus(boundary_point(input, a), from);
  }
  Point vector{0, 0};
  if (kind != on_grid) {
    const Point on_a = boundary_point(input, a);
    vector = minus(on_a, boundary_point(input, b));
  }
  for (double& x : vector) {
    if (kind == beside_contact) {
      add_ulps(input, x);
    } else if (kind != contact) {
      x += std::ldexp(input.take<std::int8_t>(), exponent - (kind == on_grid ? 2 : 10));
    }
  }
  return vector;
}

inline std::string text(const Rings& rings) {
  std::string result;
  for (const Ring& ring : rings) {
    result += "\n  ring";
    for (const Point& p : ring) {
      result += ' ';
      result += text_of(p);
      result += ',';
    }
  }
  return result;
}

// NULL where it is refused.
inline Polygon make(const Rings& rings) {
  std::vector<Point> points;
  std::vector<std::size_t> sizes;
  for (const Ring& ring : rings) {
    sizes.push_back(ring.size());
    points.insert(points.end(), ring.begin(), ring.end());
  }
  gcv_polygon* polygon = nullptr;
  succeeds("gcv_polygon_create_rings",
           gcv_polygon_create_rings(points.front().data(), sizes.data(), sizes.size(), 0, &polygon),
           {GCV_ERR_NOT_FINITE, GCV_ERR_DEGENERATE, GCV_ERR_NOT_SIMPLE});
  return Polygon(polygon);
}

}  // namespace gcv::fuzz
