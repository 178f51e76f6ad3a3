// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_scenes [LARGEST]
//
// Times walls of touching blocks: members added in one call and all touching pairs found, exactly,
// beside the trees of GEOS and Box2D, which do the same for boxes. One thread, unless it says two.
// Prints a table in Markdown. The generator knows which blocks touch. Exit status 1 if libgcv finds
// others. LARGEST is the most blocks of a wall, 1000000 by default.
#include <box2d/b2_dynamic_tree.h>
#include <geos_c.h>
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "gcv/gcv.h"

namespace {

void check(gcv_status status) {
  if (status != GCV_OK) {
    throw std::runtime_error(gcv_last_error_message());
  }
}

double milliseconds_of(const auto& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double, std::milli> elapsed =
      std::chrono::steady_clock::now() - begin;
  return elapsed.count();
}

double median(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

struct Box {
  double x0, y0, x1, y1;
};

// Blocks at positions.
struct Wall {
  std::string name;
  std::vector<gcv_polygon*> polygons;  // each once
  std::vector<const gcv_polygon*> blocks;
  std::vector<double> positions;
  std::vector<Box> boxes;
  std::size_t touching = 0;  // pairs

  ~Wall() {
    for (gcv_polygon* polygon : polygons) {
      gcv_polygon_destroy(polygon);
    }
  }
};

// Rows of blocks, each shifted by half a block against the next: a block touches two beside it, and
// two in each of the next rows.
std::size_t pairs_in_rows(std::size_t rows, std::size_t columns) {
  return rows * (columns - 1) + (rows - 1) * (2 * columns - 1);
}

// Blocks of six vertices, each a polygon of its own, where it is. Neighbours share two vertices.
void make_cells(std::size_t rows, std::size_t columns, Wall& wall) {
  std::mt19937 random(1);
  const auto jitter = [&] { return 0.1 * (static_cast<double>(random()) / 4294967296.0 - 0.5); };
  const std::size_t width = 2 * columns + 2;
  std::vector<double> corners;
  for (std::size_t row = 0; row <= rows; ++row) {
    for (std::size_t k = 0; k < width; ++k) {
      const double up = (k + row) % 2 == 0 ? 0.2 : -0.2;
      corners.push_back(static_cast<double>(k) / 2 + jitter());
      corners.push_back(static_cast<double>(row) + up + jitter());
    }
  }
  std::vector<double> xy;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const std::size_t first = row * width + 2 * column + row % 2;
      Box box{INFINITY, INFINITY, -INFINITY, -INFINITY};
      for (const std::size_t k :
           {first, first + 1, first + 2, first + width + 2, first + width + 1, first + width}) {
        const double x = corners[2 * k];
        const double y = corners[2 * k + 1];
        xy.insert(xy.end(), {x, y});
        box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x), std::max(box.y1, y)};
      }
      wall.boxes.push_back(box);
    }
  }
  const std::size_t count = rows * columns;
  wall.polygons.resize(count);
  std::vector<gcv_status> statuses(count);
  const std::vector<std::size_t> sizes(count, 6);
  check(gcv_polygon_create_many(xy.data(), sizes.data(), count, 0, wall.polygons.data(),
                                statuses.data()));
  wall.blocks.assign(wall.polygons.begin(), wall.polygons.end());
  wall.positions.assign(2 * count, 0);
}

// One brick at many positions, which differ by whole numbers exactly.
void make_masonry(std::size_t rows, std::size_t columns, Wall& wall) {
  const double brick[] = {0, 0, 2, 0, 2, 1, 0, 1};
  wall.polygons.resize(1);
  check(gcv_polygon_create(brick, 4, 0, wall.polygons.data()));
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const double x = 0.125 + static_cast<double>(2 * column + row % 2);
      const double y = 0.75 + static_cast<double>(row);
      wall.positions.insert(wall.positions.end(), {x, y});
      wall.boxes.push_back({x, y, x + 2, y + 1});
    }
  }
  wall.blocks.assign(rows * columns, wall.polygons.front());
}

struct Scene {
  Scene() { check(gcv_scene_create(&scene)); }
  ~Scene() { gcv_scene_destroy(scene); }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  void add(const Wall& wall) {
    ids.resize(wall.blocks.size());
    check(gcv_scene_add(scene, wall.blocks.data(), wall.positions.data(), wall.blocks.size(),
                        ids.data()));
  }
  // The caller owns the list.
  [[nodiscard]] gcv_pair_list* pairs(const gcv_pair_list* previous, std::int32_t threads) const {
    gcv_options options = GCV_OPTIONS_INIT;
    options.threads = threads;
    gcv_pair_list* list = nullptr;
    check(gcv_scene_pairs(scene, previous, 0, nullptr, &options, &list));
    return list;
  }

  gcv_scene* scene = nullptr;
  std::vector<std::uint64_t> ids;
};

std::size_t size_of(const gcv_pair_list* list) {
  std::size_t count = 0;
  check(gcv_pair_list_pairs(list, nullptr, 0, &count));
  return count;
}

std::size_t bytes_in_use() {
  const struct mallinfo2 memory = mallinfo2();
  return memory.uordblks + memory.hblkhd;
}

// Moves every hundredth block by a little.
void move_some(const Wall& wall, Scene& scene) {
  std::vector<std::uint64_t> ids;
  std::vector<double> positions;
  for (std::size_t k = 0; k < wall.blocks.size(); k += 100) {
    ids.push_back(scene.ids[k]);
    positions.push_back(wall.positions[2 * k] + 0.01);
    positions.push_back(wall.positions[2 * k + 1]);
  }
  check(gcv_scene_set(scene.scene, ids.data(), nullptr, positions.data(), ids.size()));
}

// How long the tree of GEOS takes to be built over boxes and asked for what meets each of them.
double milliseconds_of_geos(const std::vector<Box>& boxes) {
  const GEOSContextHandle_t geos = GEOS_init_r();
  std::vector<GEOSGeometry*> shapes;
  for (const Box& box : boxes) {
    GEOSCoordSequence* ends = GEOSCoordSeq_create_r(geos, 2, 2);
    GEOSCoordSeq_setXY_r(geos, ends, 0, box.x0, box.y0);
    GEOSCoordSeq_setXY_r(geos, ends, 1, box.x1, box.y1);
    shapes.push_back(GEOSGeom_createLineString_r(geos, ends));
  }
  std::size_t found = 0;
  const double milliseconds = milliseconds_of([&] {
    GEOSSTRtree* tree = GEOSSTRtree_create_r(geos, 10);
    for (GEOSGeometry* shape : shapes) {
      GEOSSTRtree_insert_r(geos, tree, shape, shape);
    }
    for (const GEOSGeometry* shape : shapes) {
      GEOSSTRtree_query_r(
          geos, tree, shape,
          [](void* /*item*/, void* count) { ++*static_cast<std::size_t*>(count); }, &found);
    }
    GEOSSTRtree_destroy_r(geos, tree);
  });
  for (GEOSGeometry* shape : shapes) {
    GEOSGeom_destroy_r(geos, shape);
  }
  GEOS_finish_r(geos);
  if (found < boxes.size()) {
    throw std::runtime_error("GEOS has lost boxes");
  }
  return milliseconds;
}

// The same for that of Box2D, whose boxes are in floats.
double milliseconds_of_box2d(const std::vector<Box>& boxes) {
  struct Counter {
    bool QueryCallback(std::int32_t /*proxy*/) {
      ++found;
      return true;
    }
    std::size_t found = 0;
  };
  Counter counter;
  const double milliseconds = milliseconds_of([&] {
    b2DynamicTree tree;
    std::vector<b2AABB> all;
    for (const Box& box : boxes) {
      b2AABB aabb;
      aabb.lowerBound.Set(static_cast<float>(box.x0), static_cast<float>(box.y0));
      aabb.upperBound.Set(static_cast<float>(box.x1), static_cast<float>(box.y1));
      all.push_back(aabb);
      tree.CreateProxy(aabb, nullptr);
    }
    for (const b2AABB& aabb : all) {
      tree.Query(&counter, aabb);
    }
  });
  if (counter.found < boxes.size()) {
    throw std::runtime_error("Box2D has lost boxes");
  }
  return milliseconds;
}

// Prints a line of the table. Returns whether the pairs are those that touch.
bool measure(const Wall& wall) {
  constexpr int runs = 5;
  std::vector<double> both;
  std::vector<double> on_one;
  std::vector<double> on_two;
  std::vector<double> step;
  std::vector<double> geos;
  std::vector<double> box2d;
  bool is_right = true;
  double bytes = 0;
  for (int run = 0; run < runs; ++run) {
    const std::size_t before = bytes_in_use();
    Scene scene;
    const double adding = milliseconds_of([&] { scene.add(wall); });
    bytes = static_cast<double>(bytes_in_use() - before - 8 * scene.ids.capacity()) /
            static_cast<double>(wall.blocks.size());
    gcv_pair_list* list = nullptr;
    both.push_back(adding + milliseconds_of([&] { list = scene.pairs(nullptr, 1); }));
    on_one.push_back(both.back() - adding);
    is_right = is_right && size_of(list) == wall.touching;
    gcv_pair_list* other = nullptr;
    on_two.push_back(milliseconds_of([&] { other = scene.pairs(nullptr, 2); }));
    gcv_pair_list_destroy(other);
    step.push_back(milliseconds_of([&] {
      move_some(wall, scene);
      other = scene.pairs(list, 1);
    }));
    gcv_pair_list_destroy(other);
    gcv_pair_list_destroy(list);
    geos.push_back(milliseconds_of_geos(wall.boxes));
    box2d.push_back(milliseconds_of_box2d(wall.boxes));
  }
  const double own = median(both);
  std::printf("| %s | %zu | %zu | %.1f | %.2f | %.2f | %.2f | %.1f %% | %.0f |\n",
              wall.name.c_str(), wall.blocks.size(), wall.touching, own, own / median(geos),
              own / median(box2d), median(on_one) / median(on_two), 100 * median(step) / own,
              bytes);
  std::fflush(stdout);
  return is_right;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t largest = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000000;
  std::puts(
      "| wall | blocks | touching pairs | ms | times GEOS | times Box2D | on two threads | a step "
      "| "
      "bytes |");
  std::puts("| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |");
  bool is_right = true;
  for (const bool is_masonry : {false, true}) {
    for (const std::size_t side : {32U, 100U, 316U, 1000U}) {
      if (side * side > largest) {
        continue;
      }
      Wall wall;
      wall.name = is_masonry ? "masonry" : "cells";
      wall.touching = pairs_in_rows(side, side);
      (is_masonry ? make_masonry : make_cells)(side, side, wall);
      is_right = measure(wall) && is_right;
    }
  }
  if (!is_right) {
    std::puts("\nThe pairs are not those that touch.");
  }
  return is_right ? 0 : 1;
}
