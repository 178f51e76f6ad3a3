// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Bytes -> some polygons, and changes of scenes of them, copies, and questions. Scenes must answer
// as those that are made afresh with the same members, to the bit; and as their members do one by
// one, where positions have doubles as differences. Free regions, best positions and ways out must
// agree with relations. What is refused changes nothing.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "free_checks.hpp"
#include "question_polygons.hpp"
#include "scene_members.hpp"

namespace {

using gcv::fuzz::check;
using gcv::fuzz::Input;
using gcv::fuzz::is_finite;
using gcv::fuzz::MembersAlone;
using gcv::fuzz::PlacedMember;
using gcv::fuzz::Placement;
using gcv::fuzz::Point;
using gcv::fuzz::Rings;
using gcv::fuzz::succeeds;
using gcv::test::Asked;
using gcv::test::EarlierLists;
using gcv::test::Id;
using gcv::test::Member;
using gcv::test::Members;
using gcv::test::Points;
using gcv::test::text_of;

using Shapes = std::vector<gcv::invariants::PolygonHandle>;

struct Changing {
  gcv::invariants::SceneHandle scene;
  Members members;
  EarlierLists lists;
};

class Calls {
 public:
  explicit Calls(Input& input) : input_(input) {
    for (std::size_t count = 1 + input.below(4); count > 0; --count) {
      const Rings rings = gcv::fuzz::read_polygon(input, placement_);
      if (gcv::fuzz::Polygon polygon = gcv::fuzz::make(rings)) {
        shapes_.emplace_back(polygon.release());
        rings_.push_back(rings);
        text_ += "\nshape:" + gcv::fuzz::text(rings);
      }
    }
    scenes_.push_back({gcv::test::new_scene(), {}, {}});
  }

  void run() {
    constexpr std::size_t most = 48;
    for (std::size_t k = 0; k < most && !input_.empty() && !shapes_.empty(); ++k) {
      call();
    }
  }

 private:
  enum {
    add,
    also_add,
    move,
    reshape,
    change_both,
    set_layers,
    remove,
    container,
    copy,
    drop,
    bad_id,
    ask,
    also_ask,
    calls
  };

  void call() {
    Changing& changing = scenes_[input_.below(scenes_.size())];
    const std::size_t kind = input_.below(calls);
    switch (kind) {
      case add:
      case also_add:
        add_members(changing);
        break;
      case container:
        set_container(changing);
        break;
      case copy:
        copy_scene(changing);
        break;
      case drop:
        drop_scene();
        break;
      case bad_id:
        refuse(changing);
        break;
      case ask:
      case also_ask:
        ask_all(changing);
        break;
      default:
        change_some(changing, kind);
    }
  }

  std::size_t any_shape() { return input_.below(shapes_.size()); }

  // Anywhere; on the grid, near 0 or far out; or in contact with a member, but for roundings.
  Point any_position(const Members& members, std::size_t shape) {
    enum { on_grid, also_on_grid, far_out, contact, also_contact, anywhere };
    const std::size_t kind = input_.below(6);
    if (kind == anywhere) {
      return input_.take<Point>();
    }
    if ((kind == contact || kind == also_contact) && !members.by_id.empty()) {
      auto there = members.by_id.begin();
      std::advance(there, static_cast<std::ptrdiff_t>(input_.below(members.by_id.size())));
      const Member& member = there->second;
      const Point way =
          gcv::fuzz::read_vector(input_, rings_[member.shape], rings_[shape], placement_.exponent);
      return {member.position[0] + way[0], member.position[1] + way[1]};
    }
    Point position{};
    for (double& x : position) {
      x = std::ldexp(input_.take<std::int8_t>(), placement_.exponent - 2);
      if (kind == far_out) {
        x += std::ldexp(1.0 + static_cast<double>(input_.below(3)), placement_.exponent + 54);
      }
    }
    return position;
  }

  void add_members(Changing& changing) {
    constexpr std::size_t most = 10;
    const std::size_t count =
        std::min(1 + input_.below(3), most - std::min(most, changing.members.by_id.size()));
    std::vector<const gcv_polygon*> polygons;
    std::vector<Member> members;
    Points positions;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t shape = any_shape();
      members.push_back({shape, any_position(changing.members, shape), UINT32_MAX});
      polygons.push_back(shapes_[shape].get());
      positions.push_back(members.back().position);
    }
    positions.emplace_back();
    std::vector<Id> ids(count);
    const gcv_status status = gcv_scene_add(changing.scene.get(), polygons.data(),
                                            positions.front().data(), count, ids.data());
    positions.pop_back();
    if (!judge("gcv_scene_add", status, positions)) {
      return;
    }
    for (std::size_t k = 0; k < count; ++k) {
      check(ids[k] == ++changing.members.last, "not the next id" + text_);
      changing.members.by_id.emplace(ids[k], members[k]);
    }
  }

  // Did a call with these positions succeed? It must, if they are finite.
  bool judge(const char* name, gcv_status status, const Points& positions) {
    const bool well = std::all_of(positions.begin(), positions.end(), is_finite);
    check(status == (well ? GCV_OK : GCV_ERR_NOT_FINITE),
          std::string(name) + " gave " + gcv_status_name(status) + text_);
    return well;
  }

  std::vector<Id> some_ids(const Members& members) {
    std::vector<Id> ids;
    for (const auto& [id, member] : members.by_id) {
      if (input_.below(2) == 0) {
        ids.insert(ids.begin() + static_cast<std::ptrdiff_t>(input_.below(ids.size() + 1)), id);
      }
    }
    return ids;
  }

  void change_some(Changing& changing, std::size_t kind) {
    const std::vector<Id> ids = some_ids(changing.members);
    if (ids.empty()) {
      return;
    }
    Members after = changing.members;
    std::vector<std::uint32_t> layers;
    std::vector<const gcv_polygon*> polygons;
    Points positions;
    for (const Id id : ids) {
      Member& member = after.by_id.at(id);
      if (kind == reshape || kind == change_both) {
        member.shape = any_shape();
      }
      if (kind == move || kind == change_both) {
        member.position = any_position(changing.members, member.shape);
      }
      if (kind == set_layers) {
        member.layers = static_cast<std::uint32_t>(input_.below(8));
      }
      layers.push_back(member.layers);
      polygons.push_back(shapes_[member.shape].get());
      positions.push_back(member.position);
    }
    gcv_scene* const scene = changing.scene.get();
    if (kind == remove) {
      succeeds("gcv_scene_remove", gcv_scene_remove(scene, ids.data(), ids.size()));
      std::erase_if(after.by_id, [&](const auto& member) {
        return std::find(ids.begin(), ids.end(), member.first) != ids.end();
      });
    } else if (kind == set_layers) {
      succeeds("gcv_scene_set_layers",
               gcv_scene_set_layers(scene, ids.data(), layers.data(), ids.size()));
    } else {
      const gcv_status status =
          gcv_scene_set(scene, ids.data(), kind == move ? nullptr : polygons.data(),
                        kind == reshape ? nullptr : positions.front().data(), ids.size());
      if (!judge("gcv_scene_set", status, kind == reshape ? Points{} : positions)) {
        return;
      }
    }
    changing.members = after;
  }

  void set_container(Changing& changing) {
    const std::size_t shape = input_.below(shapes_.size() + 1);
    const bool is_none = shape == shapes_.size();
    succeeds(
        "gcv_scene_set_container",
        gcv_scene_set_container(changing.scene.get(), is_none ? nullptr : shapes_[shape].get()));
    changing.members.container = is_none ? std::nullopt : std::optional(shape);
  }

  void copy_scene(const Changing& changing) {
    constexpr std::size_t most = 3;
    gcv_scene* out = nullptr;
    succeeds("gcv_scene_copy", gcv_scene_copy(changing.scene.get(), &out));
    Changing copied{gcv::invariants::SceneHandle(out), changing.members, {}};
    if (scenes_.size() < most) {
      scenes_.push_back(std::move(copied));
    }
  }

  void drop_scene() {
    if (scenes_.size() > 1) {
      scenes_.erase(scenes_.begin() + static_cast<std::ptrdiff_t>(input_.below(scenes_.size())));
    }
  }

  // An id that is no member's, or one twice, after some that are.
  void refuse(const Changing& changing) {
    std::vector<Id> ids = some_ids(changing.members);
    const Id bad = input_.one_of<Id>({0, 1, changing.members.last + 1, UINT64_MAX});
    ids.push_back(ids.empty() || input_.below(2) == 0 ? bad : ids.front());
    const std::vector<std::uint32_t> layers(ids.size());
    const Points positions(ids.size());
    gcv_scene* const scene = changing.scene.get();
    const std::size_t count = ids.size();
    const gcv_status statuses[] = {
        gcv_scene_remove(scene, ids.data(), count),
        gcv_scene_set(scene, ids.data(), nullptr, positions.front().data(), count),
        gcv_scene_set_layers(scene, ids.data(), layers.data(), count)};
    for (const gcv_status status : statuses) {
      check(status == GCV_ERR_INVALID_ARGUMENT, "an id that is not refused" + text_);
    }
  }

  // ---------------------------------------------------------------------- questions --

  void ask_all(Changing& changing) {
    const std::size_t shape = any_shape();
    Asked asked{shapes_[shape].get(), {}, {}, UINT32_MAX, {}, 0, 0};
    const Point position = any_position(changing.members, shape);
    const Point motion = any_position({}, shape);
    if (!is_finite(position) || !is_finite(motion)) {
      return;
    }
    asked.positions = {position};
    asked.motions = {motion};
    if (input_.below(2) == 0) {
      asked.layers = static_cast<std::uint32_t>(input_.below(8));
      asked.ignored.assign(input_.below(3), 1 + input_.below(8));
    }
    asked.slope = input_.one_of({0.0, 0x1p-52, 0.125, 3.0});
    asked.distance = input_.below(2) == 0 ? 0
                                          : std::min(std::hypot(motion[0], motion[1]),
                                                     std::numeric_limits<double>::max());
    const EarlierLists& earlier = scenes_[input_.below(scenes_.size())].lists;
    const std::string wrong =
        difference(changing.scene.get(), changing.members, shapes_, asked, earlier, changing.lists);
    check(wrong.empty(), wrong + where(changing, asked));
    check_members(changing, asked);
    check_free(changing, asked);
  }

  // In a window between the position and the end of the motion, and in the container.
  void check_free(const Changing& changing, const Asked& asked) const {
    const gcv_query query = query_of(asked);
    const bool is_bounded =
        changing.members.container && asked.layers != 0 && !is_ignored(asked, 1);
    const gcv::fuzz::FreeQuestions questions{changing.scene.get(), asked.moving, &query, is_bounded,
                                             where(changing, asked)};
    const Point& position = asked.positions.front();
    const Point& motion = asked.motions.front();
    const Point end{position[0] + motion[0], position[1] + motion[1]};
    const auto [x0, x1] = std::minmax(position[0], end[0]);
    const auto [y0, y1] = std::minmax(position[1], end[1]);
    const double window[] = {x0, y0, x1, y1};
    if (is_finite(end) && x0 < x1 && y0 < y1) {
      questions.check_region(window, {position, end});
    }
    if (is_bounded) {
      questions.check_region(nullptr, {position});
    }
    questions.check_best(motion);
    questions.check_way_out(position);
  }

  static bool is_ignored(const Asked& asked, Id id) {
    return std::find(asked.ignored.begin(), asked.ignored.end(), id) != asked.ignored.end();
  }

  static gcv_query query_of(const Asked& asked) {
    gcv_query query = GCV_QUERY_INIT;
    query.layers = asked.layers;
    query.ignore = asked.ignored.data();
    query.ignore_count = asked.ignored.size();
    return query;
  }

  void check_members(const Changing& changing, const Asked& asked) const {
    if (changing.members.container && asked.layers != 0 && !is_ignored(asked, 1)) {
      return;
    }
    std::vector<PlacedMember> members;
    for (const auto& [id, member] : changing.members.by_id) {
      if ((member.layers & asked.layers) != 0 && !is_ignored(asked, id)) {
        members.push_back({id, shapes_[member.shape].get(), member.position});
      }
    }
    const auto alone = MembersAlone::at(members, asked.moving, asked.positions.front());
    if (alone) {
      check_answers(changing, asked, *alone);
    }
  }

  void check_answers(const Changing& changing, const Asked& asked,
                     const MembersAlone& alone) const {
    const gcv_query query = query_of(asked);
    const gcv_scene* const scene = changing.scene.get();
    const double* const position = asked.positions.front().data();
    const std::string text = where(changing, asked);
    std::int8_t relation = 77;
    succeeds("gcv_scene_relation",
             gcv_scene_relation(scene, asked.moving, position, 1, &query, nullptr, &relation));
    check(relation == alone.relation(), "another relation" + text);
    gcv_separation separation{};
    if (succeeds("gcv_scene_distance",
                 gcv_scene_distance(scene, asked.moving, position, 1, &query, nullptr, &separation),
                 {GCV_ERR_RANGE})) {
      check(separation.relation == relation, "another relation with a distance" + text);
      alone.check_distance(separation, text);
    }
    gcv_impact impact{};
    const Point& motion = asked.motions.front();
    if (succeeds("gcv_scene_cast",
                 gcv_scene_cast(scene, asked.moving, position, motion.data(), 1, &query, nullptr,
                                &impact),
                 {GCV_ERR_RANGE})) {
      alone.check_cast(impact, motion, text);
    }
  }

  [[nodiscard]] std::string where(const Changing& changing, const Asked& asked) const {
    std::string text = text_;
    for (const auto& [id, member] : changing.members.by_id) {
      text += "\nmember " + std::to_string(id) + ": shape " + std::to_string(member.shape) +
              " at " + text_of(member.position) + ", layers " + std::to_string(member.layers);
    }
    if (changing.members.container) {
      text += "\ncontainer: shape " + std::to_string(*changing.members.container);
    }
    for (std::size_t k = 0; k < shapes_.size(); ++k) {
      text += shapes_[k].get() == asked.moving ? "\nmoving: shape " + std::to_string(k) : "";
    }
    text += " at " + text_of(asked.positions.front()) + ", motion " +
            text_of(asked.motions.front()) + ", distance " + text_of(asked.distance) + ", layers " +
            std::to_string(asked.layers) + ", without";
    for (const Id id : asked.ignored) {
      text += ' ';
      text += std::to_string(id);
    }
    return text;
  }

  Input& input_;
  Placement placement_;
  Shapes shapes_;
  std::vector<Rings> rings_;  // of the shapes
  std::string text_;          // of the shapes
  std::vector<Changing> scenes_;
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input(data, size);
  Calls(input).run();
  return 0;
}
