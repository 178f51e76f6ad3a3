// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Eight threads share const polygons, outer faces and a scene, and all get the same bytes from
// them.
#include <latch>
#include <thread>

#include "pairs.hpp"
#include "questions.hpp"
#include "scenes.hpp"

namespace {

using gcv::faults::check;
using gcv::faults::made;
using gcv::faults::Owner;
using gcv::faults::Pair;
using gcv::faults::transcript;

constexpr std::size_t threads = 8;
constexpr int rounds = 2;
// New polygons each time: their first use is over at once. Fewer times under sanitizers, which take
// ten times as long.
#ifdef GCV_SANITIZED
constexpr int times = 2;
#else
constexpr int times = 6;
#endif

using Faces = std::vector<Owner<gcv_outer_face>>;

// All sums of a pair.
Faces faces_of(const Pair& pair) {
  static constexpr double point[] = {0.5, -0.25};
  Faces faces;
  for (const std::int32_t rounding : {GCV_ROUND_NEAREST, GCV_ROUND_OUTWARD}) {
    const gcv_options options = gcv::faults::options(rounding);
    faces.push_back(made<gcv_outer_face>([&](gcv_outer_face** out) {
      return gcv_minkowski_sum(pair.a.get(), pair.b.get(), &options, out);
    }));
    faces.push_back(made<gcv_outer_face>([&](gcv_outer_face** out) {
      return gcv_no_fit_polygon(pair.a.get(), pair.b.get(), point, &options, out);
    }));
    faces.push_back(made<gcv_outer_face>([&](gcv_outer_face** out) {
      return gcv_entrance_block(pair.a.get(), pair.b.get(), point, &options, out);
    }));
    const gcv_options within = gcv::faults::options(rounding, pair.tolerance);
    faces.push_back(made<gcv_outer_face>([&](gcv_outer_face** out) {
      return gcv_no_fit_polygon(pair.a.get(), pair.b.get(), point, &within, out);
    }));
  }
  return faces;
}

// What all threads work with. The polygons are new, and not those of the faces: what they keep
// from their first use is made by threads.
struct Shared {
  std::vector<Pair> pairs = gcv::faults::pairs();
  std::vector<Faces> faces;
  gcv::faults::NewScene scene;

  Shared() {
    for (const Pair& pair : gcv::faults::pairs()) {
      faces.push_back(faces_of(pair));
    }
  }
};

// All that there is to know of pair k and of the scene, from shared handles and from new ones.
std::string work(const Shared& shared, std::size_t k) {
  const Pair& pair = shared.pairs[k];
  std::string bytes = transcript(pair.a.get()) + transcript(pair.b.get());
  for (const Owner<gcv_outer_face>& face : shared.faces[k]) {
    bytes += transcript(face.get());
    bytes += transcript(made<gcv_polygon>([&](gcv_polygon** out) {
                          return gcv_outer_face_polygon(face.get(), out);
                        }).get());
  }
  for (const Owner<gcv_outer_face>& face : faces_of(pair)) {
    bytes += transcript(face.get());
  }
  bytes += transcript(made<gcv_superset>([&](gcv_superset** out) {
                        return gcv_superset_create(pair.a.get(), pair.b.get(), out);
                      }).get());
  const gcv::faults::Places places = gcv::faults::places_of(pair, 40);
  for (const gcv::faults::Question& question : gcv::faults::questions) {
    bytes += gcv::faults::answers(question, pair, places, nullptr);
  }
  for (std::size_t place = 0; place < places.count(); ++place) {
    bytes += transcript(made<gcv_contact_list>([&](gcv_contact_list** out) {
                          return gcv::faults::contacts_at(pair, places, place, out);
                        }).get());
  }
  return bytes + transcript(shared.scene);
}

// A message that no other thread gets.
void refuse(std::size_t number) {
  const std::string text = "POLYGON ((" + std::string(number, ' ') + "?";
  gcv_polygon* polygon = nullptr;
  check(gcv_polygon_create_wkt(text.data(), text.size(), &polygon) == GCV_ERR_PARSE, "a polygon?");
}

// All threads go through the pairs in the same order, to meet at the first use of each.
void run(const Shared& shared, const std::vector<std::string>& expected, std::size_t number,
         std::latch& start, Faces& left_over) {
  refuse(number);
  const std::string message = gcv_last_error_message();
  start.arrive_and_wait();
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t pair = 0; pair < shared.pairs.size(); ++pair) {
      check(work(shared, pair) == expected[pair], "other bytes in a thread");
      left_over = faces_of(shared.pairs[pair]);
    }
    check(message == gcv_last_error_message(), "the message of another thread");
  }
}

}  // namespace

int main() {
  std::vector<std::string> expected;
  std::vector<Faces> left_over(threads);
  {
    const Shared alone;
    for (std::size_t k = 0; k < alone.pairs.size(); ++k) {
      expected.push_back(work(alone, k));
    }
  }
  for (int time = 0; time < times; ++time) {
    const Shared shared;
    std::latch start(threads);
    std::vector<std::jthread> running;
    for (std::size_t number = 0; number < threads; ++number) {
      running.emplace_back(run, std::cref(shared), std::cref(expected), number, std::ref(start),
                           std::ref(left_over[number]));
    }
  }
  // The faces that the threads leave outlive the polygons.
  for (std::size_t number = 0; number < threads; ++number) {
    check(!left_over[number].empty() && !transcript(left_over[number].front().get()).empty(),
          "a thread has left no faces");
  }
}
