// SPDX-License-Identifier: LGPL-3.0-or-later
#include "scene.hpp"

#include <gcv/gcv.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "data.hpp"
#include "families.hpp"
#include "handle.hpp"
#include "sets.hpp"
#include "shapes.hpp"

namespace gcv::bench {

namespace {

using test::uniform;

constexpr int fine = 1000000;  // steps of random fractions

Ring no_fit_vertices(const gcv_polygon* a, const gcv_polygon* b) {
  const double reference[2] = {0, 0};
  gcv_region* made = nullptr;
  check(gcv_no_fit_region(a, b, reference, nullptr, &made));
  const Owned<gcv_region> region(made);
  std::size_t count = 0;
  check(gcv_region_vertices(made, nullptr, 0, &count));
  Ring vertices(count);
  check(gcv_region_vertices(made, &vertices.data()->x, count, &count));
  return vertices;
}

double half_of_larger_side(const Ring& points) {
  const auto [left, right] = std::minmax_element(
      points.begin(), points.end(), [](const Point& p, const Point& q) { return p.x < q.x; });
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(), [](const Point& p, const Point& q) { return p.y < q.y; });
  return std::max(right->x - left->x, high->y - low->y) / 2;
}

class Drawer {
 public:
  Drawer(Ring vertices, double size) : vertices_(std::move(vertices)), size_(size) {}

  Point vertex() {
    return vertices_[static_cast<std::size_t>(
        uniform(random_, 0, static_cast<int>(vertices_.size()) - 1))];
  }

  Point near() {
    const Point p = vertex();
    const double reach = size_ * std::pow(10, -1 - 2 * fraction());
    const double x = p.x + reach * (2 * fraction() - 1);
    return {x, p.y + reach * (2 * fraction() - 1)};
  }

 private:
  double fraction() { return static_cast<double>(uniform(random_, 0, fine)) / fine; }

  Random random_{1};
  Ring vertices_;
  double size_;
};

bool are_apart(const gcv_polygon* a, const gcv_polygon* b, const Point& translation) {
  std::int8_t relation = 0;
  check(gcv_relation(a, b, &translation.x, 1, nullptr, &relation));
  return relation == GCV_APART;
}

SceneFamily family_of(const Set& set, const char* name, std::size_t count) {
  SceneFamily family{.name = name, .scenes = {}, .count = count};
  for (const Pair& pair : set.pairs) {
    family.scenes.emplace_back([name, pair] {
      const auto [a, b] = pair.make();
      return Scene{name, pair.name, tidy(a), tidy(b)};
    });
  }
  return family;
}

SceneFamily convex_pairs(std::size_t count, int seeds) {
  SceneFamily family{.name = "convex, 4 to 20 vertices", .scenes = {}, .count = count};
  for (int n = 4; n <= 20; ++n) {
    for (int seed = 0; seed < seeds; ++seed) {
      family.scenes.emplace_back([name = family.name, n, seed] {
        Random random(static_cast<std::uint64_t>(100 * n + seed));
        const int m = uniform(random, 4, 20);
        Ring a = random_convex(random, n);
        return Scene{name, std::to_string(n) + " x " + std::to_string(m), tidy(a),
                     tidy(random_convex(random, m))};
      });
    }
  }
  return family;
}

SceneFamily coasts_of(int n, std::size_t count, int seeds) {
  SceneFamily family{.name = "coasts " + std::to_string(n), .scenes = {}, .count = count};
  for (int seed = 0; seed < seeds; ++seed) {
    family.scenes.emplace_back([name = family.name, n, seed] {
      const auto [a, b] = reference_coasts(n, seed);
      return Scene{name, std::to_string(seed), tidy(a), tidy(b)};
    });
  }
  return family;
}

}  // namespace

std::vector<SceneFamily> scene_families(bool quick) {
  std::vector<SceneFamily> families{convex_pairs(256, quick ? 1 : 2)};
  if (const auto directory = test::data_directory()) {
    const std::vector<Set> blocks = blocks_of_pairs(*directory);
    families.push_back(family_of(nesting(*directory, quick ? 8 : 60), "nesting parts", 256));
    families.push_back(family_of(blocks.at(0), "the paper's pairs", 256));
    families.push_back(family_of(blocks.at(1), "real pairs", 256));
    Set growing = blocks.at(2);
    if (quick) {
      growing.pairs.resize(2);
    }
    families.push_back(family_of(growing, "growing shapes", 256));
  } else {
    std::fputs("no data: neither GCV_DATA_DIR nor ../shared/data; going on without\n", stderr);
  }
  families.push_back(coasts_of(1000, 256, 3));
  if (!quick) {
    families.push_back(coasts_of(10000, 256, 3));
    families.push_back(coasts_of(100000, 64, 3));
  }
  return families;
}

Situation situation(const Scene& scene, std::size_t count) {
  const Owned<gcv_polygon> a = make_polygon(scene.a);
  const Owned<gcv_polygon> b = make_polygon(scene.b);
  const Ring vertices = no_fit_vertices(a.get(), b.get());
  const double size = half_of_larger_side(vertices);
  Drawer drawer(vertices, size);
  Placements contact{"contact", {}, {}};
  Placements near{"near", {}, {}};
  Placements motion{"motion", {}, {}};
  while (contact.translations.size() < count) {
    contact.translations.push_back(drawer.vertex());
    near.translations.push_back(drawer.near());
  }
  while (motion.translations.size() < count) {
    const Point start = drawer.near();
    const Point target = drawer.near();
    if (are_apart(a.get(), b.get(), start)) {
      motion.translations.push_back(start);
      motion.motions.push_back({2 * (target.x - start.x), 2 * (target.y - start.y)});
    }
  }
  return {scene, size, {contact, near, motion}};
}

}  // namespace gcv::bench
