// SPDX-License-Identifier: LGPL-3.0-or-later
#include "region_text.hpp"

#include <span>

#include "wkt.hpp"

namespace gcv {

namespace {

std::span<const Point> vertices_of(const RoundedRegion& region, const RegionPart& part) {
  return std::span(region.vertices).subspan(part.first, part.size);
}

}  // namespace

std::string format_polygons(const RoundedRegion& region) {
  std::string text;
  for (const RegionPart& part : region.parts) {
    if (!part.is_ring()) {
      break;
    }
    if (part.kind == PartKind::outer) {
      text += text.empty() ? "MULTIPOLYGON ((" : "), (";
    } else {
      text += ", ";
    }
    append_ring(text, vertices_of(region, part));
  }
  return text.empty() ? "MULTIPOLYGON EMPTY" : text + "))";
}

std::string format_fits(const RoundedRegion& region) {
  std::string text;
  for (const RegionPart& part : region.parts) {
    if (part.is_ring()) {
      continue;
    }
    const std::span<const Point> vertices = vertices_of(region, part);
    text += text.empty() ? "GEOMETRYCOLLECTION (" : ", ";
    text += part.kind == PartKind::segment ? "LINESTRING (" : "POINT (";
    append_point(text, vertices.front());
    if (part.kind == PartKind::segment) {
      text += ", ";
      append_point(text, vertices.back());
    }
    text += ')';
  }
  return text.empty() ? "GEOMETRYCOLLECTION EMPTY" : text + ')';
}

}  // namespace gcv
