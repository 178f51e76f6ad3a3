/* Questions about two polygons, of which B is moved by a translation.
 *
 * Copyright (C) 2026 The libgcv authors
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#ifndef GCV_HPP_TWO_POLYGONS_HPP
#define GCV_HPP_TWO_POLYGONS_HPP

#include <gcv/hpp/polygon.hpp>

namespace gcv {
inline namespace hpp {

/** How two polygons lie. */
enum class Relation : std::int8_t {
  apart = GCV_APART,
  touching = GCV_TOUCHING,
  overlapping = GCV_OVERLAPPING,
};
template <>
inline constexpr bool detail::is_of_gcv<Relation> = true;

/** What touches, or would: gcv_contact.kind. */
enum class ContactKind : std::int32_t {
  edge_vertex = GCV_CONTACT_EDGE_VERTEX,
  vertex_edge = GCV_CONTACT_VERTEX_EDGE,
  vertex_vertex = GCV_CONTACT_VERTEX_VERTEX,
};
template <>
inline constexpr bool detail::is_of_gcv<ContactKind> = true;

namespace detail {

/** What a call gives for so many translations. */
template <class T, class Call>
std::vector<T> answers(std::size_t count, const Options& options, const Call& call) {
  std::vector<T> out(count);
  const PassedOptions passed(options);
  passed.check(call(passed.get(), out.data()));
  return out;
}

template <class Call>
std::vector<Relation> relations(std::size_t count, const Options& options, const Call& call) {
  std::vector<Relation> out;
  out.reserve(count);
  for (const std::int8_t relation : answers<std::int8_t>(count, options, call)) {
    out.push_back(static_cast<Relation>(relation));
  }
  return out;
}

}  // namespace detail

/** How A and B lie, with B moved by each of the translations. */
inline std::vector<Relation> relation(const Polygon& a, const Polygon& b, View<Point> translations,
                                      const Options& options = {}) {
  return detail::relations(
      translations.size(), options, [&](const gcv_options* known, std::int8_t* out) {
        return gcv_relation(a.get(), b.get(), detail::doubles(translations.data()),
                            translations.size(), known, out);
      });
}
inline Relation relation(const Polygon& a, const Polygon& b, Point translation = {},
                         const Options& options = {}) {
  return relation(a, b, View<Point>(&translation, 1), options)[0];
}

/** How far B is from A, and where. */
inline std::vector<gcv_separation> distance(const Polygon& a, const Polygon& b,
                                            View<Point> translations, const Options& options = {}) {
  return detail::answers<gcv_separation>(
      translations.size(), options, [&](const gcv_options* known, gcv_separation* out) {
        return gcv_distance(a.get(), b.get(), detail::doubles(translations.data()),
                            translations.size(), known, out);
      });
}
inline gcv_separation distance(const Polygon& a, const Polygon& b, Point translation = {},
                               const Options& options = {}) {
  return distance(a, b, View<Point>(&translation, 1), options)[0];
}

/** The shortest way of B out of A. */
inline std::vector<gcv_escape> penetration(const Polygon& a, const Polygon& b,
                                           View<Point> translations, const Options& options = {}) {
  return detail::answers<gcv_escape>(
      translations.size(), options, [&](const gcv_options* known, gcv_escape* out) {
        return gcv_penetration(a.get(), b.get(), detail::doubles(translations.data()),
                               translations.size(), known, out);
      });
}
inline gcv_escape penetration(const Polygon& a, const Polygon& b, Point translation = {},
                              const Options& options = {}) {
  return penetration(a, b, View<Point>(&translation, 1), options)[0];
}

/** How far B can move along a motion before it overlaps A. */
inline std::vector<gcv_impact> cast(const Polygon& a, const Polygon& b, View<Point> translations,
                                    View<Point> motions, const Options& options = {}) {
  detail::as_many("motions", motions.size(), "translations", translations.size());
  return detail::answers<gcv_impact>(
      translations.size(), options, [&](const gcv_options* known, gcv_impact* out) {
        return gcv_cast(a.get(), b.get(), detail::doubles(translations.data()),
                        detail::doubles(motions.data()), translations.size(), known, out);
      });
}
inline gcv_impact cast(const Polygon& a, const Polygon& b, Point translation, Point motion,
                       const Options& options = {}) {
  return cast(a, b, View<Point>(&translation, 1), View<Point>(&motion, 1), options)[0];
}

/** A list of contacts. It never changes. */
class ContactList {
 public:
  /** Empty. */
  ContactList() = default;
  /** Takes over what the library made; empty for nullptr. */
  explicit ContactList(gcv_contact_list* list) : handle_(list) {}

  [[nodiscard]] std::vector<gcv_contact> contacts() const {
    return detail::elements<gcv_contact>(
        [&](gcv_contact* out, std::size_t capacity, std::size_t* required) {
          return gcv_contact_list_contacts(get(), out, capacity, required);
        });
  }
  /** The index of each contact in the earlier list, or UINT64_MAX. */
  [[nodiscard]] std::vector<std::uint64_t> previous() const {
    return detail::elements<std::uint64_t>(
        [&](std::uint64_t* out, std::size_t capacity, std::size_t* required) {
          return gcv_contact_list_previous(get(), out, capacity, required);
        });
  }

  /** The pointer for functions of gcv.h; the list keeps it. */
  [[nodiscard]] const gcv_contact_list* get() const noexcept { return handle_.get(); }
  /** Gives the pointer away, to be ended by gcv_contact_list_destroy. */
  gcv_contact_list* release() noexcept { return handle_.release(); }

 private:
  detail::Handle<gcv_contact_list, gcv_contact_list_destroy> handle_;
};

/** All contacts of A and B within a distance. */
inline ContactList contacts(const Polygon& a, const Polygon& b, Point translation = {},
                            double within = 0, double slope = 0, const Options& options = {}) {
  return detail::PassedOptions(options).made<ContactList>([&](const gcv_options* known,
                                                              gcv_contact_list** out) {
    return gcv_contacts(a.get(), b.get(), detail::doubles(&translation), within, slope, known, out);
  });
}

}  // namespace hpp
}  // namespace gcv

#endif
