// SPDX-License-Identifier: LGPL-3.0-or-later
//
// For every function of scenes, and for every n: the n-th allocation fails, alone or with all after
// it. The call says so and writes nothing; a change leaves the scene as it was; and the same call
// does the same as ever once there is memory again. No threads are given, so that all allocations
// come in the same order.
#include <array>

#include "attempts.hpp"
#include "refused_threads.hpp"
#include "scenes.hpp"

namespace {

using gcv::faults::Attempt;
using gcv::faults::check;
using gcv::faults::Faults;
using gcv::faults::free_region_of;
using gcv::faults::made;
using gcv::faults::NewScene;
using gcv::faults::Outcome;
using gcv::faults::Owner;
using gcv::faults::Places;
using gcv::faults::run;
using gcv::faults::SceneQuestion;
using gcv::faults::starve;
using gcv::faults::Threads;
using gcv::faults::transcript;

// ------------------------------------------------------------------------- changes --

using Ids = std::vector<std::uint64_t>;

constexpr std::uint64_t untouched_id = 77;

constexpr auto nothing = [](const NewScene&) {};

// change(scene, ids) may write up to four ids. Before it, prepare(scene) has all the memory.
template <class Change, class Prepare>
Attempt changed(const char* name, Change change, Prepare prepare) {
  const NewScene other;
  prepare(other);
  const std::string before = transcript(other);
  Ids ids(4, untouched_id);
  gcv::faults::require(change(other, ids.data()));
  const std::string after = transcript(other);
  check(before != after, name, " changes nothing");
  return [=](const Faults& faults) {
    const NewScene scene;
    prepare(scene);
    Ids out(4, untouched_id);
    const gcv_status status = run(faults, [&] { return change(scene, out.data()); });
    const bool untouched = out == Ids(4, untouched_id);
    if (status != GCV_OK) {
      check(transcript(scene) == before, name, " has changed the scene, and failed");
      check(untouched, name, " gave ids, and failed");
      gcv::faults::require(change(scene, out.data()));
    }
    check(transcript(scene) == after, name, " has another effect");
    check(out == ids, name, " gave other ids");
    return Outcome{status, status != GCV_OK && untouched, "changed"};
  };
}

// Those that may take memory, or not.
template <class Change>
void starve_frugal(const char* name, Change change) {
  const Attempt attempt = changed(name, change, nothing);
  const Outcome expected = attempt({});
  const long allocations = starve(name, attempt, 1, expected, Threads::one);
  starve(std::string(name) + ", and all later ones", attempt, gcv::faults::never, expected,
         Threads::one);
  std::printf("%s: %ld allocations\n", name, allocations);
}

template <class Change, class Prepare = decltype(nothing)>
void starve_change(const char* name, Change change, Prepare prepare = nothing) {
  starve(name, changed(name, change, prepare));
}

void starve_changes() {
  static constexpr double positions[] = {1, 1, 2, 0.1, -3, 4, 1e16, 1};
  static constexpr std::uint64_t ids[] = {7, 3, 2, 8};
  static constexpr std::uint32_t layers[] = {4, 0, 1, 6};
  const auto polygons = [](const NewScene& scene) {
    const gcv_polygon* const first = scene.polygons[3].get();
    const gcv_polygon* const second = scene.polygons[1].get();
    return std::array{first, second, first, second};
  };
  starve_change("gcv_scene_add", [=](const NewScene& s, std::uint64_t* out) {
    return gcv_scene_add(s.scene.get(), polygons(s).data(), positions, 4, out);
  });
  starve_frugal("gcv_scene_set of positions", [=](const NewScene& s, std::uint64_t*) {
    return gcv_scene_set(s.scene.get(), ids, nullptr, positions, 4);
  });
  starve_frugal("gcv_scene_set of polygons", [=](const NewScene& s, std::uint64_t*) {
    return gcv_scene_set(s.scene.get(), ids, polygons(s).data(), nullptr, 4);
  });
  starve_frugal("gcv_scene_set of both", [=](const NewScene& s, std::uint64_t*) {
    return gcv_scene_set(s.scene.get(), ids, polygons(s).data(), positions, 4);
  });
  starve_frugal("gcv_scene_set_layers", [=](const NewScene& s, std::uint64_t*) {
    return gcv_scene_set_layers(s.scene.get(), ids, layers, 4);
  });
  starve_frugal("gcv_scene_remove", [=](const NewScene& s, std::uint64_t*) {
    return gcv_scene_remove(s.scene.get(), ids, 4);
  });
  starve_frugal("gcv_scene_set_container", [=](const NewScene& s, std::uint64_t*) {
    return gcv_scene_set_container(s.scene.get(), s.polygons[3].get());
  });
  starve_frugal("gcv_scene_set_container of none", [=](const NewScene& s, std::uint64_t*) {
    return gcv_scene_set_container(s.scene.get(), nullptr);
  });
}

gcv_status add_one(const NewScene& s, std::size_t k, std::uint64_t* out) {
  const gcv_polygon* const polygon = s.polygons[k % 3].get();
  const double position[] = {static_cast<double>(k % 7), static_cast<double>(k % 5)};
  return gcv_scene_add(s.scene.get(), &polygon, position, 1, out);
}

// One more member than so many: whatever grows with their number.
void starve_growth() {
  constexpr std::size_t most = 40;
  for (std::size_t count = 1; count < most; count += count / 3 + 1) {
    starve_change(
        "gcv_scene_add of one more",
        [=](const NewScene& s, std::uint64_t* out) { return add_one(s, count, out); },
        [=](const NewScene& s) {
          for (std::size_t k = 0; k < count; ++k) {
            std::uint64_t id = 0;
            gcv::faults::require(add_one(s, k, &id));
          }
        });
  }
}

void starve_handles() {
  starve("gcv_scene_create", [](const Faults& faults) {
    gcv_scene* out = nullptr;
    const gcv_status status = run(faults, [&] { return gcv_scene_create(&out); });
    const Owner<gcv_scene> owner(out);
    return Outcome{status, out == nullptr, "a scene"};
  });
  const std::string expected = transcript(NewScene());
  starve("gcv_scene_copy", [=](const Faults& faults) {
    NewScene scene;
    gcv_scene* out = nullptr;
    const gcv_status status = run(faults, [&] { return gcv_scene_copy(scene.scene.get(), &out); });
    check(transcript(scene) == expected, "gcv_scene_copy", " changes what it copies");
    scene.scene.reset(status == GCV_OK ? out : nullptr);
    return Outcome{status, out == nullptr, status == GCV_OK ? transcript(scene) : ""};
  });
  const NewScene scene;
  starve("gcv_scene_polygon", gcv::faults::handle<gcv_polygon>([&](gcv_polygon** out) {
           return gcv_scene_polygon(scene.scene.get(), 3, out);
         }));
}

// ----------------------------------------------------------------------- questions --

// The scene is new: the call prepares its polygons. Once it has failed, the same ones must do.
Attempt answers(const SceneQuestion& question, const Places& places, const gcv_query& query,
                Threads threads = Threads::one) {
  gcv_options options = GCV_OPTIONS_INIT;
  options.threads = threads == Threads::many ? 3 : 1;
  const std::string expected = gcv::faults::answers(question, NewScene(), places, &query, nullptr);
  return [=](const Faults& faults) {
    const NewScene scene;
    const std::string untouched(places.count() * question.answer_size, '?');
    std::string out = untouched;
    const gcv_status status =
        run(faults, [&] { return question.ask(scene, places, &query, &options, out.data()); });
    check(status == GCV_OK ||
              gcv::faults::answers(question, scene, places, &query, nullptr) == expected,
          question.name, " answers otherwise once it has failed");
    return Outcome{status, out == untouched, out};
  };
}

// With many positions threads are asked for. Then the questions are about no member: one more
// allocation at each position would make too many trials.
void starve_questions() {
  const Places few = gcv::faults::scene_places(6);
  const Places many = gcv::faults::scene_places(140);
  const gcv_query all = GCV_QUERY_INIT;
  gcv_query none = GCV_QUERY_INIT;
  none.layers = 0;
  for (const SceneQuestion& question : gcv::faults::scene_questions) {
    starve(question.name, answers(question, few, all));
    gcv::faults::threads_refused = 0;
    starve(std::string(question.name) + " on threads", answers(question, many, none, Threads::many),
           Threads::many);
    check(gcv::faults::threads_refused > 0, question.name, " asks for no threads");
  }
  // Where the polygon overlaps a member, the container, and both.
  const Places overlapping{{{0.25, 0.5}, {19.5, 4}, {-10, -20}}, {{0, 0}, {0, 0}, {0, 0}}};
  starve("gcv_scene_penetration of overlaps",
         answers(gcv::faults::scene_questions[3], overlapping, all));
}

// Of a new scene, and of a new polygon.
void starve_free_regions() {
  gcv_query query = GCV_QUERY_INIT;
  for (const std::uint32_t layers : {UINT32_MAX, 0U}) {
    query.layers = layers;
    const std::string expected = transcript(made<gcv_region>([&](gcv_region** out) {
                                              return free_region_of(NewScene(), &query, out);
                                            }).get());
    starve("gcv_scene_free_region", [=](const Faults& faults) {
      const NewScene scene;
      const auto of_scene = [&](gcv_region** out) { return free_region_of(scene, &query, out); };
      const Outcome outcome = gcv::faults::handle<gcv_region>(of_scene)(faults);
      check(outcome.status == GCV_OK || transcript(made<gcv_region>(of_scene).get()) == expected,
            "gcv_scene_free_region", " gives another region once it has failed");
      return outcome;
    });
  }
}

void starve_best() {
  starve("gcv_scene_best", [](const Faults& faults) {
    const NewScene scene;
    const gcv::faults::Best untouched{{77, 78}, 79};
    gcv::faults::Best best = untouched;
    const gcv_status status =
        run(faults, [&] { return gcv::faults::best_in(scene, nullptr, &best); });
    const auto bytes = [](const gcv::faults::Best& b) {
      std::string text;
      gcv::faults::append(text, b.position);
      gcv::faults::append(text, b.found);
      return text;
    };
    return Outcome{status, bytes(best) == bytes(untouched), bytes(best)};
  });
}

// call(scene, out) gives a list.
template <class List, class Call>
void starve_list(const char* name, Call call, Threads threads = Threads::one) {
  const std::string expected =
      transcript(made<List>([&](List** out) { return call(NewScene(), out); }).get());
  const auto attempt = [=](const Faults& faults) {
    const NewScene scene;
    const auto of_scene = [&](List** out) { return call(scene, out); };
    const Outcome outcome = gcv::faults::handle<List>(of_scene)(faults);
    check(outcome.status == GCV_OK || transcript(made<List>(of_scene).get()) == expected, name,
          " gives another list once it has failed");
    return outcome;
  };
  starve(name, attempt, threads);
}

// With an earlier list, after a change.
template <class List, class Call>
void starve_list_again(const char* name, Call call) {
  const auto moved = [](const NewScene& scene) {
    static constexpr double position[] = {1, 0};
    const std::uint64_t id = gcv::faults::first_id + 1;
    gcv::faults::require(gcv_scene_set(scene.scene.get(), &id, nullptr, position, 1));
  };
  starve(name, [=](const Faults& faults) {
    const NewScene scene;
    const Owner<List> before =
        made<List>([&](List** out) { return call(scene, nullptr, nullptr, out); });
    const std::string text_before = transcript(before.get());
    moved(scene);
    const Outcome outcome = gcv::faults::handle<List>(
        [&](List** out) { return call(scene, before.get(), nullptr, out); })(faults);
    check(transcript(before.get()) == text_before, name, " changes the earlier list");
    return outcome;
  });
}

void starve_lists() {
  gcv_options options = GCV_OPTIONS_INIT;
  options.threads = 3;
  starve_list<gcv_pair_list>("gcv_scene_near", [](const NewScene& s, gcv_pair_list** out) {
    return gcv::faults::near(s, nullptr, out);
  });
  starve_list<gcv_pair_list>("gcv_scene_pairs", [](const NewScene& s, gcv_pair_list** out) {
    return gcv::faults::pairs_of(s, nullptr, nullptr, out);
  });
  starve_list<gcv_contact_list>("gcv_scene_contacts",
                                [](const NewScene& s, gcv_contact_list** out) {
                                  return gcv::faults::contacts_of(s, nullptr, nullptr, out);
                                });
  starve_list<gcv_pair_list>(
      "gcv_scene_pairs on threads",
      [=](const NewScene& s, gcv_pair_list** out) {
        return gcv::faults::pairs_of(s, nullptr, &options, out);
      },
      Threads::many);
  starve_list<gcv_contact_list>(
      "gcv_scene_contacts on threads",
      [=](const NewScene& s, gcv_contact_list** out) {
        return gcv::faults::contacts_of(s, nullptr, &options, out);
      },
      Threads::many);
  starve_list_again<gcv_pair_list>("gcv_scene_pairs again", gcv::faults::pairs_of);
  starve_list_again<gcv_contact_list>("gcv_scene_contacts again", gcv::faults::contacts_of);
}

}  // namespace

int main() {
  starve_handles();
  starve_changes();
  starve_growth();
  starve_questions();
  starve_free_regions();
  starve_best();
  starve_lists();
}
