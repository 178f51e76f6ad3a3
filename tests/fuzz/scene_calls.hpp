// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Calls of the functions that make, change and read scenes. A change that fails leaves its scene as
// it was, another one changes what it names and nothing else.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "question_calls.hpp"

namespace gcv::fuzz {

// What a function like gcv_scene_ids gives.
template <class Element, class Handle>
std::vector<Element> all_of(gcv_status (*list)(const Handle*, Element*, std::size_t, std::size_t*),
                            const Handle* handle) {
  std::size_t count = 0;
  check(list(handle, nullptr, 0, &count) == GCV_OK, "no number of elements");
  std::vector<Element> all(count + 1);
  check(list(handle, all.data(), count, &count) == GCV_OK, "no elements");
  all.resize(count);
  return all;
}

// What can be read of a scene: its members, by id.
struct SceneState {
  struct Member {
    std::uint64_t id;
    std::array<double, 2> position;
    std::array<double, 4> bounds;  // of its polygon

    friend bool operator==(const Member&, const Member&) = default;
  };
  std::vector<Member> members;

  SceneState() = default;
  explicit SceneState(const gcv_scene* scene) {
    for (const std::uint64_t id : all_of(gcv_scene_ids, scene)) {
      Member member{id, {}, {}};
      check(gcv_scene_positions(scene, &id, 1, member.position.data()) == GCV_OK, "no position");
      gcv_polygon* polygon = nullptr;
      check(gcv_scene_polygon(scene, id, &polygon) == GCV_OK, "no polygon");
      member.bounds = bounds_of(Polygon(polygon).get());
      members.push_back(member);
    }
  }

  static std::array<double, 4> bounds_of(const gcv_polygon* polygon) {
    std::array<double, 4> bounds{};
    check(gcv_polygon_bounds(polygon, bounds.data()) == GCV_OK, "no bounds");
    return bounds;
  }

  // Or NULL.
  Member* find(std::uint64_t id) {
    const auto found = std::find_if(members.begin(), members.end(),
                                    [&](const Member& member) { return member.id == id; });
    return found == members.end() ? nullptr : &*found;
  }
  [[nodiscard]] std::uint64_t last_id() const { return members.empty() ? 1 : members.back().id; }

  friend bool operator==(const SceneState&, const SceneState&) = default;
};

class SceneCalls : protected QuestionCalls {
 protected:
  using QuestionCalls::QuestionCalls;

  void scene_create() {
    Faults faults;
    const gcv_scene* const made = make("gcv_scene_create", scenes_, faults, {},
                                       [](gcv_scene** out) { return gcv_scene_create(out); });
    if (made != nullptr) {
      known_[made] = {++last_family_, false};
      check(SceneState(made) == SceneState(), "a new scene has members");
    }
  }

  void scene_copy() {
    Chosen scene(*this);
    const gcv_scene* const made =
        make("gcv_scene_copy", scenes_, scene.faults, {},
             [&](gcv_scene** out) { return gcv_scene_copy(scene.handle, out); });
    if (made != nullptr) {
      known_[made] = scene.known;
      check(SceneState(made) == scene.before, "a copy has other members");
    }
  }

  void scene_set_container() {
    Chosen scene(*this);
    const gcv_polygon* const container = polygons_[input_.below(polygons_.size())].get();
    const bool well = judge("gcv_scene_set_container",
                            gcv_scene_set_container(scene.handle, container), scene.faults);
    if (well) {
      known_[scene.handle].has_container = container != nullptr;
    }
    scene.check_state(scene.before);
  }

  void scene_add() {
    constexpr std::size_t many = 20;
    Chosen scene(*this);
    const std::size_t count = scene.before.members.size() > many ? 0 : any_count();
    const Polygons polygons(*this, count);
    scene.faults.add_if(count > 0 && (polygons.get() == nullptr || polygons.has_null()),
                        GCV_ERR_NULL_ARGUMENT);
    const Vectors positions(*this, count, scene.faults);
    const auto ids =
        answers<std::uint64_t>("gcv_scene_add", count, scene.faults, {}, [&](std::uint64_t* out) {
          return gcv_scene_add(scene.handle, polygons.get(), positions.get(), count, out);
        });
    SceneState expected = scene.before;
    for (std::size_t k = 0; k < ids.size(); ++k) {
      check(ids[k] == ids[0] + k && ids[k] > expected.last_id(), "ids in another order");
      expected.members.push_back({ids[k],
                                  {positions.get()[2 * k], positions.get()[2 * k + 1]},
                                  SceneState::bounds_of(polygons.get()[k])});
    }
    scene.check_state(expected);
  }

  void scene_set() {
    Chosen scene(*this);
    const Ids ids(*this, scene);
    const std::size_t count = ids.count();
    const Polygons all(*this, count);
    const gcv_polygon* const* const polygons = input_.below(4) == 0 ? nullptr : all.get();
    Faults of_numbers;
    const Vectors vectors(*this, count, of_numbers);
    const double* const positions = input_.below(4) == 0 ? nullptr : vectors.get();
    scene.faults.add_if(polygons != nullptr && all.has_null(), GCV_ERR_NULL_ARGUMENT);
    scene.faults.add_if(positions != nullptr && of_numbers.explain(GCV_ERR_NOT_FINITE),
                        GCV_ERR_NOT_FINITE);
    const bool well =
        judge("gcv_scene_set", gcv_scene_set(scene.handle, ids.get(), polygons, positions, count),
              scene.faults);
    SceneState expected = scene.before;
    for (std::size_t k = 0; well && k < count; ++k) {
      SceneState::Member& member = *expected.find(ids.get()[k]);
      if (polygons != nullptr) {
        member.bounds = SceneState::bounds_of(polygons[k]);
      }
      if (positions != nullptr) {
        member.position = {positions[2 * k], positions[2 * k + 1]};
      }
    }
    scene.check_state(expected);
  }

  void scene_set_layers() {
    Chosen scene(*this);
    const Ids ids(*this, scene);
    std::vector<std::uint32_t> layers(most_named);
    for (std::uint32_t& some : layers) {
      some = any_layers();
    }
    const bool is_null = input_.below(16) == 0;
    scene.faults.add_if(is_null && ids.count() > 0, GCV_ERR_NULL_ARGUMENT);
    judge("gcv_scene_set_layers",
          gcv_scene_set_layers(scene.handle, ids.get(), is_null ? nullptr : layers.data(),
                               ids.count()),
          scene.faults);
    scene.check_state(scene.before);
  }

  void scene_remove() {
    Chosen scene(*this);
    const Ids ids(*this, scene);
    const bool well = judge("gcv_scene_remove",
                            gcv_scene_remove(scene.handle, ids.get(), ids.count()), scene.faults);
    SceneState expected = scene.before;
    for (std::size_t k = 0; well && k < ids.count(); ++k) {
      std::erase_if(expected.members,
                    [&](const SceneState::Member& member) { return member.id == ids.get()[k]; });
    }
    scene.check_state(expected);
  }

  void scene_ids() {
    const Chosen scene(*this);
    fill<std::uint64_t>("gcv_scene_ids", scene.faults,
                        [&](std::uint64_t* out, std::size_t capacity, std::size_t* required) {
                          return gcv_scene_ids(scene.handle, out, capacity, required);
                        });
  }

  void scene_positions() {
    Chosen scene(*this);
    const Ids ids(*this, scene);
    const auto positions =
        answers<Vertex>("gcv_scene_positions", ids.count(), scene.faults, {}, [&](Vertex* out) {
          return gcv_scene_positions(scene.handle, ids.get(), ids.count(),
                                     reinterpret_cast<double*>(out));
        });
    for (std::size_t k = 0; k < positions.size(); ++k) {
      const auto [x, y] = scene.before.find(ids.get()[k])->position;
      check(positions[k].x == x && positions[k].y == y, "another position");
    }
  }

  void scene_polygon() {
    Chosen scene(*this);
    const std::uint64_t id = any_id(scene.before);
    scene.faults.add_if(scene.handle != nullptr && scene.before.find(id) == nullptr,
                        GCV_ERR_INVALID_ARGUMENT);
    make("gcv_scene_polygon", polygons_, scene.faults, {},
         [&](gcv_polygon** out) { return gcv_scene_polygon(scene.handle, id, out); });
  }

  void scene_destroy() {
    scenes_[input_.below(scenes_.size())].reset();
    gcv_scene_destroy(nullptr);
  }

  // What no function tells about a scene.
  struct Known {
    std::uint64_t family = 0;  // the same for a scene and its copies, not 0
    bool has_container = false;
  };

  // A scene, or NULL.
  struct Chosen {
    Faults faults;
    gcv_scene* handle;
    Known known;
    SceneState before;

    explicit Chosen(SceneCalls& calls)
        : handle(faults.pointer(calls.scenes_[calls.input_.below(calls.scenes_.size())].get())) {
      if (handle != nullptr) {
        known = calls.known_.at(handle);
        before = SceneState(handle);
      }
    }

    void check_state(const SceneState& expected) const {
      check((handle == nullptr ? SceneState() : SceneState(handle)) == expected,
            "a scene is not as it must be");
    }
  };

  static constexpr std::size_t most_named = 4;

  // A few, or more than an array can hold.
  std::size_t any_count() {
    return input_.one_of<std::size_t>({0, 1, 2, 3, most_named, 1, 2, SIZE_MAX});
  }

  // Of a member, of the container, of one that was removed, or of none.
  std::uint64_t any_id(const SceneState& state) {
    const std::size_t k = input_.below(256);
    const std::array<std::uint64_t, 6> others{0, 1, 2, 3, state.last_id() + 1, UINT64_MAX};
    return k < 192 && !state.members.empty() ? state.members[k % state.members.size()].id
                                             : others[k % others.size()];
  }

  std::uint32_t any_layers() {
    return input_.one_of<std::uint32_t>({UINT32_MAX, 1, 2, 3, 0, 1U << 31U});
  }

  Slots<gcv_scene> scenes_;

 private:
  // Ids for a change, or NULL.
  class Ids {
   public:
    Ids(SceneCalls& calls, Chosen& scene) : ids_(most_named), count_(calls.any_count()) {
      bool are_wrong = false;
      for (std::size_t k = 0; count_ <= most_named && k < count_; ++k) {
        ids_[k] = calls.any_id(scene.before);
        const auto end = ids_.begin() + static_cast<std::ptrdiff_t>(k);
        are_wrong = are_wrong || scene.before.find(ids_[k]) == nullptr ||
                    std::find(ids_.begin(), end, ids_[k]) != end;
      }
      is_null_ = calls.input_.below(16) == 0;
      scene.faults.add_if(is_null_ && count_ > 0, GCV_ERR_NULL_ARGUMENT);
      scene.faults.add_if(are_wrong && scene.handle != nullptr, GCV_ERR_INVALID_ARGUMENT);
      scene.faults.add_if(count_ > most_named, GCV_ERR_INVALID_ARGUMENT);
    }

    [[nodiscard]] const std::uint64_t* get() const { return is_null_ ? nullptr : ids_.data(); }
    [[nodiscard]] std::size_t count() const { return count_; }

   private:
    std::vector<std::uint64_t> ids_;
    std::size_t count_;
    bool is_null_;
  };

  // Polygons, some of which may be NULL; or NULL.
  class Polygons {
   public:
    Polygons(SceneCalls& calls, std::size_t count) : polygons_(std::min(count, most_named)) {
      for (const gcv_polygon*& polygon : polygons_) {
        polygon = calls.polygons_[calls.input_.below(calls.polygons_.size())].get();
      }
      is_null_ = calls.input_.below(16) == 0;
    }

    [[nodiscard]] const gcv_polygon* const* get() const {
      return is_null_ ? nullptr : polygons_.data();
    }
    [[nodiscard]] bool has_null() const {
      return std::find(polygons_.begin(), polygons_.end(), nullptr) != polygons_.end();
    }

   private:
    std::vector<const gcv_polygon*> polygons_;
    bool is_null_;
  };

  std::map<const gcv_scene*, Known> known_;
  std::uint64_t last_family_ = 0;
};

}  // namespace gcv::fuzz
