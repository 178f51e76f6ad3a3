/* The class of polygons.
 *
 * Copyright (C) 2026 The libgcv authors
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#ifndef GCV_HPP_POLYGON_HPP
#define GCV_HPP_POLYGON_HPP

#include <array>
#include <gcv/hpp/base.hpp>
#include <string_view>

namespace gcv {
inline namespace hpp {

/** xmin, ymin, xmax, ymax. */
using Box = std::array<double, 4>;

/** A polygon, perhaps with holes. It never changes. */
class Polygon {
 public:
  /** Empty. */
  Polygon() = default;
  /** Takes over what the library made; empty for nullptr. */
  explicit Polygon(gcv_polygon* polygon) : handle_(polygon) {}

  /** From the vertices of its boundary, in either orientation. */
  explicit Polygon(View<Point> ring)
      : Polygon(detail::doubles(ring.data()), ring.size(), sizeof(Point)) {}
  Polygon(std::initializer_list<Point> ring) : Polygon(View<Point>(ring)) {}

  /** From vertices so many bytes apart: x of the first is at xy, its y right behind it. */
  Polygon(const double* xy, std::size_t vertex_count, std::size_t stride_bytes = sizeof(Point))
      : Polygon(detail::made<Polygon>(gcv_polygon_create, xy, vertex_count, stride_bytes)) {}

  /** From its rings, the outer one first. */
  static Polygon of_rings(View<View<Point>> rings) {
    std::vector<Point> vertices;
    std::vector<std::size_t> sizes;
    for (const View<Point>& ring : rings) {
      vertices.insert(vertices.end(), ring.begin(), ring.end());
      sizes.push_back(ring.size());
    }
    return of_rings(vertices, sizes);
  }
  /** From the vertices of all rings, one ring after the other, and the sizes of these. */
  static Polygon of_rings(View<Point> vertices, View<std::size_t> sizes) {
    static const std::size_t none = 0;
    detail::require_all(vertices.size(), sizes);
    return detail::made<Polygon>(gcv_polygon_create_rings, detail::doubles(vertices.data()),
                                 sizes.size() != 0 ? sizes.data() : &none, sizes.size(),
                                 sizeof(Point));
  }

  /** From Well-Known Text: "POLYGON ((x y, x y, ...), (hole), ...)". */
  static Polygon of_wkt(std::string_view text) {
    return detail::made<Polygon>(gcv_polygon_create_wkt, text.empty() ? "" : text.data(),
                                 text.size());
  }

  /** A convex polygon in place of a disc: with Rounding::outward it contains the disc. */
  static Polygon disc(Point centre, double radius, double tolerance,
                      Rounding rounding = Rounding::nearest) {
    return detail::made<Polygon>(gcv_polygon_create_disc, detail::doubles(&centre), radius,
                                 tolerance, static_cast<std::int32_t>(rounding));
  }

  /** The number of rings: 1 for the outer one, and 1 for each hole. */
  [[nodiscard]] std::size_t ring_count() const {
    return detail::value(gcv_polygon_ring_count, get());
  }

  /** The vertices of a normalised ring: 0 is the outer one. */
  [[nodiscard]] std::vector<Point> ring(std::size_t index) const {
    return detail::elements<Point>([&](Point* out, std::size_t capacity, std::size_t* required) {
      return gcv_polygon_ring(get(), index, detail::doubles(out), capacity, required);
    });
  }

  /** The vertices of the normalised outer ring. */
  [[nodiscard]] std::vector<Point> vertices() const { return ring(0); }

  /** Writes the vertices of the outer ring, and gives their number. */
  std::size_t vertices(Point* out, std::size_t capacity) const {
    std::size_t count = 0;
    detail::check(gcv_polygon_vertices(get(), detail::doubles(out), capacity, &count));
    return count;
  }
  /** Objects of a derived class are too large for it. */
  template <class Derived>
  std::size_t vertices(Derived* out, std::size_t capacity) const = delete;
  /** Of the normalised outer ring. */
  [[nodiscard]] std::size_t vertex_count() const {
    return detail::value(gcv_polygon_vertex_count, get());
  }

  /** Without the holes. */
  [[nodiscard]] double area() const { return detail::value(gcv_polygon_area, get()); }

  [[nodiscard]] Box bounds() const {
    Box box{};
    detail::check(gcv_polygon_bounds(get(), box.data()));
    return box;
  }

  /** With (x, y) moved to (m[0] x + m[1] y + m[2], m[3] x + m[4] y + m[5]). */
  [[nodiscard]] Polygon affine(const std::array<double, 6>& m) const {
    return detail::made<Polygon>(gcv_polygon_affine, get(), m.data());
  }
  [[nodiscard]] Polygon translated(Point by) const { return affine({1, 0, by.x, 0, 1, by.y}); }
  /** Reflected in the origin. */
  [[nodiscard]] Polygon operator-() const { return affine({-1, 0, 0, 0, -1, 0}); }

  struct Simplified;
  /** With fewer vertices, and a bound on how far it is from this one. */
  [[nodiscard]] Simplified simplified(double tolerance,
                                      Rounding rounding = Rounding::nearest) const;

  /** The pointer for functions of gcv.h; the polygon keeps it. */
  [[nodiscard]] const gcv_polygon* get() const noexcept { return handle_.get(); }
  /** Gives the pointer away, to be ended by gcv_polygon_destroy. */
  gcv_polygon* release() noexcept { return handle_.release(); }

 private:
  detail::Handle<gcv_polygon, gcv_polygon_destroy> handle_;
};

/** A polygon with fewer vertices. */
struct Polygon::Simplified {
  Polygon polygon;
  /** At least the Hausdorff distance between the two boundaries. */
  double error_bound = 0;
};

inline Polygon::Simplified Polygon::simplified(double tolerance, Rounding rounding) const {
  gcv_polygon* out = nullptr;
  double bound = 0;
  detail::check(
      gcv_polygon_simplified(get(), tolerance, static_cast<std::int32_t>(rounding), &out, &bound));
  return {Polygon(out), bound};
}

/** What a call for many gives: results, and the status of each; empty ones for those that failed.
 */
template <class T>
struct Many {
  std::vector<T> results;
  std::vector<gcv_status> statuses;
  /** That of the first failure, which it names. */
  std::string message;

  /** The results; throws the first failure. */
  std::vector<T>& value() & {
    for (const gcv_status status : statuses) {
      if (status != GCV_OK) {
        throw Error(status, message);
      }
    }
    return results;
  }
  std::vector<T> value() && { return std::move(value()); }
};

namespace detail {

/** What a call for so many gives, which writes pointers and statuses, and gives a status. */
template <class T, class Call>
Many<T> many(std::size_t count, const Call& call) {
  Many<T> out{std::vector<T>(count), std::vector<gcv_status>(count), {}};
  std::vector<decltype(std::declval<T>().release())> pointers(count, nullptr);
  call(pointers.data(), out.statuses.data());
  for (std::size_t k = 0; k < count; ++k) {
    out.results[k] = T(pointers[k]);
    if (out.statuses[k] != GCV_OK && out.message.empty()) {
      out.message = gcv_last_error_message();
    }
  }
  return out;
}

}  // namespace detail

/** Many polygons of one ring each: their vertices, one after the other, and their sizes. */
inline Many<Polygon> polygons(View<Point> vertices, View<std::size_t> sizes) {
  detail::require_all(vertices.size(), sizes);
  return detail::many<Polygon>(sizes.size(), [&](gcv_polygon** out, gcv_status* statuses) {
    detail::check(gcv_polygon_create_many(detail::doubles(vertices.data()), sizes.data(),
                                          sizes.size(), sizeof(Point), out, statuses));
  });
}

}  // namespace hpp
}  // namespace gcv

#endif
