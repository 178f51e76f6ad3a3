// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The same question asked in another way: of polygons that are moved, scaled by a power of two,
// turned, spelled differently, or exchanged. The answers are known from the first ones.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "../worlds/library.hpp"
#include "world_shapes.hpp"

namespace gcv::fuzz {

using Handle = worlds::Owner<gcv_polygon>;

struct Variant {
  // Of everything, after all else.
  int exponent = 0;
  // Of what stays, and of what moves.
  WorldPoint shift{};
  WorldPoint moving_shift{};
  int symmetry = 0;
  // A is asked about B, and not B about A.
  bool exchanged = false;
  // Rings begin elsewhere, run the other way, and have vertices on their edges.
  bool respelled = false;

  static Variant scaled(Input& input) {
    constexpr int farthest = 960;
    Variant variant;
    const int exponent = input.take<std::int8_t>();
    variant.exponent =
        input.below(4) == 0 ? std::clamp(8 * exponent, -farthest, farthest) : exponent / 4;
    return variant;
  }

  static WorldPoint far(Input& input) {
    const Int unit = Int{1} << input.below(44);
    return {unit * input.take<std::int8_t>(), unit * input.take<std::int8_t>()};
  }

  static Variant read(Input& input) {
    Variant variant = scaled(input);
    const std::size_t kind = input.below(5);
    if (kind == 1) {
      variant.shift = far(input);
      variant.moving_shift = input.below(2) == 0 ? variant.shift : far(input);
    } else if (kind == 2) {
      variant.exponent = 0;
      variant.symmetry = static_cast<int>(1 + input.below(7));
    } else if (kind == 3) {
      variant.exponent = 0;
      variant.exchanged = true;
    } else if (kind == 4) {
      variant.respelled = true;
    }
    return variant;
  }

  [[nodiscard]] double number(Int n) const { return std::ldexp(static_cast<double>(n), exponent); }

  // What is made of a translation, in halves of units.
  [[nodiscard]] WorldPoint of_halves(WorldPoint halves) const {
    return exchanged ? -halves : worlds::image(symmetry, halves);
  }

  // A translation in doubles.
  void append_place(WorldPoint halves, std::vector<double>& xy) const {
    const WorldPoint p = of_halves(halves) + 2 * (shift - moving_shift);
    xy.insert(xy.end(), {number(p.x) / 2, number(p.y) / 2});
  }

  // A vector of the answers, as it is without the variant.
  [[nodiscard]] Point back(double x, double y) const {
    Point p{std::ldexp(x, -exponent), std::ldexp(y, -exponent)};
    if (exchanged || (symmetry & 2) != 0) {
      p[0] = -p[0];
    }
    if (exchanged || (symmetry & 4) != 0) {
      p[1] = -p[1];
    }
    if ((symmetry & 1) != 0) {
      std::swap(p[0], p[1]);
    }
    return p;
  }
};

// The vertices of a ring, each followed by the middle of its edge, from the last edge backwards.
inline std::vector<double> respelled(const std::vector<double>& xy) {
  std::vector<double> result;
  const std::size_t n = xy.size() / 2;
  for (std::size_t k = n; k-- > 0;) {
    const std::size_t next = (k + 1) % n;
    result.insert(result.end(), {xy[2 * k], xy[2 * k + 1]});
    result.insert(result.begin() + static_cast<std::ptrdiff_t>(result.size()) - 2,
                  {xy[2 * k] / 2 + xy[2 * next] / 2, xy[2 * k + 1] / 2 + xy[2 * next + 1] / 2});
  }
  return result;
}

inline gcv_status make(const World& polygon, const Variant& variant, WorldPoint shift,
                       Handle& out) {
  std::vector<double> xy;
  std::vector<std::size_t> sizes;
  for (const WorldRing& ring : polygon) {
    std::vector<double> numbers;
    for (const WorldPoint& p : ring) {
      const WorldPoint q = worlds::image(variant.symmetry, p) + shift;
      numbers.insert(numbers.end(), {variant.number(q.x), variant.number(q.y)});
    }
    if (variant.respelled) {
      numbers = respelled(numbers);
    }
    sizes.push_back(numbers.size() / 2);
    xy.insert(xy.end(), numbers.begin(), numbers.end());
  }
  gcv_polygon* handle = nullptr;
  const gcv_status status =
      gcv_polygon_create_rings(xy.data(), sizes.data(), sizes.size(), 0, &handle);
  out.reset(handle);
  return status;
}

inline Handle make(const World& polygon, const Variant& variant, WorldPoint shift) {
  Handle handle;
  worlds::check(make(polygon, variant, shift, handle));
  return handle;
}

}  // namespace gcv::fuzz
