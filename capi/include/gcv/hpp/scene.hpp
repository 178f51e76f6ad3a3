/* Many polygons at positions, and perhaps a container round them.
 *
 * Copyright (C) 2026 The libgcv authors
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#ifndef GCV_HPP_SCENE_HPP
#define GCV_HPP_SCENE_HPP

#include <gcv/hpp/sums.hpp>
#include <gcv/hpp/two_polygons.hpp>
#include <optional>

namespace gcv {
inline namespace hpp {

/** The number of a member: from 2 on; 1 is the container. */
using Id = std::uint64_t;

/** Which members a question is about. */
struct Query {
  std::uint32_t layers = UINT32_MAX;
  std::vector<Id> ignore = {};
};

/** A list of pairs of members. It never changes. */
class PairList {
 public:
  /** Empty. */
  PairList() = default;
  /** Takes over what the library made; empty for nullptr. */
  explicit PairList(gcv_pair_list* list) : handle_(list) {}

  [[nodiscard]] std::vector<gcv_pair> pairs() const {
    return detail::elements<gcv_pair>(
        [&](gcv_pair* out, std::size_t capacity, std::size_t* required) {
          return gcv_pair_list_pairs(get(), out, capacity, required);
        });
  }

  /** The pointer for functions of gcv.h; the list keeps it. */
  [[nodiscard]] const gcv_pair_list* get() const noexcept { return handle_.get(); }
  /** Gives the pointer away, to be ended by gcv_pair_list_destroy. */
  gcv_pair_list* release() noexcept { return handle_.release(); }

 private:
  detail::Handle<gcv_pair_list, gcv_pair_list_destroy> handle_;
};

namespace detail {

/** A query as the library takes it, while the given one is there. */
inline gcv_query passed(const Query& query) {
  return {sizeof(gcv_query), query.layers, query.ignore.data(), query.ignore.size()};
}

}  // namespace detail

/** Polygons at positions, which can change. A change that throws leaves the scene as it was. */
class Scene {
 public:
  /** Without members and container. */
  Scene() : Scene(detail::made<Scene>(gcv_scene_create)) {}
  /** Takes over what the library made; empty for nullptr. */
  explicit Scene(gcv_scene* scene) : handle_(scene) {}

  /** A scene with the same members, ids and container. */
  [[nodiscard]] Scene copy() const { return detail::made<Scene>(gcv_scene_copy, get()); }

  void set_container(const Polygon& container) {
    detail::check(
        gcv_scene_set_container(handle_.get(), detail::required(container.get(), "container")));
  }
  void remove_container() { detail::check(gcv_scene_set_container(handle_.get(), nullptr)); }

  Id add(const Polygon& polygon, Point position = {}) {
    return add(View<const Polygon*>({&polygon}), View<Point>(&position, 1))[0];
  }
  /** Adds a range of polygons, or of pointers or references to polygons. */
  template <class Polygons>
  std::vector<Id> add(const Polygons& polygons, View<Point> positions) {
    const auto pointers = detail::pointers(polygons);
    std::vector<Id> ids(
        detail::as_many("positions", positions.size(), "polygons", pointers.size()));
    detail::check(gcv_scene_add(handle_.get(), pointers.data(), detail::doubles(positions.data()),
                                ids.size(), ids.data()));
    return ids;
  }

  void move(Id id, Point position) { move(View<Id>(&id, 1), View<Point>(&position, 1)); }
  void move(View<Id> ids, View<Point> positions) {
    const std::size_t count = detail::as_many("positions", positions.size(), "ids", ids.size());
    detail::check(gcv_scene_set(handle_.get(), ids.data(), nullptr,
                                detail::doubles(positions.data()), count));
  }
  void set_polygon(Id id, const Polygon& polygon) {
    set_polygons(View<Id>(&id, 1), View<const Polygon*>({&polygon}));
  }
  /** Gives members other polygons, a range as in add(); each keeps its position. */
  template <class Polygons>
  void set_polygons(View<Id> ids, const Polygons& polygons) {
    const auto pointers = detail::pointers(polygons);
    const std::size_t count = detail::as_many("polygons", pointers.size(), "ids", ids.size());
    detail::check(gcv_scene_set(handle_.get(), ids.data(), pointers.data(), nullptr, count));
  }
  void set(Id id, const Polygon& polygon, Point position) {
    set(View<Id>(&id, 1), View<const Polygon*>({&polygon}), View<Point>(&position, 1));
  }
  /** Gives members other polygons, a range as in add(), and moves them. */
  template <class Polygons>
  void set(View<Id> ids, const Polygons& polygons, View<Point> positions) {
    const auto pointers = detail::pointers(polygons);
    detail::as_many("polygons", pointers.size(), "ids", ids.size());
    const std::size_t count = detail::as_many("positions", positions.size(), "ids", ids.size());
    detail::check(gcv_scene_set(handle_.get(), ids.data(), pointers.data(),
                                detail::doubles(positions.data()), count));
  }
  /** Puts members into layers: of each one a bit for every layer. */
  void set_layers(View<Id> ids, View<std::uint32_t> layers) {
    const std::size_t count = detail::as_many("layers", layers.size(), "ids", ids.size());
    detail::check(gcv_scene_set_layers(handle_.get(), ids.data(), layers.data(), count));
  }
  void remove(Id id) { remove(View<Id>(&id, 1)); }
  void remove(View<Id> ids) {
    detail::check(gcv_scene_remove(handle_.get(), ids.data(), ids.size()));
  }

  /** Of all members, from the smallest on. */
  [[nodiscard]] std::vector<Id> ids() const {
    return detail::elements<Id>([&](Id* out, std::size_t capacity, std::size_t* required) {
      return gcv_scene_ids(get(), out, capacity, required);
    });
  }
  [[nodiscard]] std::vector<Point> positions(View<Id> ids) const {
    std::vector<Point> out(ids.size());
    detail::check(gcv_scene_positions(get(), ids.data(), ids.size(), detail::doubles(out.data())));
    return out;
  }
  [[nodiscard]] Point position(Id id) const { return positions(View<Id>(&id, 1))[0]; }
  [[nodiscard]] Polygon polygon(Id id) const {
    return detail::made<Polygon>(gcv_scene_polygon, get(), id);
  }

  /** All free positions of a polygon in the container. */
  [[nodiscard]] Region free_region(const Polygon& moving, const Query& query = {},
                                   const Options& options = {}) const {
    return free_region(moving, nullptr, query, options);
  }
  /** Those in a window. */
  [[nodiscard]] Region free_region(const Polygon& moving, const Box& window,
                                   const Query& query = {}, const Options& options = {}) const {
    return free_region(moving, window.data(), query, options);
  }

  /** The free position that is furthest in a direction. */
  [[nodiscard]] std::optional<Point> best(const Polygon& moving, Point direction,
                                          const Query& query = {},
                                          const Options& options = {}) const {
    const gcv_query asked = detail::passed(query);
    const detail::PassedOptions passed(options);
    Point position;
    std::int32_t found = 0;
    passed.check(gcv_scene_best(get(), moving.get(), detail::doubles(&direction), &asked,
                                passed.get(), detail::doubles(&position), &found));
    return found != 0 ? std::optional<Point>(position) : std::nullopt;
  }

  [[nodiscard]] std::vector<Relation> relation(const Polygon& moving, View<Point> positions,
                                               const Query& query = {},
                                               const Options& options = {}) const {
    const gcv_query asked = detail::passed(query);
    return detail::relations(
        positions.size(), options, [&](const gcv_options* known, std::int8_t* out) {
          return gcv_scene_relation(get(), moving.get(), detail::doubles(positions.data()),
                                    positions.size(), &asked, known, out);
        });
  }
  [[nodiscard]] Relation relation(const Polygon& moving, Point position, const Query& query = {},
                                  const Options& options = {}) const {
    return relation(moving, View<Point>(&position, 1), query, options)[0];
  }

  [[nodiscard]] std::vector<gcv_separation> distance(const Polygon& moving, View<Point> positions,
                                                     const Query& query = {},
                                                     const Options& options = {}) const {
    const gcv_query asked = detail::passed(query);
    return detail::answers<gcv_separation>(
        positions.size(), options, [&](const gcv_options* known, gcv_separation* out) {
          return gcv_scene_distance(get(), moving.get(), detail::doubles(positions.data()),
                                    positions.size(), &asked, known, out);
        });
  }
  [[nodiscard]] gcv_separation distance(const Polygon& moving, Point position,
                                        const Query& query = {},
                                        const Options& options = {}) const {
    return distance(moving, View<Point>(&position, 1), query, options)[0];
  }

  [[nodiscard]] std::vector<gcv_escape> penetration(const Polygon& moving, View<Point> positions,
                                                    const Query& query = {},
                                                    const Options& options = {}) const {
    const gcv_query asked = detail::passed(query);
    return detail::answers<gcv_escape>(
        positions.size(), options, [&](const gcv_options* known, gcv_escape* out) {
          return gcv_scene_penetration(get(), moving.get(), detail::doubles(positions.data()),
                                       positions.size(), &asked, known, out);
        });
  }
  [[nodiscard]] gcv_escape penetration(const Polygon& moving, Point position,
                                       const Query& query = {}, const Options& options = {}) const {
    return penetration(moving, View<Point>(&position, 1), query, options)[0];
  }

  [[nodiscard]] std::vector<gcv_impact> cast(const Polygon& moving, View<Point> positions,
                                             View<Point> motions, const Query& query = {},
                                             const Options& options = {}) const {
    detail::as_many("motions", motions.size(), "positions", positions.size());
    const gcv_query asked = detail::passed(query);
    return detail::answers<gcv_impact>(
        positions.size(), options, [&](const gcv_options* known, gcv_impact* out) {
          return gcv_scene_cast(get(), moving.get(), detail::doubles(positions.data()),
                                detail::doubles(motions.data()), positions.size(), &asked, known,
                                out);
        });
  }
  [[nodiscard]] gcv_impact cast(const Polygon& moving, Point position, Point motion,
                                const Query& query = {}, const Options& options = {}) const {
    return cast(moving, View<Point>(&position, 1), View<Point>(&motion, 1), query, options)[0];
  }

  /** The members and the container no further than a distance from a polygon at a position. */
  [[nodiscard]] PairList near(const Polygon& moving, Point position, double within,
                              const Query& query = {}, const Options& options = {}) const {
    const gcv_query asked = detail::passed(query);
    return detail::PassedOptions(options).made<PairList>(
        [&](const gcv_options* known, gcv_pair_list** out) {
          return gcv_scene_near(get(), moving.get(), detail::doubles(&position), within, &asked,
                                known, out);
        });
  }

  /** All pairs no further apart than a distance. Of an earlier list, what stays is taken over; of
   * an empty one nothing is. */
  [[nodiscard]] PairList pairs(double within, const PairList& previous = {},
                               const Query& query = {}, const Options& options = {}) const {
    const gcv_query asked = detail::passed(query);
    return detail::PassedOptions(options).made<PairList>(
        [&](const gcv_options* known, gcv_pair_list** out) {
          return gcv_scene_pairs(get(), previous.get(), within, &asked, known, out);
        });
  }

  /** The contacts of all pairs. Of an earlier list, what stays is taken over; of an empty one
   *  nothing is. */
  [[nodiscard]] ContactList contacts(double within, double slope = 0,
                                     const ContactList& previous = {}, const Query& query = {},
                                     const Options& options = {}) const {
    const gcv_query asked = detail::passed(query);
    return detail::PassedOptions(options).made<ContactList>(
        [&](const gcv_options* known, gcv_contact_list** out) {
          return gcv_scene_contacts(get(), previous.get(), within, slope, &asked, known, out);
        });
  }

  /** The pointer for functions of gcv.h; the scene keeps it. */
  [[nodiscard]] const gcv_scene* get() const noexcept { return handle_.get(); }
  [[nodiscard]] gcv_scene* get() noexcept { return handle_.get(); }
  /** Gives the pointer away, to be ended by gcv_scene_destroy. */
  gcv_scene* release() noexcept { return handle_.release(); }

 private:
  [[nodiscard]] Region free_region(const Polygon& moving, const double* window, const Query& query,
                                   const Options& options) const {
    const gcv_query asked = detail::passed(query);
    return detail::PassedOptions(options).made<Region>(
        [&](const gcv_options* known, gcv_region** out) {
          return gcv_scene_free_region(get(), moving.get(), window, &asked, known, out);
        });
  }

  detail::Handle<gcv_scene, gcv_scene_destroy> handle_;
};

}  // namespace hpp
}  // namespace gcv

#endif
