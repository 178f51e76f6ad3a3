/* The class of outer faces.
 *
 * Copyright (C) 2026 The libgcv authors
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#ifndef GCV_HPP_OUTER_FACE_HPP
#define GCV_HPP_OUTER_FACE_HPP

#include <gcv/hpp/polygon.hpp>

namespace gcv {
inline namespace hpp {

/** What an edge comes from: gcv_edge_source.kind. */
enum class EdgeKind : std::int32_t {
  translated = GCV_EDGE_TRANSLATED,
  corner = GCV_EDGE_CORNER,
  translated_corner = GCV_EDGE_TRANSLATED_CORNER,
};
template <>
inline constexpr bool detail::is_of_gcv<EdgeKind> = true;

/** The outer face of a sum: one simple ring. It never changes. */
class OuterFace {
 public:
  /** Empty. */
  OuterFace() = default;
  /** Takes over what the library made; empty for nullptr. */
  explicit OuterFace(gcv_outer_face* face) : handle_(face) {}

  /** The ring in doubles, counter-clockwise, not closed. */
  [[nodiscard]] std::vector<Point> vertices() const {
    return detail::elements<Point>([&](Point* out, std::size_t capacity, std::size_t* required) {
      return gcv_outer_face_vertices(get(), detail::doubles(out), capacity, required);
    });
  }
  /** Writes the vertices, and gives their number. */
  std::size_t vertices(Point* out, std::size_t capacity) const {
    std::size_t count = 0;
    detail::check(gcv_outer_face_vertices(get(), detail::doubles(out), capacity, &count));
    return count;
  }
  /** Objects of a derived class are too large for it. */
  template <class Derived>
  std::size_t vertices(Derived* out, std::size_t capacity) const = delete;
  [[nodiscard]] std::size_t vertex_count() const {
    return detail::value(gcv_outer_face_vertex_count, get());
  }

  [[nodiscard]] std::size_t exact_vertex_count() const {
    return detail::value(gcv_outer_face_exact_vertex_count, get());
  }
  /** A vertex of the exact ring as two fractions, "p/q r/s". */
  [[nodiscard]] std::string exact_vertex(std::size_t index) const {
    return detail::text([&](char* out, std::size_t capacity, std::size_t* required) {
      return gcv_outer_face_exact_vertex(get(), index, out, capacity, required);
    });
  }
  /** The exact vertex that each of vertices() stands for. */
  [[nodiscard]] std::vector<std::uint64_t> exact_indices() const {
    return detail::elements<std::uint64_t>(
        [&](std::uint64_t* out, std::size_t capacity, std::size_t* required) {
          return gcv_outer_face_exact_indices(get(), out, capacity, required);
        });
  }
  /** Where the edges of the exact ring come from. */
  [[nodiscard]] std::vector<gcv_edge_source> edge_sources() const {
    return detail::elements<gcv_edge_source>(
        [&](gcv_edge_source* out, std::size_t capacity, std::size_t* required) {
          return gcv_outer_face_edge_sources(get(), out, capacity, required);
        });
  }

  [[nodiscard]] double error_bound() const {
    return detail::value(gcv_outer_face_error_bound, get());
  }
  /** Inside the ring: holes of the sum are not subtracted. */
  [[nodiscard]] double area() const { return detail::value(gcv_outer_face_area, get()); }
  [[nodiscard]] std::string wkt() const {
    return detail::text([&](char* out, std::size_t capacity, std::size_t* required) {
      return gcv_outer_face_wkt(get(), out, capacity, required);
    });
  }
  /** The ring as a polygon, for the next sum. */
  [[nodiscard]] Polygon polygon() const {
    return detail::made<Polygon>(gcv_outer_face_polygon, get());
  }
  [[nodiscard]] gcv_stats stats() const {
    gcv_stats stats{};
    stats.struct_size = sizeof stats;
    detail::check(gcv_outer_face_stats(get(), &stats));
    return stats;
  }

  /** The pointer for functions of gcv.h; the outer face keeps it. */
  [[nodiscard]] const gcv_outer_face* get() const noexcept { return handle_.get(); }
  /** Gives the pointer away, to be ended by gcv_outer_face_destroy. */
  gcv_outer_face* release() noexcept { return handle_.release(); }

 private:
  detail::Handle<gcv_outer_face, gcv_outer_face_destroy> handle_;
};

}  // namespace hpp
}  // namespace gcv

#endif
