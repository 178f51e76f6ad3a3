// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Regions of polygons given by rings, for tests.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "exact_ring.hpp"
#include "minkowski_region.hpp"
#include "polygon.hpp"
#include "ring_predicates.hpp"

namespace gcv::test {

using PolygonRings = std::vector<PointVector>;

inline RegionOperand region_operand(PolygonRings rings, const char* name) {
  return {std::make_shared<const Polygon>(make_polygon(std::move(rings), name)), name};
}

inline PolygonRings negated_rings(PolygonRings rings) {
  for (PointVector& ring : rings) {
    for (Point& p : ring) {
      p = {0.0 - p.x, 0.0 - p.y};
    }
  }
  return rings;
}

inline Region sum_region(const PolygonRings& a, const PolygonRings& b, const Point& shift = {0, 0},
                         const RegionOptions& options = {}) {
  Task task;
  return minkowski_sum_region(region_operand(a, "a"), region_operand(b, "b"), shift, options, task);
}

inline Region fit_region(const PolygonRings& container, const PolygonRings& moving,
                         const Point& reference = {0, 0}, const RegionOptions& options = {}) {
  Task task;
  return inner_fit_region(region_operand(container, "container"),
                          region_operand(negated_rings(moving), "moving"), reference, options,
                          task);
}

// One exact part a line, as the reference has it.
inline std::string text_of(const ExactRegion& region) {
  constexpr const char* names[] = {"outer", "hole", "segment", "point"};
  std::string text;
  for (const RegionPart& part : region.parts) {
    text += names[static_cast<int>(part.kind) - 1];
    if (part.is_ring()) {
      text += ' ';
      text += std::to_string(part.polygon);
    }
    for (std::size_t k = part.first; k < part.end(); ++k) {
      text += k == part.first ? ": " : ", ";
      text += exact_vertex(region, k);
    }
    text += '\n';
  }
  return text;
}

// The exact rings, sorted as text.
inline std::vector<std::vector<std::string>> ring_texts(const ExactRegion& region) {
  std::vector<std::vector<std::string>> rings;
  for (const RegionPart& part : region.parts) {
    if (part.is_ring()) {
      std::vector<std::string>& ring = rings.emplace_back();
      for (std::size_t k = part.first; k < part.end(); ++k) {
        ring.push_back(exact_vertex(region, k));
      }
    }
  }
  std::sort(rings.begin(), rings.end());
  return rings;
}

inline std::size_t hole_count(const ExactRegion& region) {
  return static_cast<std::size_t>(
      std::count_if(region.parts.begin(), region.parts.end(),
                    [](const RegionPart& part) { return part.kind == PartKind::hole; }));
}

// The polygons of the rounded region, each checked as polygons of users are. Throws Error where one
// is not valid.
inline std::vector<Polygon> rounded_polygons(const RoundedRegion& region) {
  std::vector<Polygon> polygons;
  for (std::size_t k = 0; k < region.parts.size() && region.parts[k].is_ring();) {
    const Index number = region.parts[k].polygon;
    PolygonRings rings;
    for (; k < region.parts.size() && region.parts[k].polygon == number; ++k) {
      const auto first =
          region.vertices.begin() + static_cast<std::ptrdiff_t>(region.parts[k].first);
      rings.emplace_back(first, first + static_cast<std::ptrdiff_t>(region.parts[k].size));
    }
    polygons.push_back(make_polygon(std::move(rings), "rounded"));
  }
  return polygons;
}

}  // namespace gcv::test
