// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_region_*: reads results from a region.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "area.hpp"
#include "edge_sources.hpp"
#include "error.hpp"
#include "fill.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "handles.hpp"
#include "region_text.hpp"
#include "ring_predicates.hpp"
#include "stats.hpp"

using gcv::Error;
using gcv::PartKind;
using gcv::Point;
using gcv::PointVector;
using gcv::RegionPart;
using gcv::RoundedRegion;
using gcv::Status;
using gcv::capi::CallersFloatingPoint;
using gcv::capi::fill;
using gcv::capi::fill_points;
using gcv::capi::fill_text;
using gcv::capi::give_finite;
using gcv::capi::guarded;
using gcv::capi::require;
using gcv::capi::require_count;

namespace {

void fill_parts(const std::vector<RegionPart>& parts, gcv_region_part* out, std::size_t capacity,
                std::size_t* required) {
  fill(parts.size(), "parts", "out", out, capacity, required, [&](gcv_region_part* to) {
    std::transform(parts.begin(), parts.end(), to, [](const RegionPart& part) {
      return gcv_region_part{static_cast<std::int32_t>(part.kind), part.polygon, part.size};
    });
  });
}

// The end of the rings among the parts.
auto end_of_rings(const RoundedRegion& region) {
  return std::find_if(region.parts.begin(), region.parts.end(),
                      [](const RegionPart& part) { return !part.is_ring(); });
}

std::span<const Point> vertices_of(const RoundedRegion& region, const RegionPart& part) {
  return std::span(region.vertices).subspan(part.first, part.size);
}

double area_of(const RoundedRegion& region) {
  const auto rings = static_cast<std::size_t>(end_of_rings(region) - region.parts.begin());
  return rings == 0 ? 0 : gcv::area_of(rings, [&region](std::size_t k) {
    return vertices_of(region, region.parts[k]);
  });
}

// The rings of polygon k.
std::vector<PointVector> rings_of(const RoundedRegion& region, std::size_t k) {
  std::vector<PointVector> rings;
  for (auto part = region.parts.begin(); part != end_of_rings(region); ++part) {
    if (part->polygon == k) {
      const std::span<const Point> vertices = vertices_of(region, *part);
      rings.emplace_back(vertices.begin(), vertices.end());
    }
  }
  if (rings.empty()) {
    const auto polygons =
        std::count_if(region.parts.begin(), region.parts.end(),
                      [](const RegionPart& part) { return part.kind == PartKind::outer; });
    throw Error(Status::invalid_argument, "polygon is %zu, the region has %td polygons", k,
                polygons);
  }
  return rings;
}

// Calls visit(k) for each exact vertex k that no edge leaves: the second end of a segment, and a
// point.
template <class Visit>
void for_each_without_edge(const gcv::ExactRegion& region, Visit visit) {
  for (const RegionPart& part : region.parts) {
    if (!part.is_ring()) {
      visit(part.end() - 1);
    }
  }
}

// Edges that the border of a window makes have none.
std::vector<gcv_edge_source> public_sources(const gcv::Region& region) {
  const std::vector<gcv::EdgeSource> sources = gcv::edge_sources(region.exact);
  std::vector<gcv_edge_source> result(sources.size());
  for (std::size_t k = 0; k < sources.size(); ++k) {
    const bool is_of_window = !region.owners.empty() && region.owner(k) == 0;
    result[k] = is_of_window ? gcv_edge_source{0, 0, 0} : gcv::capi::public_source(sources[k]);
  }
  for_each_without_edge(region.exact, [&](std::size_t k) { result[k] = {0, 0, 0}; });
  return result;
}

void write_owners(const gcv::Region& region, std::uint64_t* to) {
  for (std::size_t k = 0; k < region.exact.size(); ++k) {
    to[k] = region.owner(k);
  }
  for_each_without_edge(region.exact, [&](std::size_t k) { to[k] = 0; });
}

std::vector<Point> read_points(const double* xy, std::size_t count) {
  require_count(count, sizeof(Point), "xy");
  std::vector<Point> points(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Point p{xy[2 * k], xy[2 * k + 1]};
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
      throw Error(Status::not_finite,
                  "xy: the %s coordinate of point %zu is %g, not a finite number",
                  std::isfinite(p.x) ? "y" : "x", k, std::isfinite(p.x) ? p.y : p.x);
    }
    points[k] = {p.x + 0.0, p.y + 0.0};
  }
  return points;
}

}  // namespace

void gcv_region_destroy(gcv_region* region) { delete region; }

gcv_status gcv_region_parts(const gcv_region* region, gcv_region_part* out, size_t capacity,
                            size_t* required) {
  return guarded<CallersFloatingPoint>([&] {
    require(region, "region");
    fill_parts(region->region.rounded.parts, out, capacity, required);
  });
}

gcv_status gcv_region_vertices(const gcv_region* region, double* xy, size_t capacity,
                               size_t* required) {
  return guarded<CallersFloatingPoint>([&] {
    require(region, "region");
    fill_points(region->region.rounded.vertices, xy, capacity, required);
  });
}

gcv_status gcv_region_exact_parts(const gcv_region* region, gcv_region_part* out, size_t capacity,
                                  size_t* required) {
  return guarded<CallersFloatingPoint>([&] {
    require(region, "region");
    fill_parts(region->region.exact.parts, out, capacity, required);
  });
}

gcv_status gcv_region_exact_vertex(const gcv_region* region, size_t index, char* text,
                                   size_t capacity, size_t* required) {
  return guarded([&] {
    require(region, "region");
    const gcv::ExactRegion& exact = region->region.exact;
    if (index >= exact.size()) {
      throw Error(Status::invalid_argument, "index is %zu, the exact region has %zu vertices",
                  index, exact.size());
    }
    fill_text(gcv::exact_vertex(exact, index), text, capacity, required);
  });
}

gcv_status gcv_region_exact_indices(const gcv_region* region, uint64_t* out, size_t capacity,
                                    size_t* required) {
  return guarded<CallersFloatingPoint>([&] {
    require(region, "region");
    const std::vector<std::uint64_t>& indices = region->region.rounded.exact_indices;
    fill(indices.size(), "indices", "out", out, capacity, required,
         [&](std::uint64_t* to) { std::copy(indices.begin(), indices.end(), to); });
  });
}

gcv_status gcv_region_edge_sources(const gcv_region* region, gcv_edge_source* out, size_t capacity,
                                   size_t* required) {
  return guarded([&] {
    require(region, "region");
    fill(region->region.exact.size(), "edges", "out", out, capacity, required,
         [&](gcv_edge_source* to) {
           const std::vector<gcv_edge_source> sources = public_sources(region->region);
           std::copy(sources.begin(), sources.end(), to);
         });
  });
}

gcv_status gcv_region_edge_owners(const gcv_region* region, uint64_t* ids, size_t capacity,
                                  size_t* required) {
  return guarded<CallersFloatingPoint>([&] {
    require(region, "region");
    fill(region->region.exact.size(), "edges", "ids", ids, capacity, required,
         [&](std::uint64_t* to) { write_owners(region->region, to); });
  });
}

gcv_status gcv_region_area(const gcv_region* region, double* out) {
  return guarded([&] {
    require(region, "region");
    require(out, "out");
    give_finite(area_of(region->region.rounded), "the area of the region", out);
  });
}

gcv_status gcv_region_error_bound(const gcv_region* region, double* out) {
  return guarded<CallersFloatingPoint>([&] {
    require(region, "region");
    require(out, "out");
    *out = region->region.rounded.error_bound;
  });
}

gcv_status gcv_region_wkt(const gcv_region* region, char* text, size_t capacity, size_t* required) {
  return guarded([&] {
    require(region, "region");
    fill_text(gcv::format_polygons(region->region.rounded), text, capacity, required);
  });
}

gcv_status gcv_region_fits_wkt(const gcv_region* region, char* text, size_t capacity,
                               size_t* required) {
  return guarded([&] {
    require(region, "region");
    fill_text(gcv::format_fits(region->region.rounded), text, capacity, required);
  });
}

gcv_status gcv_region_polygon(const gcv_region* region, size_t polygon, gcv_polygon** out) {
  return guarded([&] {
    require(region, "region");
    require(out, "out");
    *out = gcv::capi::new_polygon(
        gcv::make_polygon(rings_of(region->region.rounded, polygon), "polygon"));
  });
}

gcv_status gcv_region_locate(const gcv_region* region, const double* xy, size_t count,
                             int8_t* out) {
  return guarded([&] {
    require(region, "region");
    if (count == 0) {
      return;
    }
    require(xy, "xy");
    require(out, "out");
    const std::vector<Point> points = read_points(xy, count);
    const gcv::RegionLocator& locator = region->locator();
    std::vector<std::int8_t> places(count);
    std::transform(points.begin(), points.end(), places.begin(), [&](const Point& point) {
      return static_cast<std::int8_t>(locator.locate(point));
    });
    std::copy(places.begin(), places.end(), out);
  });
}

gcv_status gcv_region_stats(const gcv_region* region, gcv_stats* out) {
  return guarded<CallersFloatingPoint>([&] {
    require(region, "region");
    require(out, "out");
    const RoundedRegion& rounded = region->region.rounded;
    gcv::capi::give_stats(region->region.counts, rounded.vertices_repaired, rounded.parts_dropped,
                          out);
  });
}
