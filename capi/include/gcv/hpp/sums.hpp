/* Minkowski sums, no-fit polygons and inner fits; many of them; supersets.
 *
 * Copyright (C) 2026 The libgcv authors
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#ifndef GCV_HPP_SUMS_HPP
#define GCV_HPP_SUMS_HPP

#include <gcv/hpp/outer_face.hpp>
#include <gcv/hpp/region.hpp>

namespace gcv {
inline namespace hpp {

namespace detail {

/** What a function makes of two polygons and options. */
template <class Owner, class Function>
Owner sum(Function function, const Polygon& a, const Polygon& b, const Options& options) {
  return PassedOptions(options).made<Owner>(
      [&](const gcv_options* known, auto** out) { return function(a.get(), b.get(), known, out); });
}
/** And of a point. */
template <class Owner, class Function>
Owner sum(Function function, const Polygon& a, const Polygon& b, Point point,
          const Options& options) {
  return PassedOptions(options).made<Owner>([&](const gcv_options* known, auto** out) {
    return function(a.get(), b.get(), doubles(&point), known, out);
  });
}

}  // namespace detail

/** The outer face of A + B. */
inline OuterFace minkowski_sum(const Polygon& a, const Polygon& b, const Options& options = {}) {
  return detail::sum<OuterFace>(gcv_minkowski_sum, a, b, options);
}

/** Where the reference point of `moving` may go while the two touch. */
inline OuterFace no_fit_polygon(const Polygon& fixed, const Polygon& moving, Point reference = {},
                                const Options& options = {}) {
  return detail::sum<OuterFace>(gcv_no_fit_polygon, fixed, moving, reference, options);
}

/** Shi's entrance block E(A, B). */
inline OuterFace entrance_block(const Polygon& a, const Polygon& b, Point a0 = {},
                                const Options& options = {}) {
  return detail::sum<OuterFace>(gcv_entrance_block, a, b, a0, options);
}

/** The whole of A + B, with its holes and the exact fits. */
inline Region minkowski_sum_region(const Polygon& a, const Polygon& b,
                                   const Options& options = {}) {
  return detail::sum<Region>(gcv_minkowski_sum_region, a, b, options);
}

/** Where the reference point of `moving` may not go. */
inline Region no_fit_region(const Polygon& fixed, const Polygon& moving, Point reference = {},
                            const Options& options = {}) {
  return detail::sum<Region>(gcv_no_fit_region, fixed, moving, reference, options);
}

/** The whole of Shi's entrance block E(A, B). */
inline Region entrance_region(const Polygon& a, const Polygon& b, Point a0 = {},
                              const Options& options = {}) {
  return detail::sum<Region>(gcv_entrance_region, a, b, a0, options);
}

/** Where the reference point of `moving` may go with `moving` inside the container. */
inline Region inner_fit_region(const Polygon& container, const Polygon& moving,
                               Point reference = {}, const Options& options = {}) {
  return detail::sum<Region>(gcv_inner_fit_region, container, moving, reference, options);
}

namespace detail {

inline const gcv_polygon* pointer(const Polygon& polygon) { return polygon.get(); }
inline const gcv_polygon* pointer(const Polygon* polygon) {
  return polygon == nullptr ? nullptr : polygon->get();
}

/** The pointers of a range of polygons, or of pointers or references to polygons. */
template <class Polygons>
std::vector<const gcv_polygon*> pointers(const Polygons& polygons) {
  std::vector<const gcv_polygon*> out;
  for (const auto& polygon : polygons) {
    out.push_back(pointer(polygon));
  }
  return out;
}

/** The number of pairs; throws where there are not as many of all. */
inline std::size_t same(std::size_t first, std::size_t second) {
  if (first != second) {
    throw Error(GCV_ERR_INVALID_ARGUMENT, "many: there are " + std::to_string(first) + " and " +
                                              std::to_string(second) + " of what makes pairs");
  }
  return first;
}

template <class T, class Function, class A, class B>
Many<T> sums(Function function, const A& first, const B& second, const Options& options) {
  const auto a = pointers(first);
  const auto b = pointers(second);
  const std::size_t count = same(a.size(), b.size());
  const PassedOptions passed(options);
  return many<T>(count, [&](auto** out, gcv_status* statuses) {
    passed.check(function(a.data(), b.data(), count, passed.get(), out, statuses));
  });
}

template <class T, class Function, class A, class B>
Many<T> no_fits(Function function, const A& first, const B& second, View<Point> references,
                const Options& options) {
  const auto a = pointers(first);
  const auto b = pointers(second);
  const std::size_t count = same(same(a.size(), b.size()), references.size());
  const PassedOptions passed(options);
  return many<T>(count, [&](auto** out, gcv_status* statuses) {
    passed.check(function(a.data(), b.data(), doubles(references.data()), count, passed.get(), out,
                          statuses));
  });
}

}  // namespace detail

/** Many sums: of ranges of polygons, or of pointers or references to polygons. */
template <class A, class B>
Many<OuterFace> minkowski_sum_many(const A& a, const B& b, const Options& options = {}) {
  return detail::sums<OuterFace>(gcv_minkowski_sum_many, a, b, options);
}

template <class A, class B>
Many<OuterFace> no_fit_polygon_many(const A& fixed, const B& moving, View<Point> references,
                                    const Options& options = {}) {
  return detail::no_fits<OuterFace>(gcv_no_fit_polygon_many, fixed, moving, references, options);
}

template <class A, class B>
Many<Region> minkowski_sum_region_many(const A& a, const B& b, const Options& options = {}) {
  return detail::sums<Region>(gcv_minkowski_sum_region_many, a, b, options);
}

template <class A, class B>
Many<Region> no_fit_region_many(const A& fixed, const B& moving, View<Point> references,
                                const Options& options = {}) {
  return detail::no_fits<Region>(gcv_no_fit_region_many, fixed, moving, references, options);
}

/** The edges that the outer face of A + B is found among. */
inline std::vector<gcv_superset_edge> superset(const Polygon& a, const Polygon& b) {
  using Owner = detail::Handle<gcv_superset, gcv_superset_destroy>;
  const auto owner = detail::made<Owner>(gcv_superset_create, a.get(), b.get());
  return detail::elements<gcv_superset_edge>(
      [&](gcv_superset_edge* out, std::size_t capacity, std::size_t* required) {
        return gcv_superset_edges(owner.get(), out, capacity, required);
      });
}

}  // namespace hpp
}  // namespace gcv

#endif
