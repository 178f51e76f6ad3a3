// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The system gives fewer threads than the options ask for, or none. The answers are the same.
#include "refused_threads.hpp"

#include "questions.hpp"
#include "scenes.hpp"

namespace {

using gcv::faults::check;
using gcv::faults::made;
using gcv::faults::transcript;

// ask(options) gives the answers, for which there are four threads to do something.
template <class Ask>
void ask_with_few_threads(const char* name, Ask ask) {
  const std::string expected = ask(nullptr);
  gcv_options options = GCV_OPTIONS_INIT;
  options.threads = 4;
  for (const long given : {0, 1, 2, 3}) {
    gcv::faults::threads_left = given;
    gcv::faults::threads_refused = 0;
    check(ask(&options) == expected, name, " answers otherwise on fewer threads");
    check(gcv::faults::threads_left == 0, name, " does not take the threads that it gets");
    check(gcv::faults::threads_refused == (given < 3 ? 1 : 0), name,
          " was refused no thread, or asked again");
  }
}

constexpr std::size_t many = 1000;  // enough for four threads

void ask_about(const gcv::faults::Pair& pair) {
  const gcv::faults::Places places = gcv::faults::places_of(pair, many);
  for (const gcv::faults::Question& question : gcv::faults::questions) {
    ask_with_few_threads(question.name, [&](const gcv_options* options) {
      return gcv::faults::answers(question, pair, places, options);
    });
  }
}

// Members in a row, each of which touches the next one.
void add_many(const gcv::faults::NewScene& scene) {
  const gcv::faults::Owner<gcv_polygon> square =
      gcv::faults::read("POLYGON ((0 0, 2 0, 2 2, 0 2))");
  const gcv_polygon* const polygon = square.get();
  for (std::size_t k = 0; k < many; ++k) {
    const double position[] = {2 * static_cast<double>(k), 100};
    std::uint64_t id = 0;
    gcv::faults::require(gcv_scene_add(scene.scene.get(), &polygon, position, 1, &id));
  }
}

void ask_about_scene() {
  const gcv::faults::NewScene scene;
  add_many(scene);
  const gcv::faults::Places places = gcv::faults::scene_places(many);
  for (const gcv::faults::SceneQuestion& question : gcv::faults::scene_questions) {
    ask_with_few_threads(question.name, [&](const gcv_options* options) {
      return gcv::faults::answers(question, scene, places, nullptr, options);
    });
  }
  ask_with_few_threads("gcv_scene_pairs", [&](const gcv_options* options) {
    return transcript(made<gcv_pair_list>([&](gcv_pair_list** out) {
                        return gcv::faults::pairs_of(scene, nullptr, options, out);
                      }).get());
  });
  ask_with_few_threads("gcv_scene_contacts", [&](const gcv_options* options) {
    return transcript(made<gcv_contact_list>([&](gcv_contact_list** out) {
                        return gcv::faults::contacts_of(scene, nullptr, options, out);
                      }).get());
  });
}

}  // namespace

int main() {
  for (const gcv::faults::Pair& pair : gcv::faults::pairs()) {
    ask_about(pair);
  }
  ask_about_scene();
}
