// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Bytes -> polygons of small integers, made to fit each other exactly, or nearly so.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "../worlds/figures.hpp"
#include "../worlds/plane.hpp"
#include "../worlds/symmetries.hpp"
#include "fuzz.hpp"
#include "grid_polygons.hpp"

namespace gcv::fuzz {

using worlds::Int;
using WorldRing = worlds::Ring;
using World = worlds::Polygon;
using WorldPoint = worlds::Point;

inline Int small(Input& input, std::size_t from, std::size_t to) {
  return static_cast<Int>(from + input.below(to - from + 1));
}

inline WorldRing in_integers(const Ring& ring) {
  WorldRing result;
  for (const Point& p : ring) {
    result.push_back({static_cast<Int>(p[0]), static_cast<Int>(p[1])});
  }
  return result;
}

inline WorldRing rectangle(Int x0, Int y0, Int x1, Int y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

// A ring of up to six corners on a grid of so many units.
inline WorldRing any_ring(Input& input, std::size_t most = 4) {
  const std::size_t extent = 1 + input.below(most);
  for (int tries = 0; tries < 8; ++tries) {
    WorldRing ring = in_integers(grid_points(input, extent));
    if (worlds::is_simple(ring)) {
      return ring;
    }
  }
  return {{0, 0}, {1, 0}, {0, 1}};
}

// Without vertices between two edges of one direction.
inline WorldRing corners(const WorldRing& ring) {
  WorldRing result;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const WorldPoint before = ring[(k + ring.size() - 1) % ring.size()];
    const WorldPoint after = ring[(k + 1) % ring.size()];
    if (worlds::cross(ring[k] - before, after - ring[k]) != 0) {
      result.push_back(ring[k]);
    }
  }
  return result;
}

// The heights of columns, each of width 1.
inline std::vector<Int> heights(Input& input) {
  std::vector<Int> all(1 + input.below(4));
  for (Int& height : all) {
    height = small(input, 1, 3);
  }
  return all;
}

inline std::vector<WorldPoint> skyline(const std::vector<Int>& heights) {
  std::vector<WorldPoint> line;
  Int x = 0;
  for (const Int height : heights) {
    line.insert(line.end(), {{x, height}, {x + 1, height}});
    ++x;
  }
  return line;
}

inline WorldRing histogram(const std::vector<Int>& heights) {
  WorldRing ring{{0, 0}};
  const std::vector<WorldPoint> line = skyline(heights);
  ring.insert(ring.end(), line.begin(), line.end());
  ring.push_back({static_cast<Int>(heights.size()), 0});
  return corners(ring);
}

// What a block leaves of itself where a histogram is pressed into it from below.
inline WorldRing complement(const std::vector<Int>& heights) {
  const Int width = static_cast<Int>(heights.size());
  WorldRing ring{{-1, 0}, {-1, 4}, {width + 1, 4}, {width + 1, 0}, {width, 0}};
  const std::vector<WorldPoint> line = skyline(heights);
  ring.insert(ring.end(), line.rbegin(), line.rend());
  ring.push_back({0, 0});
  return corners(ring);
}

// A key: a shaft with a bow at its end. `ahead` is how far the bow stands out on each side.
inline WorldRing key(Int width, Int length, Int ahead, Int bow) {
  const Int right = 2 * ahead + width;
  return {{ahead, 0},      {ahead + width, 0},    {ahead + width, length},
          {right, length}, {right, length + bow}, {0, length + bow},
          {0, length},     {ahead, length}};
}

// A block with the slot of such a key, open below.
inline WorldRing lock(Int width, Int length, Int ahead, Int bow) {
  WorldRing ring{{-1, 0},
                 {-1, length + bow + 1},
                 {2 * ahead + width + 1, length + bow + 1},
                 {2 * ahead + width + 1, 0}};
  const WorldRing slot = key(width, length, ahead, bow);
  ring.insert(ring.end(), slot.begin() + 1, slot.end());
  ring.push_back(slot[0]);
  return ring;
}

// The box of a ring, wider by so much, with the ring as its hole.
inline World around(const WorldRing& hole, Int left, Int below, Int right, Int above) {
  const auto [low, high] = worlds::bounds(hole);
  return {rectangle(low.x - left, low.y - below, high.x + right, high.y + above), hole};
}

// Squares, and halves of them, in a box of 3 x 3: a few are taken out of it.
inline World figure(Input& input) {
  constexpr int box = 3;
  std::vector<int> states(box * box, 1);
  for (std::size_t changes = 1 + input.below(7); changes > 0; --changes) {
    std::vector<int> changed = states;
    changed[input.below(box * box)] = static_cast<int>(input.below(worlds::Figure::kStates));
    if (worlds::Figure(box, changed).is_connected()) {
      states = changed;
    }
  }
  return worlds::Figure(box, states).polygon();
}

// A block with a hole that touches its sides, or with two that touch each other.
inline World touching_holes(Input& input) {
  if (input.below(2) == 0) {
    return {rectangle(0, 0, small(input, 4, 5), small(input, 4, 5)),
            {{0, 2}, {2, 0}, {4, 2}, {2, 4}}};
  }
  const Int size = small(input, 1, 2);
  return {rectangle(0, 0, 2 * size + 2, 2 * size + 2), rectangle(1, 1, 1 + size, 1 + size),
          rectangle(1 + size, 1 + size, 1 + 2 * size, 1 + 2 * size)};
}

struct WorldPair {
  World a;
  World b;
};

inline WorldPair read_fitting_pair(Input& input) {
  const std::size_t family = input.below(8);
  if (family == 0) {
    return {{any_ring(input)}, {any_ring(input)}};
  }
  if (family == 1) {
    const WorldRing hole = any_ring(input, 3);
    World a = around(hole, small(input, 0, 1), small(input, 0, 1), small(input, 0, 1), 1);
    return {std::move(a), {input.below(2) == 0 ? hole : any_ring(input)}};
  }
  if (family == 2) {
    std::vector<Int> columns = heights(input);
    const WorldRing other = complement(columns);
    // One column may stand out too far, or leave a gap.
    Int& column = columns[input.below(columns.size())];
    column = std::max<Int>(1, column + small(input, 0, 2) - 1);
    return {{other}, {histogram(columns)}};
  }
  if (family == 3) {
    const Int width = small(input, 1, 2);
    const Int length = small(input, 1, 2);
    const Int ahead = small(input, 0, 1);
    const Int room = small(input, 0, 1);
    World b{ahead == 0 ? rectangle(0, 0, width, length + 1) : key(width, length, ahead, 1)};
    return {{lock(width, length, 1, 1 + room)}, std::move(b)};
  }
  if (family == 4) {
    World a{any_ring(input)};
    World b = input.below(2) == 0 ? a : worlds::reflected(a);
    return {std::move(a), std::move(b)};
  }
  if (family == 5) {
    return {touching_holes(input), {in_integers(grid_rectangle(input, 2))}};
  }
  if (family == 6) {
    return {figure(input), {any_ring(input)}};
  }
  return {{corners(in_integers(grid_comb(input, 2)))}, {histogram(heights(input))}};
}

// The lower left corner of the box becomes the origin.
inline World in_corner(const World& polygon) {
  return worlds::moved(polygon, -worlds::bounds(polygon[0]).first);
}

inline World turned(World polygon, int symmetry) {
  for (WorldRing& ring : polygon) {
    for (WorldPoint& p : ring) {
      p = worlds::image(symmetry, p);
    }
  }
  return polygon;
}

inline World sheared(World polygon) {
  for (WorldRing& ring : polygon) {
    for (WorldPoint& p : ring) {
      p.x += p.y;
    }
  }
  return polygon;
}

// Can the definitions deal with it? The sides of the pieces that it is cut into, inside and outside
// of it, must not be in too many directions.
inline bool is_defined(const World& polygon) {
  std::vector<WorldPoint> points;
  bool is_upright = true;
  for (const worlds::Edge& e : worlds::edges(polygon)) {
    points.push_back(e.from);
    is_upright = is_upright && (e.from.x == e.to.x || e.from.y == e.to.y);
  }
  const auto [low, high] = worlds::bounds(points);
  points.insert(points.end(), {low, {low.x, high.y}, high, {high.x, low.y}});
  const auto is_short = [](WorldPoint p, WorldPoint q) {
    const WorldPoint d = p == q ? p - q : worlds::primitive(q - p);
    return std::max(std::abs(d.x), std::abs(d.y)) <= worlds::kLongest;
  };
  return is_upright || std::all_of(points.begin(), points.end(), [&](WorldPoint p) {
           return std::all_of(points.begin(), points.end(),
                              [&](WorldPoint q) { return is_short(p, q); });
         });
}

// Both in the corner of the grid.
inline WorldPair read_pair(Input& input) {
  WorldPair pair = read_fitting_pair(input);
  const std::size_t how = input.below(32);
  if (how >= 24) {
    pair = {sheared(pair.a), sheared(pair.b)};
  }
  pair = {turned(pair.a, static_cast<int>(how % 8)), turned(pair.b, static_cast<int>(how % 8))};
  if (how / 8 == 1) {
    std::swap(pair.a, pair.b);
  }
  return {in_corner(pair.a), in_corner(pair.b)};
}

}  // namespace gcv::fuzz
