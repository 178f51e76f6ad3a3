// SPDX-License-Identifier: LGPL-3.0-or-later
//
// One sum through the C interface, or one scene, for guard.py to count the instructions of.
//
//   speed_case                     prints the names of the cases
//   speed_case NAME REPETITIONS    runs one of them
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "catalogue.hpp"
#include "gcv/gcv.h"
#include "shapes.hpp"

namespace gcv::hard {
namespace {

// Between two points of the circle that are settled, the middle one moves in or out in
// proportion to their distance.
void displace_middles(std::vector<double>& radii, std::size_t begin, std::size_t end,
                      Random& random) {
  const std::size_t middle = (begin + end) / 2;
  if (middle == begin) {
    return;
  }
  radii[middle] = (radii[begin] + radii[end]) / 2 +
                  uniform(random, -1000, 1000) * static_cast<double>(end - begin) / 2000;
  displace_middles(radii, begin, middle, random);
  displace_middles(radii, middle, end, random);
}

// Detail at all scales; four times as many vertices as given.
Polygon coast(Random& random, int quarter) {
  Polygon polygon = circle(quarter);
  const std::size_t size = polygon.size();
  std::vector<double> radii(size + 1, static_cast<double>(size));
  displace_middles(radii, 0, size, random);
  for (std::size_t k = 0; k < size; ++k) {
    polygon[k] = {radii[k] * polygon[k][0], radii[k] * polygon[k][1]};
  }
  return polygon;
}

Pair convex() { return {circle(2), mapped(circle(2), rotation(5, 2))}; }

Pair parts() {
  return {{{0, 0},
           {14, -3},
           {25, 2},
           {31, 11},
           {24, 14},
           {29, 24},
           {17, 21},
           {12, 30},
           {7, 20},
           {-4, 22},
           {2, 12},
           {-6, 5}},
          {{0, 0},
           {9, 4},
           {20, 1},
           {18, 10},
           {26, 17},
           {15, 18},
           {13, 27},
           {8, 19},
           {-1, 23},
           {1, 15},
           {-8, 10},
           {2, 7}}};
}

Pair stars() {
  Random random(1);
  const Polygon star = random_star(random, 10);
  return {star, random_star(random, 10)};
}

// Large enough for strips.
Pair many_spikes() {
  Random random(4);
  const Polygon star = spiky_star(random, 200);
  return {star, spiky_star(random, 200)};
}

// Of all heights: a walk over them swings by many times what it gets ahead.
Polygon brush(Random& random, int bristles) {
  Polygon polygon{{0, -40}, {20.0 * bristles, -40}};
  for (int k = bristles - 1; k >= 0; --k) {
    const double x = 20 * k + 10;
    const double tip = x + uniform(random, -8, 8);
    polygon.insert(polygon.end(),
                   {{x + 1, 0}, {tip, 1.0 * uniform(random, 100, 1000)}, {x - 1, 0}});
  }
  return polygon;
}

Pair brushes() {
  Random random(8);
  const Polygon polygon = brush(random, 80);
  return {polygon, brush(random, 80)};
}

Pair combs() {
  const Polygon polygon = comb(20, 1, 1, 7);
  return {polygon, polygon};
}

// Of hundreds of superset edges only the ends lie on the border of the sum, which is a rectangle.
Pair uneven_combs() {
  Random random(7);
  Polygon polygon = comb(40, 1, 1, 7);
  std::vector<double> shifts(81);
  for (std::size_t k = 1; k < shifts.size(); ++k) {
    shifts[k] = shifts[k - 1] + uniform(random, 0, 1000) / 65536.0;
  }
  for (auto& [x, y] : polygon) {
    x += shifts.at(static_cast<std::size_t>(x));
  }
  return {polygon, polygon};
}

Pair coasts() {
  Random random(2);
  const Polygon polygon = coast(random, 75);
  return {polygon, coast(random, 75)};
}

const Polygon octagon{{-2, -5}, {2, -5}, {5, -2}, {5, 2}, {2, 5}, {-2, 5}, {-5, 2}, {-5, -2}};

Pair part_and_convex() { return {parts().a, octagon}; }

// Most of the superset lies deep inside the sum.
Pair coast_and_convex() {
  Random random(3);
  return {coast(random, 250), scaled(octagon, 200)};
}

// The disc lies over the mouths of many gaps at once.
Pair comb_and_disc() {
  const Polygon quarter{{65, 0},  {63, 16}, {60, 25}, {56, 33}, {52, 39},
                        {39, 52}, {33, 56}, {25, 60}, {16, 63}};
  Polygon disc;
  Map map{};
  for (int k = 0; k < 4; ++k) {
    const Polygon turned = mapped(quarter, map);
    disc.insert(disc.end(), turned.begin(), turned.end());
    map = {.xx = -map.yx, .xy = -map.yy, .yx = map.xx, .yy = map.xy};
  }
  return {comb(1000, 1, 1, 1000), scaled(disc, 4)};
}

// The ring goes all along the corridor, and boxes of parts of its wall lie one in another.
Pair spiral_and_small() { return {square_spiral(1200), scaled(octagon, 0x1p-8)}; }

Pair key_in_slot() {
  const Slot slot{3, 4, 7, 5};
  const Map turn = rotation(7, 2);
  return {mapped(block_with(slot), turn), negated(mapped(key_of(slot), turn))};
}

// A row of chambers, each behind a mouth that is too narrow for the other part.
Pair keyholes() {
  Polygon plate{{0, -10}, {200, -10}};
  for (int k = 19; k >= 0; --k) {
    const double x = 10.0 * k;
    for (const auto& [dx, y] : Polygon{
             {9, 10}, {6, 10}, {6, 6}, {8, 6}, {8, 0}, {2, 0}, {2, 6}, {4, 6}, {4, 10}, {1, 10}}) {
      plate.push_back({x + dx, y});
    }
  }
  return {plate, {{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 2.5}, {1, 2.5}, {1, 1}, {0, 1}}};
}

// In no direction of the axes, so that their boxes lie one over the other.
Polygon zigzag(int vertices) {
  Polygon polygon;
  for (int k = 0; k < vertices; ++k) {
    const bool is_back = k >= vertices / 2;
    const int x = is_back ? vertices - 1 - k : k;
    const double y = (x % 2 == 0 ? 0 : vertices / 2) + (is_back ? 1 : 0);
    polygon.push_back({static_cast<double>(x), y});
  }
  return polygon;
}
const Map slanting{.xx = 4, .xy = -3, .yx = 3, .yy = 4};
Pair slanting_zigzag() { return {mapped(zigzag(1000), slanting), {{0, 0}, {3, 1}, {1, 2}}}; }
Pair slanting_spiral() { return {mapped(square_spiral(250), slanting), {{0, 0}, {3, 1}, {1, 2}}}; }

const std::map<std::string, std::function<Pair()>> cases{{"convex", convex},
                                                         {"parts", parts},
                                                         {"stars", stars},
                                                         {"many_spikes", many_spikes},
                                                         {"brushes", brushes},
                                                         {"comb_and_disc", comb_and_disc},
                                                         {"combs", combs},
                                                         {"coasts", coasts},
                                                         {"key_in_slot", key_in_slot},
                                                         {"part_and_convex", part_and_convex},
                                                         {"coast_and_convex", coast_and_convex},
                                                         {"slanting_spiral", slanting_spiral},
                                                         {"slanting_zigzag", slanting_zigzag},
                                                         {"spiral_and_small", spiral_and_small}};

// Edges that end on the border of the sum begin there.
Pair turned(const Pair& pair) {
  const Map half_turn{.xx = -1, .yy = -1};
  return {mapped(pair.a, half_turn), mapped(pair.b, half_turn)};
}
Pair turned_combs() { return turned(combs()); }
Pair turned_uneven_combs() { return turned(uneven_combs()); }

// Sides that points divide, off their lines by roundings: hundreds of superset edges lie within
// some units in the last place of each other.
Pair divided_squares() {
  Polygon polygon;
  const Polygon corners{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& [x, y] = corners[k];
    const auto& [to_x, to_y] = corners[(k + 1) % corners.size()];
    for (int part = 0; part < 30; ++part) {
      polygon.push_back({x + (to_x - x) * part / 30, y + (to_y - y) * part / 30});
    }
  }
  polygon = mapped(polygon, {.xx = 0.8, .xy = -0.6, .yx = 0.6, .yy = 0.8});
  return {polygon, negated(polygon)};
}

Pair crossed_combs() {
  const Polygon polygon = comb(100, 1, 1, 7);
  return {polygon, mapped(polygon, {.xx = 0, .xy = -1, .yx = 1, .yy = 0})};
}

// Hundreds of pairs of edges meet in a few places, where many superset edges begin and end.
Pair turned_spirals() {
  const Polygon spiral = square_spiral(40);
  return turned({spiral, spiral});
}

// Their whole regions.
const std::map<std::string, std::function<Pair()>> region_cases{
    {"region_of_parts", parts},
    {"region_of_stars", stars},
    {"region_of_coasts", coasts},
    {"region_of_key", key_in_slot},
    {"region_of_combs", uneven_combs},
    {"region_of_crossed_combs", crossed_combs},
    {"region_of_divided_squares", divided_squares},
    {"region_of_keyholes", keyholes},
    {"region_of_turned_combs", turned_combs},
    {"region_of_turned_spirals", turned_spirals},
    {"region_of_turned_uneven_combs", turned_uneven_combs}};

void require(gcv_status status) {
  if (status != GCV_OK) {
    throw std::runtime_error(gcv_last_error_message());
  }
}

void add_outer_face(const gcv_polygon* a, const gcv_polygon* b) {
  gcv_outer_face* face = nullptr;
  std::size_t count = 0;
  require(gcv_minkowski_sum(a, b, nullptr, &face));
  require(gcv_outer_face_vertex_count(face, &count));
  Polygon ring(count);
  require(gcv_outer_face_vertices(face, ring.front().data(), count, &count));
  gcv_outer_face_destroy(face);
}

void add_region(const gcv_polygon* a, const gcv_polygon* b) {
  gcv_region* region = nullptr;
  std::size_t count = 0;
  require(gcv_minkowski_sum_region(a, b, nullptr, &region));
  require(gcv_region_vertices(region, nullptr, 0, &count));
  Polygon vertices(count);
  require(gcv_region_vertices(region, vertices.front().data(), count, &count));
  gcv_region_destroy(region);
}

void run(const Pair& pair, bool is_region) {
  gcv_polygon* a = nullptr;
  gcv_polygon* b = nullptr;
  require(gcv_polygon_create(pair.a.front().data(), pair.a.size(), 0, &a));
  require(gcv_polygon_create(pair.b.front().data(), pair.b.size(), 0, &b));
  is_region ? add_region(a, b) : add_outer_face(a, b);
  gcv_polygon_destroy(b);
  gcv_polygon_destroy(a);
}

// Octagons and stars all over a square, added in no order.
class Scene {
 public:
  Scene(Random& random, int members, double side) {
    gcv_polygon* container = nullptr;
    require(gcv_scene_create(&scene_));
    const Polygon square{{0, 0}, {side, 0}, {side, side}, {0, side}};
    require(gcv_polygon_create(square.front().data(), square.size(), 0, &container));
    require(gcv_scene_set_container(scene_, container));
    gcv_polygon_destroy(container);
    for (int k = 0; k < members; ++k) {
      const double x = uniform(random, 0, 1000) * side / 1000;
      add(k % 2 == 0 ? octagon : parts().a, {x, uniform(random, 0, 1000) * side / 1000});
    }
    const Polygon moving = parts().b;
    require(gcv_polygon_create(moving.front().data(), moving.size(), 0, &moving_));
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  ~Scene() {
    gcv_polygon_destroy(moving_);
    gcv_scene_destroy(scene_);
  }

  void find_free_region() const {
    gcv_region* region = nullptr;
    require(gcv_scene_free_region(scene_, moving_, nullptr, nullptr, nullptr, &region));
    gcv_region_destroy(region);
  }
  void find_best() const {
    const double left[2] = {-1, 0};
    double position[2];
    std::int32_t is_found = 0;
    require(gcv_scene_best(scene_, moving_, left, nullptr, nullptr, position, &is_found));
  }

 private:
  void add(const Polygon& polygon, const std::array<double, 2>& position) {
    gcv_polygon* member = nullptr;
    std::uint64_t id = 0;
    require(gcv_polygon_create(polygon.front().data(), polygon.size(), 0, &member));
    const gcv_polygon* const added = member;
    require(gcv_scene_add(scene_, &added, position.data(), 1, &id));
    gcv_polygon_destroy(member);
  }

  gcv_scene* scene_ = nullptr;
  gcv_polygon* moving_ = nullptr;
};

// Calls ask(scene, moving, positions) for a plate with many narrow bars between its holes.
template <class Ask>
void with_plate(Ask ask) {
  constexpr int side = 12;
  Polygon vertices{{0, 0}, {10 * side, 0}, {10 * side, 2 * side}, {0, 2 * side}};
  std::vector<std::size_t> sizes{vertices.size()};
  Polygon positions;
  for (int k = 0; k < side * side; ++k) {
    const double x = 10 * (k % side) + 1;
    const double y = 2 * (k / side) + 0.5;  // NOLINT(bugprone-integer-division): rows
    vertices.insert(vertices.end(), {{x, y}, {x, y + 1}, {x + 8, y + 1}, {x + 8, y}});
    sizes.push_back(4);
    positions.push_back({x + (k % 3), y - 1});
  }
  gcv_polygon* plate = nullptr;
  gcv_polygon* moving = nullptr;
  gcv_scene* scene = nullptr;
  std::uint64_t id = 0;
  require(gcv_polygon_create_rings(vertices.front().data(), sizes.data(), sizes.size(), 0, &plate));
  const Polygon wedge{{0, 0}, {1, 0}, {0.5, 0.75}};
  require(gcv_polygon_create(wedge.front().data(), wedge.size(), 0, &moving));
  require(gcv_scene_create(&scene));
  const gcv_polygon* const added = plate;
  const double origin[2] = {0, 0};
  require(gcv_scene_add(scene, &added, origin, 1, &id));
  ask(scene, moving, positions);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(moving);
  gcv_polygon_destroy(plate);
}
void ways_out_of_plate() {
  with_plate([](const gcv_scene* scene, const gcv_polygon* moving, const Polygon& positions) {
    std::vector<gcv_escape> escapes(positions.size());
    require(gcv_scene_penetration(scene, moving, positions.front().data(), positions.size(),
                                  nullptr, nullptr, escapes.data()));
  });
}
void free_region_of_plate() {
  with_plate([](const gcv_scene* scene, const gcv_polygon* moving, const Polygon& /*positions*/) {
    const double window[4] = {-10, -10, 130, 40};
    gcv_region* region = nullptr;
    require(gcv_scene_free_region(scene, moving, window, nullptr, nullptr, &region));
    gcv_region_destroy(region);
  });
}
void free_region_of_scene() {
  Random random(5);
  Scene(random, 200, 1100).find_free_region();
}
// Members that lie nearly on each other.
void free_region_of_pile() {
  Random random(10);
  const Polygon part = parts().a;
  gcv_polygon* polygon = nullptr;
  gcv_scene* scene = nullptr;
  gcv_region* region = nullptr;
  require(gcv_polygon_create(part.front().data(), part.size(), 0, &polygon));
  require(gcv_scene_create(&scene));
  for (int k = 0; k < 40; ++k) {
    const gcv_polygon* const added = polygon;
    const double position[2] = {uniform(random, 0, 1000) / 65536.0,
                                uniform(random, 0, 1000) / 65536.0};
    std::uint64_t id = 0;
    require(gcv_scene_add(scene, &added, position, 1, &id));
  }
  const double window[4] = {-100, -100, 100, 100};
  require(gcv_scene_free_region(scene, polygon, window, nullptr, nullptr, &region));
  gcv_region_destroy(region);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(polygon);
}
void ask_free_region(const gcv_scene* scene, const gcv_polygon* moving) {
  gcv_region* region = nullptr;
  require(gcv_scene_free_region(scene, moving, nullptr, nullptr, nullptr, &region));
  gcv_region_destroy(region);
}
// Calls ask(scene) for members at positions in a container of rings.
template <class Ask>
void with_container(const Polygon& rings, const std::vector<std::size_t>& sizes,
                    const Polygon& member, const Polygon& positions, Ask ask) {
  gcv_polygon* container = nullptr;
  gcv_polygon* polygon = nullptr;
  gcv_scene* scene = nullptr;
  require(
      gcv_polygon_create_rings(rings.front().data(), sizes.data(), sizes.size(), 0, &container));
  require(gcv_polygon_create(member.front().data(), member.size(), 0, &polygon));
  require(gcv_scene_create(&scene));
  require(gcv_scene_set_container(scene, container));
  for (const auto& position : positions) {
    const gcv_polygon* const added = polygon;
    std::uint64_t id = 0;
    require(gcv_scene_add(scene, &added, position.data(), 1, &id));
  }
  ask(scene, polygon);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(polygon);
  gcv_polygon_destroy(container);
}
// Their edges lie on lines that are nearly one, but for roundings of the positions.
void free_region_of_row() {
  constexpr double edge = 2000;
  Polygon positions;
  for (int k = 0; k < 400; ++k) {
    positions.push_back({2.1 * k, 1.3 * k});
  }
  const Polygon slanting_square{{0, 0}, {0.84, 0.52}, {0.32, 1.36}, {-0.52, 0.84}};
  with_container({{-edge, -edge}, {edge, -edge}, {edge, edge}, {-edge, edge}}, {4}, slanting_square,
                 positions, ask_free_region);
}
// Members between the holes of a container.
void pairs_among_holes() {
  constexpr int side = 40;
  Polygon rings{{0, 0}, {side, 0}, {side, side}, {0, side}};
  std::vector<std::size_t> sizes{4};
  Polygon positions;
  for (int k = 0; k < side * side; ++k) {
    const double x = k % side;
    const double y = k / side;  // NOLINT(bugprone-integer-division): rows
    rings.insert(rings.end(),
                 {{x + 0.3, y + 0.3}, {x + 0.3, y + 0.7}, {x + 0.7, y + 0.7}, {x + 0.7, y + 0.3}});
    sizes.push_back(4);
    positions.push_back({x + 0.8, y + 0.4});
  }
  with_container(rings, sizes, {{0, 0}, {0.1, 0}, {0.1, 0.1}}, positions,
                 [](const gcv_scene* scene, const gcv_polygon* /*moving*/) {
                   gcv_pair_list* pairs = nullptr;
                   require(gcv_scene_pairs(scene, nullptr, 0, nullptr, nullptr, &pairs));
                   gcv_pair_list_destroy(pairs);
                 });
}
// Parallel bars that slant: all of their boxes overlap.
void pairs_of_bars() {
  constexpr int count = 300;
  const Polygon bar = mapped({{0, 0}, {1000, 0}, {1000, 1}, {0, 1}}, slanting);
  Polygon positions;
  for (int k = 0; k < count; ++k) {
    positions.push_back({0, 3.0 * k});
  }
  positions = mapped(positions, slanting);
  const Polygon box{{-1e5, -1e5}, {1e5, -1e5}, {1e5, 1e5}, {-1e5, 1e5}};
  with_container(box, {4}, bar, positions,
                 [](const gcv_scene* scene, const gcv_polygon* /*moving*/) {
                   gcv_pair_list* pairs = nullptr;
                   require(gcv_scene_pairs(scene, nullptr, 1, nullptr, nullptr, &pairs));
                   gcv_pair_list_destroy(pairs);
                 });
}
// Combs on each other, and one more: their long edges overlap on the same lines.
void free_region_of_combs() {
  constexpr int teeth = 24;
  constexpr double height = 10;
  Polygon positions;
  for (int k = 0; k < 8; ++k) {
    positions.push_back({0, height * k});
  }
  const Polygon box{{-100, -100}, {200, -100}, {200, 200}, {-100, 200}};
  with_container(box, {4}, comb(teeth, 1, 1, height - 1), positions, ask_free_region);
}
// Combs of long thin teeth in a row, and one more, all slanting.
void free_region_of_slanting_combs() {
  constexpr int teeth = 16;
  constexpr double height = 1000;
  Polygon positions;
  for (int k = 0; k < 8; ++k) {
    positions.push_back({(teeth - 0.1) * k, 0});
  }
  const Polygon box{{-20, -500}, {400, -500}, {400, 1800}, {-20, 1800}};
  with_container(mapped(box, slanting), {4}, mapped(comb(teeth, 0.9, 0.1, height), slanting),
                 mapped(positions, slanting), ask_free_region);
}
// Squares in a grid, and a long bar among them, all slanting: the box of the bar holds most of
// them.
void free_region_of_bar() {
  constexpr int side = 24;
  Polygon positions;
  for (int k = 0; k < side * side; ++k) {
    positions.push_back({static_cast<double>(k % side), static_cast<double>(k / side)});
  }
  const Polygon bar = mapped({{0, 0}, {0.8 * side, 0}, {0.8 * side, 0.2}, {0, 0.2}}, slanting);
  const Polygon square{{0, 0}, {0.6, 0}, {0.6, 0.6}, {0, 0.6}};
  const Polygon box{{-1, -1}, {side, -1}, {side, side}, {-1, side}};
  with_container(mapped(box, slanting), {4}, mapped(square, slanting), mapped(positions, slanting),
                 [&](const gcv_scene* scene, const gcv_polygon* /*member*/) {
                   gcv_polygon* moving = nullptr;
                   require(gcv_polygon_create(bar.front().data(), bar.size(), 0, &moving));
                   ask_free_region(scene, moving);
                   gcv_polygon_destroy(moving);
                 });
}
// Ways out of bars for a comb that just fits between them, from all over.
void ways_out_of_bars() {
  constexpr int bars = 60;
  Polygon positions;
  for (int k = 0; k < bars; ++k) {
    positions.push_back({0, static_cast<double>(k)});
  }
  Polygon teeth;
  for (int k = 0; k < bars / 2; ++k) {
    for (const std::array<double, 2>& p : Polygon{{0, 0}, {10, 0}, {10, 0.5}, {0, 0.5}}) {
      teeth.push_back({p[0], p[1] + k});
    }
  }
  teeth.push_back({-1, bars / 2 - 0.5});
  teeth.push_back({-1, 0});
  const Polygon box{{-2, -6}, {22, -6}, {22, bars + 6}, {-2, bars + 6}};
  with_container(box, {4}, {{0, 0}, {20, 0}, {20, 0.5}, {0, 0.5}}, positions,
                 [&](const gcv_scene* scene, const gcv_polygon* /*member*/) {
                   gcv_polygon* moving = nullptr;
                   require(gcv_polygon_create(teeth.front().data(), teeth.size(), 0, &moving));
                   constexpr std::size_t count = 12;
                   Polygon places;
                   for (std::size_t k = 0; k < count; ++k) {
                     const auto x = static_cast<double>(k);
                     places.push_back({1.5 * x, 5 * x + 0.3});
                   }
                   std::array<gcv_escape, count> ways;
                   require(gcv_scene_penetration(scene, moving, places.front().data(), count,
                                                 nullptr, nullptr, ways.data()));
                   gcv_polygon_destroy(moving);
                 });
}
// A comb in a pocket of its shape with little play, whose long edges slant, in four directions.
void distance_in_pocket() {
  constexpr int teeth = 600;
  constexpr double edge = 4.0 * teeth;
  const Polygon teeth_of_pocket = comb(teeth, 1, 1, edge);
  Polygon part = comb(teeth, 0.5, 1.5, edge - 1);
  for (auto& [x, y] : part) {
    x += 0.25;
    y = y < 0 ? -0.75 : y > 0 ? y : -0.25;
  }
  Polygon plate{{-edge, -edge}, {edge, -edge}, {edge, 2 * edge}, {-edge, 2 * edge}};
  const std::array<std::size_t, 2> sizes{plate.size(), teeth_of_pocket.size()};
  plate.insert(plate.end(), teeth_of_pocket.rbegin(), teeth_of_pocket.rend());
  Map map = slanting;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Polygon turned_plate = mapped(plate, map);
    const Polygon turned_part = mapped(part, map);
    gcv_polygon* a = nullptr;
    gcv_polygon* b = nullptr;
    const double translation[2] = {0, 0};
    gcv_separation separation;
    require(gcv_polygon_create_rings(turned_plate.front().data(), sizes.data(), 2, 0, &a));
    require(gcv_polygon_create(turned_part.front().data(), turned_part.size(), 0, &b));
    require(gcv_distance(a, b, translation, 1, nullptr, &separation));
    if (separation.relation != GCV_APART) {
      throw std::runtime_error("the part has no play");
    }
    gcv_polygon_destroy(b);
    gcv_polygon_destroy(a);
    map = {.xx = -map.yx, .xy = -map.yy, .yx = map.xx, .yy = map.xy};
  }
}
void ask_distances(const Pair& pair, const Polygon& positions) {
  gcv_polygon* a = nullptr;
  gcv_polygon* b = nullptr;
  require(gcv_polygon_create(pair.a.front().data(), pair.a.size(), 0, &a));
  require(gcv_polygon_create(pair.b.front().data(), pair.b.size(), 0, &b));
  std::vector<gcv_separation> separations(positions.size());
  require(
      gcv_distance(a, b, positions.front().data(), positions.size(), nullptr, separations.data()));
  gcv_polygon_destroy(b);
  gcv_polygon_destroy(a);
}

// An octagon about the mouths of a comb whose long edges slant.
void distance_beside_comb() {
  Polygon positions;
  for (int k = 0; k < 8; ++k) {
    positions.push_back({400.0 + 170 * k, 1240.0 + 7 * k});
  }
  ask_distances({mapped(comb(1000, 1, 1, 1000), slanting), mapped(scaled(octagon, 50), slanting)},
                mapped(positions, slanting));
}

// Small convex polygons all round each other; some have parallel edges.
void distances_of_convex() {
  const Polygon slab = scaled({{-4, -1}, {4, -1}, {4, 1}, {-4, 1}}, 0.25);
  Polygon positions;
  for (int k = 0; k < 100; ++k) {
    positions.push_back({(2.2 + 0.01 * k) * std::cos(k), (2.2 + 0.01 * k) * std::sin(k)});
  }
  const std::array<Polygon, 3> shapes{circle(3), mapped(circle(2), rotation(5, 2)), slab};
  for (const Polygon& a : shapes) {
    for (const Polygon& b : shapes) {
      ask_distances({a, b}, positions);
    }
  }
}

void best_in_scene() {
  Random random(6);
  Scene(random, 300, 600).find_best();
}

// A layout of one shape: each search begins where the last one ended.
void layout_of_keys() {
  const Polygon key = mapped(key_of({3, 4, 7, 5}), slanting);
  with_container(
      {{0, 0}, {6000, 0}, {6000, 150}, {0, 150}}, {4}, key, {},
      [](gcv_scene* scene, const gcv_polygon* moving) {
        const double left[2] = {-1, 0};
        double position[2];
        std::int32_t is_found = 0;
        std::uint64_t id = 0;
        for (int k = 0; k < 150; ++k) {
          require(gcv_scene_best(scene, moving, left, nullptr, nullptr, position, &is_found));
          if (is_found == 0) {
            throw std::runtime_error("the strip is too short");
          }
          require(gcv_scene_add(scene, &moving, position, 1, &id));
        }
      });
}

// Squares of such extents are beyond the largest double.
void huge_stars() {
  constexpr double size = 0x1p600;
  Random random(10);
  const Polygon star = scaled(spiky_star(random, 60), size);
  const Polygon turned = mapped(star, slanting);
  gcv_polygon* a = nullptr;
  gcv_polygon* b = nullptr;
  require(gcv_polygon_create(star.front().data(), star.size(), 0, &a));
  require(gcv_polygon_create(turned.front().data(), turned.size(), 0, &b));
  add_region(a, b);
  const std::array<double, 2> position{0, 0};
  gcv_escape way;
  require(gcv_penetration(a, b, position.data(), 1, nullptr, &way));
  gcv_polygon_destroy(b);
  gcv_polygon_destroy(a);
}

// A coast in a hole of its own shape: all superset edges of the hole meet in one place.
void region_of_fit() {
  Random random(9);
  const Polygon part = coast(random, 40);
  constexpr double edge = 0x1p14;
  Polygon plate{{-edge, -edge}, {edge, -edge}, {edge, edge}, {-edge, edge}};
  const std::array<std::size_t, 2> sizes{plate.size(), part.size()};
  plate.insert(plate.end(), part.rbegin(), part.rend());
  const Polygon turned = negated(part);
  gcv_polygon* a = nullptr;
  gcv_polygon* b = nullptr;
  require(gcv_polygon_create_rings(plate.front().data(), sizes.data(), sizes.size(), 0, &a));
  require(gcv_polygon_create(turned.front().data(), turned.size(), 0, &b));
  add_region(a, b);
  gcv_polygon_destroy(b);
  gcv_polygon_destroy(a);
}

const std::map<std::string, std::function<void()>> other_cases{
    {"distance_beside_comb", distance_beside_comb},
    {"distance_in_pocket", distance_in_pocket},
    {"distances_of_convex", distances_of_convex},
    {"huge_stars", huge_stars},
    {"layout_of_keys", layout_of_keys},
    {"region_of_fit", region_of_fit},
    {"scene_best", best_in_scene},
    {"scene_free_region", free_region_of_scene},
    {"scene_free_region_of_bar", free_region_of_bar},
    {"scene_free_region_of_combs", free_region_of_combs},
    {"scene_free_region_of_pile", free_region_of_pile},
    {"scene_free_region_of_plate", free_region_of_plate},
    {"scene_free_region_of_row", free_region_of_row},
    {"scene_free_region_of_slanting_combs", free_region_of_slanting_combs},
    {"scene_pairs_among_holes", pairs_among_holes},
    {"scene_pairs_of_bars", pairs_of_bars},
    {"scene_penetration", ways_out_of_plate},
    {"scene_ways_out_of_bars", ways_out_of_bars}};

}  // namespace
}  // namespace gcv::hard

int main(int argc, char** argv) {
  using namespace gcv::hard;
  if (argc != 3) {
    for (const auto* all : {&cases, &region_cases}) {
      for (const auto& [name, pair] : *all) {
        std::cout << name << '\n';
      }
    }
    for (const auto& [name, run_case] : other_cases) {
      std::cout << name << '\n';
    }
    return 0;
  }
  const std::string name = argv[1];
  const bool is_other = other_cases.count(name) != 0;
  const bool is_region = region_cases.count(name) != 0;
  const Pair pair = is_other ? Pair{} : is_region ? region_cases.at(name)() : cases.at(name)();
  for (int repetitions = std::stoi(argv[2]); repetitions > 0; --repetitions) {
    is_other ? other_cases.at(name)() : run(pair, is_region);
  }
  return 0;
}
