// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_reports [VERTICES]
//
// How long functions go on without a report to the caller, who can only then cancel: two coasts of
// so many vertices, and a scene of octagons of as many, 100,000 by default. Handles are new, so
// that all is prepared. In time of the processor, on one thread. Prints a table in Markdown.
#include <gcv/gcv.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "contact/handle.hpp"
#include "families.hpp"
#include "generators.hpp"

namespace gcv::bench {
namespace {

double milliseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

class Reports {
 public:
  // Options under which a call tells this object. From now on its time counts.
  gcv_options options() {
    gcv_options options = GCV_OPTIONS_INIT;
    options.progress = [](void* reports, std::uint64_t /*done*/, std::uint64_t /*estimate*/) {
      static_cast<Reports*>(reports)->note();
      return 0;
    };
    options.progress_context = this;
    begin_ = last_ = milliseconds();
    return options;
  }

  void print(const std::string& name) {
    note();
    std::printf("| %s | %.0f | %zu | %.1f | %.0f |\n", name.c_str(), last_ - begin_, count_ - 1,
                longest_, after_ - begin_);
    std::fflush(stdout);
  }

 private:
  void note() {
    const double now = milliseconds();
    if (now - last_ > longest_) {
      longest_ = now - last_;
      after_ = last_;
    }
    last_ = now;
    ++count_;
  }

  double begin_ = 0;
  double last_ = 0;
  double longest_ = 0;
  double after_ = 0;
  std::size_t count_ = 0;
};

using Call = std::function<gcv_status(const gcv_polygon*, const gcv_polygon*, const gcv_options*)>;

void print_pair(const std::string& name, int vertices, const Call& call) {
  const auto [ring_a, ring_b] = reference_coasts(vertices, 1);
  const Owned<gcv_polygon> a = make_polygon(ring_a);
  const Owned<gcv_polygon> b = make_polygon(ring_b);
  Reports reports;
  const gcv_options options = reports.options();
  check(call(a.get(), b.get(), &options));
  reports.print(name);
}

void print_pairs(int vertices) {
  const double away[2] = {5000, 100};
  const double back[2] = {-10000, -200};
  const double near[2] = {1, 2};
  print_pair("outer face", vertices, [](auto* a, auto* b, auto* options) {
    gcv_outer_face* face = nullptr;
    const gcv_status status = gcv_minkowski_sum(a, b, options, &face);
    gcv_outer_face_destroy(face);
    return status;
  });
  print_pair("region", vertices, [](auto* a, auto* b, auto* options) {
    gcv_region* region = nullptr;
    const gcv_status status = gcv_minkowski_sum_region(a, b, options, &region);
    gcv_region_destroy(region);
    return status;
  });
  print_pair("relation", vertices, [&](auto* a, auto* b, auto* options) {
    std::int8_t relation = 0;
    return gcv_relation(a, b, near, 1, options, &relation);
  });
  print_pair("distance", vertices, [&](auto* a, auto* b, auto* options) {
    gcv_separation separation;
    return gcv_distance(a, b, away, 1, options, &separation);
  });
  print_pair("cast", vertices, [&](auto* a, auto* b, auto* options) {
    gcv_impact impact;
    return gcv_cast(a, b, away, back, 1, options, &impact);
  });
  print_pair("penetration", vertices, [&](auto* a, auto* b, auto* options) {
    gcv_escape escape;
    return gcv_penetration(a, b, near, 1, options, &escape);
  });
}

struct DestroyScene {
  void operator()(gcv_scene* scene) const { gcv_scene_destroy(scene); }
};
using OwnedScene = std::unique_ptr<gcv_scene, DestroyScene>;

// Octagons at random places, of which about half are covered.
OwnedScene make_scene(std::size_t members) {
  const PointVector octagon{{1, 0.4},   {0.4, 1},   {-0.4, 1}, {-1, 0.4},
                            {-1, -0.4}, {-0.4, -1}, {0.4, -1}, {1, -0.4}};
  const double side = 2.5 * std::sqrt(static_cast<double>(members));
  const Owned<gcv_polygon> shape = make_polygon(octagon);
  const Owned<gcv_polygon> container = make_polygon({{0, 0}, {side, 0}, {side, side}, {0, side}});
  test::Random random(1);
  PointVector positions(members);
  for (Point& p : positions) {
    const auto coordinate = [&] { return side * test::uniform(random, 0, 1000000) / 1e6; };
    p.x = coordinate();
    p.y = coordinate();
  }
  gcv_scene* made = nullptr;
  check(gcv_scene_create(&made));
  OwnedScene scene(made);
  check(gcv_scene_set_container(made, container.get()));
  const std::vector<const gcv_polygon*> shapes(members, shape.get());
  std::vector<std::uint64_t> ids(members);
  check(gcv_scene_add(made, shapes.data(), &positions.data()->x, members, ids.data()));
  return scene;
}

void print_scene(std::size_t members) {
  const OwnedScene owned = make_scene(members);
  const gcv_scene* const scene = owned.get();
  const Owned<gcv_polygon> part = make_polygon({{0, 0}, {1, 0.1}, {0.2, 1}});
  const auto print = [&](const char* name, const std::function<gcv_status(gcv_options*)>& call) {
    Reports reports;
    gcv_options options = reports.options();
    check(call(&options));
    reports.print(name);
  };
  print("pairs of a scene", [&](gcv_options* options) {
    gcv_pair_list* pairs = nullptr;
    const gcv_status status = gcv_scene_pairs(scene, nullptr, 0.1, nullptr, options, &pairs);
    gcv_pair_list_destroy(pairs);
    return status;
  });
  print("contacts of a scene", [&](gcv_options* options) {
    gcv_contact_list* contacts = nullptr;
    const gcv_status status =
        gcv_scene_contacts(scene, nullptr, 0.1, 0, nullptr, options, &contacts);
    gcv_contact_list_destroy(contacts);
    return status;
  });
  print("best position", [&](gcv_options* options) {
    const double direction[2] = {-1, -0.3};
    double position[2];
    std::int32_t found = 0;
    return gcv_scene_best(scene, part.get(), direction, nullptr, options, position, &found);
  });
  print("free region", [&](gcv_options* options) {
    gcv_region* region = nullptr;
    const gcv_status status =
        gcv_scene_free_region(scene, part.get(), nullptr, nullptr, options, &region);
    gcv_region_destroy(region);
    return status;
  });
}

}  // namespace
}  // namespace gcv::bench

int main(int argc, char** argv) {
  const int vertices = argc > 1 ? std::atoi(argv[1]) : 100000;
  if (argc > 2 || vertices < 100) {
    std::fputs("usage: gcv_reports [VERTICES]\n", stderr);
    return 2;
  }
  std::puts("| | ms | reports | longest time without one, ms | after ms |");
  std::puts("| --- | ---: | ---: | ---: | ---: |");
  gcv::bench::print_pairs(vertices);
  gcv::bench::print_scene(static_cast<std::size_t>(vertices) / 8);
  return 0;
}
