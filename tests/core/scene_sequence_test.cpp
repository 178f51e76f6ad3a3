// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Scenes after many random changes, and copies of them, against scenes that are made afresh with
// the same members: the answers are the same to the bit, with and without earlier lists, one by one
// and many by threads.
//   scene_sequence_test [--cases=N] [--seed=N]: sequences of each family.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "case_options.hpp"
#include "contact_agreement.hpp"
#include "contact_scenes.hpp"
#include "scene_answers.hpp"
#include "scene_texts.hpp"

namespace gcv::test {
namespace {

CaseOptions chosen{2};

using invariants::require;

// ------------------------------------------------------------------------ changes --

using Shapes = std::vector<invariants::PolygonHandle>;

// Throws invariants::Failure where a polygon is not valid.
Shapes shapes_of(const MemberScene& scene) {
  Shapes shapes;
  for (const auto& rings : scene.shapes) {
    shapes.push_back(made(rings));
  }
  return shapes;
}

// A scene, what it must consist of, and its last lists.
struct Changing {
  invariants::SceneHandle scene;
  Members members;
  EarlierLists lists;
};

class Sequence {
 public:
  Sequence(const MemberScene& description, const Shapes& shapes, Random& random)
      : description_(description), shapes_(shapes), random_(random) {
    scenes_.push_back({new_scene(), {}, {}});
    choose_questions();
  }

  // Some changes of one of the scenes, and all questions to it. Gives what is wrong, or "".
  std::string step() {
    Changing& changing = scenes_[below(scenes_.size())];
    for (std::size_t count = below(5); count > 0; --count) {
      change(changing);
    }
    if (below(8) == 0) {
      choose_questions();
    }
    const EarlierLists& earlier = scenes_[below(scenes_.size())].lists;
    std::string wrong = difference(changing.scene.get(), changing.members, shapes_, asked_, earlier,
                                   changing.lists);
    if (wrong.empty() && below(10) == 0) {
      copy(changing);
    }
    return wrong;
  }

 private:
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(uniform(random_, 0, static_cast<int>(count) - 1));
  }

  Point any_position() {
    const std::size_t members = description_.members.size();
    const std::size_t k = below(members + description_.positions.size());
    return k < members ? description_.members[k].position : description_.positions[k - members];
  }

  void choose_questions() {
    asked_ = {shapes_[description_.moving].get(),
              description_.positions,
              description_.motions,
              UINT32_MAX,
              {},
              0,
              0};
    asked_.positions.resize(6);
    if (below(2) == 0) {
      asked_.layers = static_cast<std::uint32_t>(below(8));
      asked_.ignored.assign(below(3), 1 + below(8));
    }
    asked_.slope = below(2) == 0 ? 0 : 0.125;
    const std::size_t at = below(asked_.motions.size());
    asked_.distance = below(2) == 0 ? 0 : std::abs(asked_.motions[at][below(2)]);
  }

  void change(Changing& changing) {
    std::map<Id, Member>& by_id = changing.members.by_id;
    constexpr std::size_t most = 14;
    const std::size_t kind = by_id.empty() ? 0 : below(9);
    if (kind <= 2) {
      if (by_id.size() < most) {
        add(changing, 1 + below(3));
      }
    } else if (kind <= 7) {
      change_some(changing, kind);
    } else {
      set_container(changing);
    }
  }

  void add(Changing& changing, std::size_t count) {
    std::vector<Member> members;
    std::vector<const gcv_polygon*> polygons;
    Points positions;
    for (std::size_t k = 0; k < count; ++k) {
      members.push_back({below(shapes_.size()), any_position(), UINT32_MAX});
      polygons.push_back(shapes_[members[k].shape].get());
      positions.push_back(members[k].position);
    }
    std::vector<Id> ids(count);
    require(gcv_scene_add(changing.scene.get(), polygons.data(), positions.front().data(), count,
                          ids.data()),
            "members");
    for (std::size_t k = 0; k < count; ++k) {
      EXPECT_EQ(ids[k], ++changing.members.last);
      changing.members.by_id.emplace(ids[k], members[k]);
    }
  }

  // In any order.
  std::vector<Id> some_ids(const Members& members) {
    std::vector<Id> ids;
    for (const auto& [id, member] : members.by_id) {
      ids.insert(ids.begin() + static_cast<std::ptrdiff_t>(below(ids.size() + 1)), id);
    }
    ids.resize(1 + below(std::min<std::size_t>(ids.size(), 4)));
    return ids;
  }

  void change_some(Changing& changing, std::size_t kind) {
    enum { remove = 3, layers, polygons, positions, both };
    gcv_scene* const scene = changing.scene.get();
    const std::vector<Id> ids = some_ids(changing.members);
    std::vector<std::uint32_t> new_layers;
    std::vector<const gcv_polygon*> new_polygons;
    Points new_positions;
    for (const Id id : ids) {
      Member& member = changing.members.by_id.at(id);
      if (kind == layers) {
        member.layers = static_cast<std::uint32_t>(below(8));
      }
      if (kind == polygons || kind == both) {
        member.shape = below(shapes_.size());
      }
      if (kind == positions || kind == both) {
        member.position = any_position();
      }
      new_layers.push_back(member.layers);
      new_polygons.push_back(shapes_[member.shape].get());
      new_positions.push_back(member.position);
    }
    if (kind == remove) {
      require(gcv_scene_remove(scene, ids.data(), ids.size()), "their end");
      std::erase_if(changing.members.by_id, [&](const auto& member) {
        return std::find(ids.begin(), ids.end(), member.first) != ids.end();
      });
    } else if (kind == layers) {
      require(gcv_scene_set_layers(scene, ids.data(), new_layers.data(), ids.size()), "layers");
    } else {
      require(gcv_scene_set(scene, ids.data(), kind == positions ? nullptr : new_polygons.data(),
                            kind == polygons ? nullptr : new_positions.front().data(), ids.size()),
              "a change");
    }
  }

  void set_container(Changing& changing) {
    std::optional<std::size_t>& container = changing.members.container;
    container = below(3) == 0 ? std::nullopt : std::optional(below(shapes_.size()));
    const gcv_polygon* const polygon = container ? shapes_[*container].get() : nullptr;
    require(gcv_scene_set_container(changing.scene.get(), polygon), "a container");
  }

  // The copy takes the place of another one, where there are many.
  void copy(const Changing& changing) {
    gcv_scene* out = nullptr;
    require(gcv_scene_copy(changing.scene.get(), &out), "a copy");
    Changing copied{invariants::SceneHandle(out), changing.members, {}};
    constexpr std::size_t most = 3;
    if (scenes_.size() < most) {
      scenes_.push_back(std::move(copied));
    } else {
      scenes_[below(most)] = std::move(copied);
    }
  }

  const MemberScene& description_;
  const Shapes& shapes_;
  Random& random_;
  std::vector<Changing> scenes_;  // each copied from another one
  Asked asked_;
};

// Calls check(description, shapes, random) for cases of the family whose polygons are valid.
template <class Check>
void for_each_case(const RegionFamily& family, int count, int positions, Check check) {
  Random random(chosen.seed);
  for (int k = 0; k < count;) {
    const MemberScene description = member_scene(family, random, 14, positions);
    std::optional<Shapes> shapes;
    try {
      shapes = shapes_of(description);
    } catch (const invariants::Failure&) {
      continue;
    }
    const std::string wrong = check(description, *shapes, random);
    EXPECT_EQ(wrong, "") << "case " << k << text_of(description, {});
    ++k;
  }
}

class Sequences : public ::testing::TestWithParam<RegionFamily> {};

TEST_P(Sequences, OfChangesGiveWhatIsMadeAfresh) {
  for_each_case(GetParam(), chosen.cases, 8,
                [&](const MemberScene& description, const Shapes& shapes, Random& random) {
                  Sequence sequence(description, shapes, random);
                  for (int step = 0; step < 25; ++step) {
                    const std::string wrong = sequence.step();
                    if (!wrong.empty()) {
                      return wrong + " after step " + std::to_string(step);
                    }
                  }
                  return std::string();
                });
}

template <class Result, class One, class All>
std::string many_difference(const char* name, std::size_t count, One one, All all) {
  std::vector<Result> expected(count);
  std::vector<Result> got(count);
  gcv_status status = GCV_OK;
  for (std::size_t k = 0; k < count && status == GCV_OK; ++k) {
    status = one(k, &expected[k]);
  }
  if (all(got.data()) != status) {
    return std::string(name) + ": another status";
  }
  const bool are_same =
      status != GCV_OK || std::memcmp(expected.data(), got.data(), count * sizeof(Result)) == 0;
  return are_same ? "" : std::string(name) + ": other answers for many";
}

std::string threads_difference(const MemberScene& description, const Shapes& shapes) {
  gcv_options options = GCV_OPTIONS_INIT;
  options.threads = 3;
  const invariants::SceneHandle scene = new_scene();
  for (const MemberScene::Member& member : description.members) {
    const gcv_polygon* const polygon = shapes[member.shape].get();
    Id id = 0;
    require(gcv_scene_add(scene.get(), &polygon, member.position.data(), 1, &id), "a member");
  }
  const gcv_polygon* const moving = shapes[description.moving].get();
  const std::size_t count = description.positions.size();
  const auto position = [&](std::size_t k) { return description.positions[k].data(); };
  const auto motion = [&](std::size_t k) { return description.motions[k].data(); };
  std::string wrong = many_difference<std::int8_t>(
      "gcv_scene_relation", count,
      [&](std::size_t k, std::int8_t* out) {
        return gcv_scene_relation(scene.get(), moving, position(k), 1, nullptr, nullptr, out);
      },
      [&](std::int8_t* out) {
        return gcv_scene_relation(scene.get(), moving, position(0), count, nullptr, &options, out);
      });
  wrong += many_difference<gcv_separation>(
      "gcv_scene_distance", count,
      [&](std::size_t k, gcv_separation* out) {
        return gcv_scene_distance(scene.get(), moving, position(k), 1, nullptr, nullptr, out);
      },
      [&](gcv_separation* out) {
        return gcv_scene_distance(scene.get(), moving, position(0), count, nullptr, &options, out);
      });
  wrong += many_difference<gcv_impact>(
      "gcv_scene_cast", count,
      [&](std::size_t k, gcv_impact* out) {
        return gcv_scene_cast(scene.get(), moving, position(k), motion(k), 1, nullptr, nullptr,
                              out);
      },
      [&](gcv_impact* out) {
        return gcv_scene_cast(scene.get(), moving, position(0), motion(0), count, nullptr, &options,
                              out);
      });
  for (const std::int32_t threads : {1, 3}) {
    options.threads = threads;
    std::string bytes;
    const auto pairs = list_of<gcv_pair_list>(bytes, [&](gcv_pair_list** out) {
      return gcv_scene_pairs(scene.get(), nullptr, 1, nullptr, &options, out);
    });
    const auto alone = list_of<gcv_pair_list>(bytes, [&](gcv_pair_list** out) {
      return gcv_scene_pairs(scene.get(), nullptr, 1, nullptr, nullptr, out);
    });
    wrong += bytes_of(pairs.get(), {}) == bytes_of(alone.get(), {}) ? "" : "other pairs by threads";
  }
  return wrong;
}

TEST_P(Sequences, GiveTheSameAnswersForOneAndForManyByThreads) {
  for_each_case(GetParam(), 2, 400,
                [&](const MemberScene& description, const Shapes& shapes, Random&) {
                  return threads_difference(description, shapes);
                });
}

INSTANTIATE_TEST_SUITE_P(Families, Sequences,
                         ::testing::ValuesIn(contact_families().begin(), contact_families().end()),
                         [](const auto& family) { return name_of_family(family); });

}  // namespace
}  // namespace gcv::test

int main(int argc, char** argv) { return gcv::test::run_with(gcv::test::chosen, argc, argv); }
