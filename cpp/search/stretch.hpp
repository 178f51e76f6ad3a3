// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "point.hpp"

namespace gcv {

// How a superset edge can lead a walk away from another one: to the right; straight on or to the
// left, where the other one ends; not at all, since it has the opposite direction.
enum class Way : std::uint8_t { right, onwards, back };

// What a walk asks about: a stretch of the line of a superset edge s, from a place on s onwards.
// Points are in relative coordinates, which are rounded (contributing_vertices.hpp).
struct Stretch {
  const SumEdge& s;
  Point origin;   // the start of s
  Point from;     // where the stretch begins; not beyond its exact place
  Point to;       // where it ends
  double length;  // the parameter of `to` on s: 1 at the end of s, more beyond it

  // The point of that parameter.
  [[nodiscard]] Point at(double parameter) const {
    return parameter < length ? Point{origin.x + parameter * s.dx, origin.y + parameter * s.dy}
                              : to;
  }
  // The parameter of a point on the line, about.
  [[nodiscard]] double parameter_of(const Point& p) const {
    const bool by_x = std::abs(s.dx) >= std::abs(s.dy);
    return clamped(by_x ? (p.x - origin.x) / s.dx : (p.y - origin.y) / s.dy);
  }
  [[nodiscard]] double clamped(double parameter) const {
    return std::min(std::max(parameter, 0.0), length);
  }
};

}  // namespace gcv
