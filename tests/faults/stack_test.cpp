// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A thread with a stack of 256 KB is enough for every function: on pairs that take every way
// through the library, numbers of all magnitudes among them, and on large polygons and scenes,
// whose size no recursion may follow.
#include <pthread.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "scenes.hpp"

namespace {

using gcv::faults::check;
using gcv::faults::made;
using gcv::faults::Owner;
using gcv::faults::Pair;
using gcv::faults::Places;
using gcv::faults::require;
using gcv::faults::transcript;
using gcv::faults::Vertex;

constexpr std::size_t stack_size = std::size_t{256} << 10;
constexpr unsigned char untouched = 0xa5;
constexpr double point[] = {0.5, -0.25};

using Work = std::function<void()>;

void* do_work(void* work) {
  (*static_cast<Work*>(work))();
  return nullptr;
}

// Runs the work on a thread with the small stack, and tells how much of it was used. The stack is
// the upper half of a block: what lies below must stay as it is.
void run(const char* name, Work work) {
  alignas(4096) static unsigned char block[2 * stack_size];
  std::fill(std::begin(block), std::end(block), untouched);
  unsigned char* const stack = block + stack_size;
  pthread_attr_t attributes;
  pthread_t thread;
  check(pthread_attr_init(&attributes) == 0 &&
            pthread_attr_setstack(&attributes, stack, stack_size) == 0 &&
            pthread_create(&thread, &attributes, do_work, &work) == 0 &&
            pthread_join(thread, nullptr) == 0 && pthread_attr_destroy(&attributes) == 0,
        name, ": no thread");
  const auto used = std::find_if(std::begin(block), std::end(block),
                                 [](unsigned char byte) { return byte != untouched; });
  check(used >= stack, name, " takes more than the stack");
  std::printf("%s: %td KB\n", name, (std::end(block) - used) >> 10);
}

// ------------------------------------------------------------------------ small pairs --

void sum_all_ways(const Pair& pair) {
  const gcv_polygon* const a = pair.a.get();
  const gcv_polygon* const b = pair.b.get();
  for (const std::int32_t rounding : {GCV_ROUND_NEAREST, GCV_ROUND_OUTWARD}) {
    for (const double tolerance : {0.0, pair.tolerance}) {
      const gcv_options options = gcv::faults::options(rounding, tolerance);
      transcript(made<gcv_outer_face>([&](gcv_outer_face** out) {
                   return gcv_no_fit_polygon(a, b, point, &options, out);
                 }).get());
      transcript(made<gcv_region>([&](gcv_region** out) {
                   return gcv_no_fit_region(a, b, point, &options, out);
                 }).get());
    }
    const gcv_options exact = gcv::faults::options(rounding);
    transcript(made<gcv_region>([&](gcv_region** out) {
                 return gcv_inner_fit_region(a, b, point, &exact, out);
               }).get());
    made<gcv_polygon>([&](gcv_polygon** out) {
      double bound = 0;
      return gcv_polygon_simplified(a, pair.tolerance, rounding, out, &bound);
    });
  }
  made<gcv_superset>([&](gcv_superset** out) { return gcv_superset_create(a, b, out); });
}

void ask_all(const Pair& pair, std::size_t count) {
  const Places places = gcv::faults::places_of(pair, count);
  for (const gcv::faults::Question& question : gcv::faults::questions) {
    gcv::faults::answers(question, pair, places, nullptr);
  }
  for (std::size_t k = 0; k < count; ++k) {
    made<gcv_contact_list>(
        [&](gcv_contact_list** out) { return gcv::faults::contacts_at(pair, places, k, out); });
  }
}

// ---------------------------------------------------------------------- large polygons --

// A ring around a centre. Every other vertex lies deeper, all the deeper the later it comes.
std::vector<Vertex> saw(std::size_t count, double radius, const Vertex& centre) {
  std::vector<Vertex> ring;
  for (std::size_t k = 0; k < count; ++k) {
    const double turns = static_cast<double>(k) / static_cast<double>(count);
    const double r = k % 2 == 0 ? radius : radius * (1 - turns / 8);
    const double angle = 6.283185307179586 * turns;
    ring.push_back({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
  }
  return ring;
}

Owner<gcv_polygon> polygon_of(const std::vector<Vertex>& ring) {
  return made<gcv_polygon>(
      [&](gcv_polygon** out) { return gcv_polygon_create(&ring.front().x, ring.size(), 0, out); });
}

// A square with rows of holes.
Owner<gcv_polygon> sieve(std::size_t side) {
  const double size = 3.0 * static_cast<double>(side) + 2;
  std::vector<Vertex> rings = {{0, 0}, {size, 0}, {size, size}, {0, size}};
  std::vector<std::size_t> sizes = {4};
  for (std::size_t k = 0; k < side * side; ++k) {
    const Vertex corner{2 + 3 * static_cast<double>(k % side),
                        2 + 3 * static_cast<double>(k / side)};
    rings.insert(rings.end(), {corner, {corner.x, corner.y + 1}, {corner.x + 1, corner.y}});
    sizes.push_back(3);
  }
  return made<gcv_polygon>([&](gcv_polygon** out) {
    return gcv_polygon_create_rings(&rings.front().x, sizes.data(), sizes.size(), 0, out);
  });
}

void sum_large() {
  const Pair pair{"saws", polygon_of(saw(20000, 1000, {0, 0})), polygon_of(saw(12, 50, {5, 5})),
                  0.5};
  sum_all_ways(pair);
  ask_all(pair, 4);
}

void sum_sieves() {
  const Pair pair{"sieves", sieve(40), polygon_of({{0, 0}, {0.5, 0}, {0.25, 0.5}}), 0.25};
  sum_all_ways(pair);
  ask_all(pair, 4);
  const auto region = made<gcv_region>([&](gcv_region** out) {
    return gcv_minkowski_sum_region(pair.a.get(), pair.b.get(), nullptr, out);
  });
  made<gcv_polygon>([&](gcv_polygon** out) { return gcv_region_polygon(region.get(), 0, out); });
}

// Members of one shape, which overlap in places, in rows.
void ask_large_scene() {
  constexpr std::size_t side = 100;
  const Owner<gcv_polygon> part = polygon_of(saw(12, 1, {0, 0}));
  const Owner<gcv_scene> scene = made<gcv_scene>(gcv_scene_create);
  const std::vector<const gcv_polygon*> polygons(side * side, part.get());
  std::vector<Vertex> positions;
  for (std::size_t k = 0; k < side * side; ++k) {
    positions.push_back({1.9 * static_cast<double>(k % side), 2.1 * static_cast<double>(k / side)});
  }
  std::vector<std::uint64_t> ids(side * side);
  require(
      gcv_scene_add(scene.get(), polygons.data(), &positions.front().x, side * side, ids.data()));
  made<gcv_pair_list>([&](gcv_pair_list** out) {
    return gcv_scene_pairs(scene.get(), nullptr, 0.25, nullptr, nullptr, out);
  });
  made<gcv_contact_list>([&](gcv_contact_list** out) {
    return gcv_scene_contacts(scene.get(), nullptr, 0.25, 0, nullptr, nullptr, out);
  });
  static constexpr double window[] = {20, 20, 60, 60};
  made<gcv_region>([&](gcv_region** out) {
    return gcv_scene_free_region(scene.get(), part.get(), window, nullptr, nullptr, out);
  });
  const Owner<gcv_polygon> sheet = polygon_of({{-2, -2}, {200, -2}, {200, 215}, {-2, 215}});
  require(gcv_scene_set_container(scene.get(), sheet.get()));
  double best[2];
  std::int32_t found = 0;
  require(gcv_scene_best(scene.get(), part.get(), point, nullptr, nullptr, best, &found));
  gcv_escape escape;
  require(gcv_scene_penetration(scene.get(), part.get(), window, 1, nullptr, nullptr, &escape));
  require(gcv_scene_remove(scene.get(), ids.data(), side * side / 2));
}

}  // namespace

int main() {
  for (const Pair& pair : gcv::faults::pairs()) {
    run(pair.name, [&] {
      sum_all_ways(pair);
      ask_all(pair, 20);
    });
  }
  run("a scene", [] { transcript(gcv::faults::NewScene()); });
  run("large polygons", sum_large);
  run("many holes", sum_sieves);
  run("a large scene", ask_large_scene);
}
