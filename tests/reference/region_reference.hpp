// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Regions by their definition, to compare the cover walk with. By CGAL (GPL: in tests only). All
// sums of an edge and a vertex go into one exact arrangement. Each of its faces, edges and vertices
// is then asked whether two polygons overlap. Nothing is known of supersets, of convex vertices, or
// of walks.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "point.hpp"

namespace gcv::reference {

// The rings of a polygon, the outer one first, each either way round.
using Rings = std::vector<PointVector>;

// Part of a region, as gcv_region_part: 1 is an outer ring, 2 a hole, 3 a segment, 4 a point.
// Segments and points have the polygon 0xffffffff. Each vertex is "p/q r/s".
struct RegionPart {
  int kind;
  std::uint32_t polygon;
  std::vector<std::string> vertices;

  friend bool operator==(const RegionPart&, const RegionPart&) = default;
};

// The closed sum a + b + shift, and the exact fits in it.
std::vector<RegionPart> sum_region(const Rings& a, const Rings& b, const Point& shift);

// Where the reference point, fixed to `moving`, may go with `moving` inside the container.
std::vector<RegionPart> inner_fit_region(const Rings& container, const Rings& moving,
                                         const Point& reference);

// The polygons of members, and their places.
struct PlacedPolygon {
  Rings rings;
  Point place;
};
using PlacedRings = std::vector<PlacedPolygon>;

struct Window {
  Point low;
  Point high;
};

// Where `moving` is free among members, in the container, if there is one, and in the window, if
// there is one. There must be one of these.
std::vector<RegionPart> free_region(const PlacedRings& members, const Rings* container,
                                    const Rings& moving, const std::optional<Window>& window);

// One part a line.
std::string text(const std::vector<RegionPart>& region);

}  // namespace gcv::reference
