// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The method is that of outward.cpp. The exact region is rounded to the nearest doubles, which
// gives N. Let e1 bound how far vertices move. N is grown by a square of half width d, or shrunk,
// exactly. The result is rounded to the nearest doubles again, where vertices move by at most e2.
// If e1 + e2 < d, what was outside stays outside. Where N is shrunk, the second rounding must not
// drop holes, which are obstacles. Where N is grown, what is outside may come apart: a part that is
// no hole of N lies outside of the outer ring, which is rounded by itself.
//
// The error. A point that shrinking takes away is within sqrt(2) d of what was outside before.
#include "region_outward.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "box.hpp"
#include "error.hpp"
#include "exact_indices.hpp"
#include "region_distance.hpp"
#include "region_rounding.hpp"
#include "rounding.hpp"
#include "units.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

// A polygon of a rounded region, and where its vertices are in that.
struct RoundedPolygon {
  std::shared_ptr<const Polygon> polygon;
  std::size_t first;  // vertex of the region
};

// The vertex of the polygon that was summed with a square, in its own numbers, whose edge leads on
// from that vertex of the sum; of a side of the square, where that is added.
std::size_t vertex_of_edge(const ExactRegion& sum, const RingVertex& vertex) {
  const EdgeName e = vertex.leaving();
  const Boundary::Corner& corner = sum.a.ring->corners[e.i];
  return e.kind == EdgeName::corner ? corner.vertex_number : corner.edge_number;
}

std::vector<RoundedPolygon> polygons_of(const RoundedRegion& region) {
  std::vector<RoundedPolygon> polygons;
  for (std::size_t k = 0; k < region.parts.size() && region.parts[k].is_ring();) {
    const std::size_t first = region.parts[k].first;
    const Index number = region.parts[k].polygon;
    std::vector<PointVector> rings;
    for (; k < region.parts.size() && region.parts[k].polygon == number; ++k) {
      const auto begin =
          region.vertices.begin() + static_cast<std::ptrdiff_t>(region.parts[k].first);
      rings.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(region.parts[k].size));
    }
    polygons.push_back(
        {std::make_shared<const Polygon>(make_polygon(std::move(rings), "the rounded region")),
         first});
  }
  return polygons;
}

std::shared_ptr<const Polygon> square(double d) {
  return std::make_shared<const Polygon>(PointVector{{-d, -d}, {d, -d}, {d, d}, {-d, d}}, "square");
}

// At least the extents of what is dropped, whose vertices are off these by the error.
double dropped_bound(std::span<const Point> points, double error) {
  const Box box = box_of(points);
  return exact_extents_bound(length_bound(box.x1 - box.x0, box.y1 - box.y0), error);
}

// Does the rounded region keep a polygon without one of its holes?
bool has_lost_hole(const ExactRegion& exact, const RoundedRegion& rounded) {
  if (rounded.parts_dropped == 0) {
    return false;
  }
  std::vector<std::size_t> holes;  // of each polygon
  for (const RegionPart& part : exact.parts) {
    if (part.kind == PartKind::outer) {
      holes.push_back(0);
    } else if (part.kind == PartKind::hole) {
      ++holes[part.polygon];
    }
  }
  std::size_t wanted = 0;
  std::size_t kept = 0;
  for (const RegionPart& ring : rounded.parts) {
    if (ring.kind == PartKind::outer) {
      const std::uint64_t vertex = rounded.exact_indices[ring.first];
      const auto part =
          std::partition_point(exact.parts.begin(), exact.parts.end(),
                               [&](const RegionPart& other) { return other.end() <= vertex; });
      wanted += holes[part->polygon];
    } else if (ring.kind == PartKind::hole) {
      ++kept;
    }
  }
  return kept < wanted;
}

enum class Safe { outward, inward };

class SafeRounder {
 public:
  SafeRounder(Safe way, const RegionWithSquare& with_square, Task& task, Tally& tally)
      : way_(way), with_square_(with_square), task_(task), tally_(tally) {}

  // The rings of the region on the safe side of the exact ones. Nothing if all of a few widths of
  // the square are too small.
  std::optional<RoundedRegion> run(const RoundedRegion& nearest) {
    const std::vector<RoundedPolygon> polygons = polygons_of(nearest);
    const Point units = units_in_last_place(nearest.vertices);
    double d = 2 * std::max(units.x, units.y);
    while (d <= nearest.displacement) {
      d *= 2;
    }
    for (int tries = 0; tries < 6; ++tries) {
      if (std::optional<RoundedRegion> safe = with(nearest, polygons, d)) {
        return safe;
      }
      d *= 2;
    }
    return std::nullopt;
  }

 private:
  std::optional<RoundedRegion> with(const RoundedRegion& nearest,
                                    const std::vector<RoundedPolygon>& polygons, double d) {
    RoundedRegion safe;
    std::vector<bool> is_left(nearest.vertices.size());
    Index number = 0;
    double furthest = 1.5 * d;
    for (const RoundedPolygon& polygon : polygons) {
      const ExactRegion exact = with_square_(polygon.polygon, square(d));
      const RoundedRegion rounded = round_to_nearest(exact, false, task_, tally_);
      if (!(sum_bound(nearest.displacement, rounded.displacement) < d) ||
          (way_ == Safe::inward && has_lost_hole(exact, rounded))) {
        return std::nullopt;
      }
      safe.displacement = std::max(safe.displacement, rounded.displacement);
      furthest = std::max(furthest, distance_from_region(exact, task_, tally_));
      safe.vertices_repaired += rounded.vertices_repaired;
      for (const RegionPart& part : rounded.parts) {
        std::vector<std::size_t> vertices;  // of `nearest`
        for (std::size_t k = part.first; k < part.end(); ++k) {
          const RingVertex& vertex =
              exact.vertices[static_cast<std::size_t>(rounded.exact_indices[k])];
          vertices.push_back(polygon.first + vertex_of_edge(exact, vertex));
        }
        const bool is_outside = way_ == Safe::outward && part.kind == PartKind::hole &&
                                vertices.front() < nearest.parts.front().size;
        if (!part.is_ring() || is_outside) {
          continue;
        }
        add(rounded, part, number, safe);
        for (const std::size_t vertex : vertices) {
          is_left[vertex] = true;
          safe.exact_indices.push_back(nearest.exact_indices[vertex]);
        }
      }
      number = safe.parts.empty() ? 0 : safe.parts.back().polygon + 1;
    }
    safe.error_bound =
        next_up((furthest + nearest.error_bound + safe.displacement) * (1 + 0x1p-50));
    safe.displacement = safe.error_bound;
    safe.vertices_repaired += nearest.vertices_repaired;
    safe.parts_dropped = nearest.parts_dropped;
    for (const RegionPart& part : nearest.parts) {
      if (!part.is_ring()) {
        continue;
      }
      const auto begin = is_left.begin() + static_cast<std::ptrdiff_t>(part.first);
      const auto end = begin + static_cast<std::ptrdiff_t>(part.size);
      if (std::find(begin, end, true) == end) {
        ++safe.parts_dropped;
        const std::span<const Point> all = nearest.vertices;
        safe.error_bound =
            std::max(safe.error_bound,
                     dropped_bound(all.subspan(part.first, part.size), nearest.error_bound));
      }
    }
    return safe;
  }

  static void add(const RoundedRegion& rounded, const RegionPart& part, Index number,
                  RoundedRegion& safe) {
    safe.parts.push_back({part.kind, number + part.polygon, safe.vertices.size(), part.size});
    const auto begin = rounded.vertices.begin() + static_cast<std::ptrdiff_t>(part.first);
    safe.vertices.insert(safe.vertices.end(), begin,
                         begin + static_cast<std::ptrdiff_t>(part.size));
  }

  Safe way_;
  const RegionWithSquare& with_square_;
  Task& task_;
  Tally& tally_;
};

// Puts a ring in the place of the first one.
void replace_first_ring(const PointVector& ring, const std::vector<std::size_t>& indices,
                        RoundedRegion& region) {
  const auto size = static_cast<std::ptrdiff_t>(region.parts.front().size);
  region.vertices.erase(region.vertices.begin(), region.vertices.begin() + size);
  region.vertices.insert(region.vertices.begin(), ring.begin(), ring.end());
  region.exact_indices.erase(region.exact_indices.begin(), region.exact_indices.begin() + size);
  region.exact_indices.insert(region.exact_indices.begin(), indices.begin(), indices.end());
  region.parts.front().size = ring.size();
  for (std::size_t k = 1; k < region.parts.size(); ++k) {
    region.parts[k].first = region.parts[k - 1].end();
  }
}

// A polygon of an exact region by itself.
struct Island {
  ExactRegion exact;
  std::size_t first;  // vertex of the region
};

std::vector<Island> islands_of(const ExactRegion& region) {
  std::vector<Island> islands;
  const ExactRing shared{
      region.a, region.b, region.shift, {}, region.chains_are_repeated, region.against_edges};
  for (const RegionPart& part : region.parts) {
    if (part.kind == PartKind::outer) {
      islands.push_back({{shared, {}}, part.first});
    }
    if (part.is_ring()) {
      auto& [exact, first] = islands.back();
      exact.parts.push_back({part.kind, 0, part.first - first, part.size});
      const auto begin = region.vertices.begin() + static_cast<std::ptrdiff_t>(part.first);
      exact.vertices.insert(exact.vertices.end(), begin,
                            begin + static_cast<std::ptrdiff_t>(part.size));
    }
  }
  return islands;
}

// An island by itself, so that one that is hardly wider than the gaps between doubles takes nothing
// from the others. Such a one is dropped.
RoundedRegion island_inward(const ExactRegion& island, const RegionWithSquare& fits_of, Task& task,
                            Tally& tally) {
  RoundedRegion nearest = round_to_nearest(island, false, task, tally);
  if (nearest.parts.empty() || (nearest.displacement == 0 && nearest.parts_dropped == 0)) {
    return nearest;
  }
  if (nearest.parts_dropped > 0) {
    throw Error(Status::range,
                "an obstacle inside the region, or the room round it, is too thin for doubles");
  }
  if (auto safe = SafeRounder(Safe::inward, fits_of, task, tally).run(nearest)) {
    return std::move(*safe);
  }
  RoundedRegion nothing;
  nothing.error_bound = dropped_bound(nearest.vertices, nearest.error_bound);
  nothing.parts_dropped = island.parts.size();
  return nothing;
}

// Adds an island whose exact vertices begin at `first`.
void append(RoundedRegion&& island, std::size_t first, RoundedRegion& region) {
  const Index number = region.parts.empty() ? 0 : region.parts.back().polygon + 1;
  for (const RegionPart& part : island.parts) {
    region.parts.push_back(
        {part.kind, number + part.polygon, region.vertices.size() + part.first, part.size});
  }
  region.vertices.insert(region.vertices.end(), island.vertices.begin(), island.vertices.end());
  for (const std::uint64_t index : island.exact_indices) {
    region.exact_indices.push_back(first + index);
  }
  region.error_bound = std::max(region.error_bound, island.error_bound);
  region.displacement = std::max(region.displacement, island.displacement);
  region.vertices_repaired += island.vertices_repaired;
  region.parts_dropped += island.parts_dropped;
}

// At least the extents of what rounds to these points, infinite beyond the largest double. The two
// roundings beside those of length_bound() are within its factor.
double extents_bound(const PointVector& points) {
  const Box box = box_of(std::span<const Point>(points));
  const Point units = units_in_last_place(points);
  const double width = box.x1 - box.x0 + units.x;
  const double height = box.y1 - box.y0 + units.y;
  return std::isfinite(width) && std::isfinite(height) ? length_bound(width, height) : infinity;
}

// Segments and points whose vertices are doubles. The others are dropped, and count with their
// extents.
void add_exact_fits(const ExactRegion& exact, Tally& tally, RoundedRegion& region) {
  for (const RegionPart& part : exact.parts) {
    if (part.is_ring()) {
      continue;
    }
    PointVector vertices;
    bool is_exact = true;
    for (std::size_t k = part.first; k < part.end(); ++k) {
      const RoundedVertex v =
          rounded_vertex(*exact.a.ring, *exact.b.ring, exact.vertices[k], exact.shift, tally);
      vertices.push_back({v.x.value, v.y.value});
      is_exact = is_exact && v.x.exact && v.y.exact;
    }
    if (!is_exact) {
      ++region.parts_dropped;
      region.error_bound = std::max(region.error_bound, extents_bound(vertices));
      continue;
    }
    region.parts.push_back({part.kind, part.polygon, region.vertices.size(), part.size});
    for (std::size_t k = 0; k < part.size; ++k) {
      region.vertices.push_back(vertices[k]);
      region.exact_indices.push_back(part.first + k);
    }
  }
}

}  // namespace

RoundedRegion round_region_outward(const ExactRegion& region, const OuterFaceOf& outer_face_of,
                                   const RegionWithSquare& sum_with, Task& task, Tally& tally) {
  RoundedRegion nearest = round_to_nearest(region, true, task, tally);
  if (nearest.error_bound == 0) {
    return nearest;
  }
  RoundedRegion safe;
  if (region.parts.size() == 1) {
    safe = std::move(nearest);
  } else if (auto grown = SafeRounder(Safe::outward, sum_with, task, tally).run(nearest)) {
    safe = std::move(*grown);
  } else {
    throw Error(Status::range, "no region of doubles close to the exact one was found");
  }
  const std::size_t size = region.parts.front().size;
  ExactRing outer{region.a, region.b, region.shift, {}, region.chains_are_repeated, false};
  outer.vertices.assign(region.vertices.begin(),
                        region.vertices.begin() + static_cast<std::ptrdiff_t>(size));
  const RoundedRing ring = round_outward(outer, outer_face_of, task, tally);
  const Placement placement = place_nearest(outer, task, tally);
  replace_first_ring(ring.vertices, closest_edges(placement.places, ring.vertices, task), safe);
  safe.error_bound = std::max(safe.error_bound, ring.error_bound);
  add_exact_fits(region, tally, safe);
  return safe;
}

RoundedRegion round_region_inward(const ExactRegion& region, const RegionWithSquare& fits_of,
                                  Task& task, Tally& tally) {
  RoundedRegion safe;
  for (const Island& island : islands_of(region)) {
    append(island_inward(island.exact, fits_of, task, tally), island.first, safe);
  }
  add_exact_fits(region, tally, safe);
  return safe;
}

}  // namespace gcv
