// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Regions: polygons with holes, segments and points. As exact parts, and in doubles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "exact_ring.hpp"

namespace gcv {

enum class PartKind : std::uint8_t { outer = 1, hole = 2, segment = 3, point = 4 };

// The parts follow one another: each polygon's outer ring and its holes, then segments, then
// points. Outer rings are counter-clockwise, holes clockwise.
struct RegionPart {
  static constexpr Index no_polygon = 0xffffffff;

  PartKind kind;
  Index polygon;      // counts the outer rings; no_polygon for segments and points
  std::size_t first;  // of its vertices
  std::size_t size;

  [[nodiscard]] bool is_ring() const { return kind <= PartKind::hole; }
  [[nodiscard]] std::size_t end() const { return first + size; }
};

// The vertices of all parts follow one another. The operands are all rings of both polygons.
struct ExactRegion : ExactRing {
  std::vector<RegionPart> parts;
};

// In these doubles, rings are simple and do not cross one another. Holes lie in their polygons.
struct RoundedRegion {
  PointVector vertices;
  std::vector<RegionPart> parts;
  // For each vertex, the exact vertex that it stands for: the lowest index of those that fell
  // together.
  std::vector<std::uint64_t> exact_indices;
  // The distance of a point of the exact parts from what is returned for them, at most, and the
  // other way round. A part that is dropped counts with its extents.
  double error_bound = 0;
  // That of a vertex, at most, but for those of an outer face that is rounded by itself.
  double displacement = 0;
  std::uint64_t vertices_repaired = 0;
  std::uint64_t parts_dropped = 0;  // too thin for doubles
};

}  // namespace gcv
