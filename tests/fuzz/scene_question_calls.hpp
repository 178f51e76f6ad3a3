// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Calls of the questions about scenes. An answer names members that its query admits, and no
// others.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "scene_calls.hpp"

namespace gcv::fuzz {

class SceneQuestionCalls : protected SceneCalls {
 protected:
  using SceneCalls::SceneCalls;

  void scene_relation() {
    ask_scene<std::int8_t>("gcv_scene_relation", {}, [](const Asked& q, std::int8_t* out) {
      return gcv_scene_relation(q.scene, q.moving, q.positions, q.count, q.query, q.options, out);
    });
  }

  void scene_distance() {
    ask_scene<gcv_separation>("gcv_scene_distance", {GCV_ERR_RANGE},
                              [](const Asked& q, gcv_separation* out) {
                                return gcv_scene_distance(q.scene, q.moving, q.positions, q.count,
                                                          q.query, q.options, out);
                              });
  }

  void scene_cast() {
    ask_scene<gcv_impact>("gcv_scene_cast", {GCV_ERR_RANGE},
                          [this](const Asked& q, gcv_impact* out) {
                            const Vectors motions(*this, q.count, *q.faults);
                            return gcv_scene_cast(q.scene, q.moving, q.positions, motions.get(),
                                                  q.count, q.query, q.options, out);
                          });
  }

  void scene_penetration() {
    ask_scene<gcv_escape>(
        "gcv_scene_penetration", {GCV_ERR_RANGE},
        [](const Asked& q, gcv_escape* out) {
          return gcv_scene_penetration(q.scene, q.moving, q.positions, q.count, q.query, q.options,
                                       out);
        },
        Options::Use::inner_fit);
  }

  void scene_near() {
    Chosen scene(*this);
    const gcv_polygon* const moving = pick(polygons_, scene.faults);
    const Options options(input_, scene.faults);
    const Query query(*this, scene);
    std::array<double, 2> point{};
    const double* const position = reference(point, scene.faults);
    const double distance = size(scene.faults);
    const gcv_pair_list* const made =
        make("gcv_scene_near", pair_lists_, scene.faults, {}, [&](gcv_pair_list** out) {
          return gcv_scene_near(scene.handle, moving, position, distance, query.get(),
                                options.get(), out);
        });
    if (made != nullptr) {
      list_families_[made] = 0;
      for (const gcv_pair& pair : all_of(gcv_pair_list_pairs, made)) {
        check(pair.a != 0 && query.admits(pair.a) && pair.b == 0, "a pair that is not asked for");
      }
    }
  }

  void scene_pairs() {
    Chosen scene(*this);
    const Options options(input_, scene.faults);
    const Query query(*this, scene);
    const gcv_pair_list* const previous = any_previous(pair_lists_, scene);
    const double distance = size(scene.faults);
    const gcv_pair_list* const made =
        make("gcv_scene_pairs", pair_lists_, scene.faults, {}, [&](gcv_pair_list** out) {
          return gcv_scene_pairs(scene.handle, previous, distance, query.get(), options.get(), out);
        });
    if (made != nullptr) {
      list_families_[made] = scene.known.family;
      for (const gcv_pair& pair : all_of(gcv_pair_list_pairs, made)) {
        check(pair.a != 0 && pair.a < pair.b && query.admits(pair.a) && query.admits(pair.b),
              "a pair that is not asked for");
      }
    }
  }

  void scene_contacts() {
    Chosen scene(*this);
    const Options options(input_, scene.faults);
    const Query query(*this, scene);
    // A list of two polygons is of no scene.
    const bool is_of_two = input_.below(4) == 3;
    const gcv_contact_list* const of_two = lists_[input_.below(lists_.size())].get();
    const gcv_contact_list* const previous = is_of_two ? of_two : any_previous(scene_lists_, scene);
    scene.faults.add_if(is_of_two && of_two != nullptr, GCV_ERR_INVALID_ARGUMENT);
    const double distance = size(scene.faults);
    const double slope = size(scene.faults);
    const gcv_contact_list* const made =
        make("gcv_scene_contacts", scene_lists_, scene.faults, {GCV_ERR_RANGE},
             [&](gcv_contact_list** out) {
               return gcv_scene_contacts(scene.handle, previous, distance, slope, query.get(),
                                         options.get(), out);
             });
    if (made != nullptr) {
      list_families_[made] = scene.known.family;
      for (const gcv_contact& contact : all_of(gcv_contact_list_contacts, made)) {
        check(contact.id_a != 0 && contact.id_a < contact.id_b && query.admits(contact.id_a) &&
                  query.admits(contact.id_b),
              "a contact that is not asked for");
      }
    }
  }

  void listed_pairs() {
    Faults faults;
    const gcv_pair_list* const list = pick(pair_lists_, faults);
    fill<gcv_pair>("gcv_pair_list_pairs", faults,
                   [&](gcv_pair* out, std::size_t capacity, std::size_t* required) {
                     return gcv_pair_list_pairs(list, out, capacity, required);
                   });
  }
  void scene_listed_contacts() {
    list_of<gcv_contact>("gcv_contact_list_contacts", scene_lists_, gcv_contact_list_contacts);
  }
  void scene_listed_indices() {
    list_of<std::uint64_t>("gcv_contact_list_previous", scene_lists_, gcv_contact_list_previous);
  }

  void scene_free_region() {
    Chosen scene(*this);
    const gcv_polygon* const moving = pick(polygons_, scene.faults);
    const Options options(input_, scene.faults, Options::Use::inner_fit);
    const Query query(*this, scene);
    const std::array<double, 4> bounds = any_window();
    const double* const window = input_.below(8) == 0 ? nullptr : bounds.data();
    const bool are_finite =
        std::all_of(bounds.begin(), bounds.end(), [](double x) { return std::isfinite(x); });
    const bool are_in_order = bounds[0] < bounds[2] && bounds[1] < bounds[3];
    scene.faults.add_if(window != nullptr && !are_finite, GCV_ERR_NOT_FINITE);
    scene.faults.add_if(window != nullptr && are_finite && !are_in_order, GCV_ERR_INVALID_ARGUMENT);
    scene.faults.add_if(window == nullptr && scene.handle != nullptr && !query.has_container(),
                        GCV_ERR_INVALID_ARGUMENT);
    make("gcv_scene_free_region", regions_, scene.faults, {GCV_ERR_RANGE}, [&](gcv_region** out) {
      return gcv_scene_free_region(scene.handle, moving, window, query.get(), options.get(), out);
    });
  }

  void scene_best() {
    Chosen scene(*this);
    const gcv_polygon* const moving = pick(polygons_, scene.faults);
    const Options options(input_, scene.faults, Options::Use::inner_fit);
    const Query query(*this, scene);
    std::array<double, 2> point{};
    const double* const direction = reference(point, scene.faults);
    scene.faults.add_if(
        (point[0] == 0 && point[1] == 0) || (scene.handle != nullptr && !query.has_container()),
        GCV_ERR_INVALID_ARGUMENT);
    constexpr double nowhere = -77;
    constexpr std::int32_t not_yet = -78;
    std::array<double, 3> out{nowhere, nowhere, nowhere};
    std::array<std::int32_t, 2> found{not_yet, not_yet};
    double* const to = scene.faults.pointer(input_.below(16) == 0 ? nullptr : out.data());
    std::int32_t* const is_found =
        scene.faults.pointer(input_.below(16) == 0 ? nullptr : found.data());
    const bool well = judge(
        "gcv_scene_best",
        gcv_scene_best(scene.handle, moving, direction, query.get(), options.get(), to, is_found),
        scene.faults, {GCV_ERR_RANGE});
    check(out[2] == nowhere && found[1] == not_yet, "gcv_scene_best writes beyond a position");
    check(well ? found[0] == 1 || (found[0] == 0 && out[0] == 0 && out[1] == 0)
               : found[0] == not_yet && out[0] == nowhere && out[1] == nowhere,
          "a position or not?");
    check(std::isfinite(out[0]) && std::isfinite(out[1]), "a position that is not finite");
  }

  void destroy_lists() {
    scene_lists_[input_.below(scene_lists_.size())].reset();
    pair_lists_[input_.below(pair_lists_.size())].reset();
    gcv_pair_list_destroy(nullptr);
  }

 private:
  // A query of any size and with any values, in just as much memory; or NULL.
  class Query {
   public:
    Query(SceneQuestionCalls& calls, Chosen& scene) : state_(scene.before) {
      Input& input = calls.input_;
      const bool has_scene_container = scene.known.has_container;
      const std::size_t whole = sizeof(gcv_query);
      const auto size = input.one_of<std::size_t>(
          {SIZE_MAX, whole, whole, SIZE_MAX, 0, 4, whole - 1, whole + 1, whole + 40, 8, whole});
      has_container_ = has_scene_container;
      if (size == SIZE_MAX) {
        return;
      }
      gcv_query query = GCV_QUERY_INIT;
      query.struct_size = static_cast<std::uint32_t>(size);
      query.layers = calls.any_layers();
      ignored_.resize(input.below(4));
      for (std::uint64_t& id : ignored_) {
        id = calls.any_id(state_);
      }
      const std::size_t kind = input.below(8);
      const bool is_null = kind == 7;
      const bool is_huge = kind == 6;
      query.ignore = is_null ? nullptr : ignored_.data();
      query.ignore_count = is_null   ? input.one_of<std::size_t>({0, 1, SIZE_MAX})
                           : is_huge ? SIZE_MAX
                                     : ignored_.size();
      scene.faults.add_if(size >= whole && is_huge, GCV_ERR_INVALID_ARGUMENT);
      const auto unknown = static_cast<unsigned char>(input.below(2));
      bytes_.assign(std::max(size, sizeof query.struct_size), unknown);
      std::memcpy(bytes_.data(), &query, std::min(bytes_.size(), whole));
      scene.faults.add_if(size < whole || (size > whole && unknown != 0), GCV_ERR_INVALID_ARGUMENT);
      scene.faults.add_if(size >= whole && query.ignore == nullptr && query.ignore_count > 0,
                          GCV_ERR_NULL_ARGUMENT);
      if (is_null) {
        ignored_.clear();
      }
      has_container_ = has_scene_container && query.layers != 0 && !ignores(1);
    }

    [[nodiscard]] const gcv_query* get() const {
      return bytes_.empty() ? nullptr : reinterpret_cast<const gcv_query*>(bytes_.data());
    }
    // For the question, does the scene have a container?
    [[nodiscard]] bool has_container() const { return has_container_; }
    // May an answer name this solid? 0 is none.
    [[nodiscard]] bool admits(std::uint64_t id) const {
      return id == 0 || (id == 1 ? has_container_ : is_member(id) && !ignores(id));
    }

   private:
    [[nodiscard]] bool is_member(std::uint64_t id) const {
      return std::any_of(state_.members.begin(), state_.members.end(),
                         [&](const SceneState::Member& member) { return member.id == id; });
    }
    [[nodiscard]] bool ignores(std::uint64_t id) const {
      return std::find(ignored_.begin(), ignored_.end(), id) != ignored_.end();
    }

    const SceneState& state_;
    std::vector<std::uint64_t> ignored_;
    Bytes bytes_;
    bool has_container_ = false;
  };

  // Well formed, empty, inverted, not finite, too large or too small for doubles.
  std::array<double, 4> any_window() {
    static constexpr std::array<double, 4> windows[] = {
        {0, 0, 4, 4},
        {-10, -12, 15.5, 20},
        {0, 0, 0, 4},
        {0, 4, 4, 4},
        {4, 0, 0, 4},
        {0, std::numeric_limits<double>::quiet_NaN(), 4, 4},
        {0, 0, HUGE_VAL, 4},
        {-HUGE_VAL, 0, 4, 4},
        {-1e308, -1e308, 1e308, 1e308},
        {-1.7e308, -1.7e308, 1.7e308, 1.7e308},
        {0, 0, 5e-324, 5e-324},
        {1e17, 1e-17, 1.5e17, 1e-16},
        {-0.0, -1e-308, 1e300, 0},
    };
    const std::size_t k = input_.below(std::size(windows) + 3);
    return k < std::size(windows) ? windows[k] : std::array{number(), number(), number(), number()};
  }

  struct Asked {
    const gcv_scene* scene;
    const gcv_polygon* moving;
    const double* positions;
    std::size_t count;
    const gcv_query* query;
    const gcv_options* options;
    Faults* faults;
  };

  // call(question, out) answers for every position, or writes nothing.
  template <class Result, class Call>
  void ask_scene(const char* name, Statuses others, Call call,
                 Options::Use use = Options::Use::sum) {
    Chosen scene(*this);
    const gcv_polygon* const moving = pick(polygons_, scene.faults);
    const Options options(input_, scene.faults, use);
    const Query query(*this, scene);
    const std::size_t count = any_count();
    const Vectors positions(*this, count, scene.faults);
    const Asked asked{scene.handle, moving,        positions.get(), count,
                      query.get(),  options.get(), &scene.faults};
    for (const Result& result : answers<Result>(name, count, scene.faults, others,
                                                [&](Result* out) { return call(asked, out); })) {
      check(query.admits(named_by(result)), std::string(name) + " names what is not asked for");
    }
  }

  // The id in an answer that can be right by itself, or 0.
  static std::uint64_t named_by(std::int8_t relation) {
    check(is_relation(relation), "no relation");
    return 0;
  }
  static std::uint64_t named_by(const gcv_separation& separation) {
    check(is_relation(separation.relation) && separation.distance >= 0, "no separation");
    return separation.nearest.id_a;
  }
  static std::uint64_t named_by(const gcv_impact& impact) {
    check(is_relation(impact.relation) && impact.time >= 0 && impact.time <= 1 &&
              (impact.hit == 0 || impact.hit == 1),
          "no impact");
    return impact.contact.id_a;
  }
  static std::uint64_t named_by(const gcv_escape& escape) {
    check(is_relation(escape.relation) && escape.depth >= 0, "no way out");
    return escape.contact.id_a;
  }
  static bool is_relation(std::int32_t relation) {
    return relation == GCV_APART || relation == GCV_TOUCHING || relation == GCV_OVERLAPPING;
  }

  // An earlier list, of any scene or of none; or NULL.
  template <class List>
  const List* any_previous(const Slots<List>& lists, Chosen& scene) {
    const std::size_t k = input_.below(lists.size() + 1);
    const List* const previous = k == lists.size() ? nullptr : lists[k].get();
    scene.faults.add_if(previous != nullptr && scene.handle != nullptr &&
                            list_families_.at(previous) != scene.known.family,
                        GCV_ERR_INVALID_ARGUMENT);
    return previous;
  }

  Slots<gcv_contact_list> scene_lists_;  // of scenes, not of two polygons
  Slots<gcv_pair_list> pair_lists_;
  std::map<const void*, std::uint64_t> list_families_;  // of these lists; 0 for no scene's
};

}  // namespace gcv::fuzz
