/* The class of regions.
 *
 * Copyright (C) 2026 The libgcv authors
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#ifndef GCV_HPP_REGION_HPP
#define GCV_HPP_REGION_HPP

#include <gcv/hpp/polygon.hpp>

namespace gcv {
inline namespace hpp {

/** Where a point lies in a region. */
enum class Location : std::int8_t {
  inside = GCV_INSIDE,
  boundary = GCV_BOUNDARY,
  outside = GCV_OUTSIDE,
};
template <>
inline constexpr bool detail::is_of_gcv<Location> = true;

/** What a part of a region is: gcv_region_part.kind. */
enum class PartKind : std::int32_t {
  outer = GCV_PART_OUTER,
  hole = GCV_PART_HOLE,
  segment = GCV_PART_SEGMENT,
  point = GCV_PART_POINT,
};
template <>
inline constexpr bool detail::is_of_gcv<PartKind> = true;

/** Polygons with holes, segments and points. It never changes. */
class Region {
 public:
  /** Empty. */
  Region() = default;
  /** Takes over what the library made; empty for nullptr. */
  explicit Region(gcv_region* region) : handle_(region) {}

  /** The parts in the order of their vertices: rings, then segments, then points. */
  [[nodiscard]] std::vector<gcv_region_part> parts() const {
    return detail::elements<gcv_region_part>(
        [&](gcv_region_part* out, std::size_t capacity, std::size_t* required) {
          return gcv_region_parts(get(), out, capacity, required);
        });
  }
  /** The vertices of all parts in doubles, part after part. */
  [[nodiscard]] std::vector<Point> vertices() const {
    return detail::elements<Point>([&](Point* out, std::size_t capacity, std::size_t* required) {
      return gcv_region_vertices(get(), detail::doubles(out), capacity, required);
    });
  }
  /** Writes the vertices, and gives their number. */
  std::size_t vertices(Point* out, std::size_t capacity) const {
    std::size_t count = 0;
    detail::check(gcv_region_vertices(get(), detail::doubles(out), capacity, &count));
    return count;
  }
  /** Objects of a derived class are too large for it. */
  template <class Derived>
  std::size_t vertices(Derived* out, std::size_t capacity) const = delete;

  [[nodiscard]] std::vector<gcv_region_part> exact_parts() const {
    return detail::elements<gcv_region_part>(
        [&](gcv_region_part* out, std::size_t capacity, std::size_t* required) {
          return gcv_region_exact_parts(get(), out, capacity, required);
        });
  }
  /** A vertex of the exact parts as two fractions, "p/q r/s". */
  [[nodiscard]] std::string exact_vertex(std::size_t index) const {
    return detail::text([&](char* out, std::size_t capacity, std::size_t* required) {
      return gcv_region_exact_vertex(get(), index, out, capacity, required);
    });
  }
  /** The exact vertex that each of vertices() stands for. */
  [[nodiscard]] std::vector<std::uint64_t> exact_indices() const {
    return detail::elements<std::uint64_t>(
        [&](std::uint64_t* out, std::size_t capacity, std::size_t* required) {
          return gcv_region_exact_indices(get(), out, capacity, required);
        });
  }
  /** Where the edges of the exact parts come from. */
  [[nodiscard]] std::vector<gcv_edge_source> edge_sources() const {
    return detail::elements<gcv_edge_source>(
        [&](gcv_edge_source* out, std::size_t capacity, std::size_t* required) {
          return gcv_region_edge_sources(get(), out, capacity, required);
        });
  }
  /** The ids of the members of a scene that made the edges of the exact parts. */
  [[nodiscard]] std::vector<std::uint64_t> edge_owners() const {
    return detail::elements<std::uint64_t>(
        [&](std::uint64_t* out, std::size_t capacity, std::size_t* required) {
          return gcv_region_edge_owners(get(), out, capacity, required);
        });
  }

  /** Of the polygons without their holes. */
  [[nodiscard]] double area() const { return detail::value(gcv_region_area, get()); }
  [[nodiscard]] double error_bound() const { return detail::value(gcv_region_error_bound, get()); }
  /** The polygons, a MULTIPOLYGON. */
  [[nodiscard]] std::string wkt() const {
    return detail::text([&](char* out, std::size_t capacity, std::size_t* required) {
      return gcv_region_wkt(get(), out, capacity, required);
    });
  }
  /** The segments and points, a GEOMETRYCOLLECTION. */
  [[nodiscard]] std::string fits_wkt() const {
    return detail::text([&](char* out, std::size_t capacity, std::size_t* required) {
      return gcv_region_fits_wkt(get(), out, capacity, required);
    });
  }
  /** A polygon with its holes, for the next sum. */
  [[nodiscard]] Polygon polygon(std::size_t number) const {
    return detail::made<Polygon>(gcv_region_polygon, get(), number);
  }
  [[nodiscard]] gcv_stats stats() const {
    gcv_stats stats{};
    stats.struct_size = sizeof stats;
    detail::check(gcv_region_stats(get(), &stats));
    return stats;
  }

  /** Where points lie in the exact region. */
  [[nodiscard]] std::vector<Location> locate(View<Point> points) const {
    std::vector<std::int8_t> found(points.size());
    detail::check(
        gcv_region_locate(get(), detail::doubles(points.data()), points.size(), found.data()));
    std::vector<Location> locations;
    locations.reserve(found.size());
    for (const std::int8_t location : found) {
      locations.push_back(static_cast<Location>(location));
    }
    return locations;
  }
  [[nodiscard]] Location locate(Point point) const { return locate(View<Point>(&point, 1))[0]; }

  /** The pointer for functions of gcv.h; the region keeps it. */
  [[nodiscard]] const gcv_region* get() const noexcept { return handle_.get(); }
  /** Gives the pointer away, to be ended by gcv_region_destroy. */
  gcv_region* release() noexcept { return handle_.release(); }

 private:
  detail::Handle<gcv_region, gcv_region_destroy> handle_;
};

}  // namespace hpp
}  // namespace gcv

#endif
