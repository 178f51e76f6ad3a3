// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The vertices of a ring in units in which nothing overflows, and bounds on distances in them.
// Simplification measures with these.
#pragma once

#include <cmath>
#include <limits>

#include "boundary.hpp"
#include "point.hpp"

namespace gcv {

// The unit is a power of two that no coordinate of the ring exceeds. Coordinates below 2^-1074
// units underflow; the bounds on distances cover what is lost.
class ScaledRing {
 public:
  explicit ScaledRing(const PointVector& vertices);

  // Width and height of the bounding box, added. A tolerance of that much allows everything.
  [[nodiscard]] double extent() const;

  [[nodiscard]] Index size() const { return static_cast<Index>(points_.size()); }
  // The vertex after the last one is the first one.
  [[nodiscard]] const Point& operator[](Index i) const { return points_[i == size() ? 0 : i]; }
  [[nodiscard]] double scaled(double x) const { return std::ldexp(x, -exponent_); }
  [[nodiscard]] Point scaled(const Point& p) const { return {scaled(p.x), scaled(p.y)}; }
  [[nodiscard]] Point unscaled(const Point& p) const {
    return {std::ldexp(p.x, exponent_), std::ldexp(p.y, exponent_)};
  }
  // At least the length in the units of the ring itself.
  [[nodiscard]] double unscaled_bound(double length) const;

 private:
  PointVector points_;
  int exponent_ = 0;
};

// The distance of a point from a segment ab.
struct DistanceBound {
  double bound;  // at least the distance
  bool is_left;  // the point is to the left of the line ab, or nearly on it
};

// Costs one division and one square root.
//
// Why it is a bound. Let u = 2^-53, and q = p - a with each coordinate rounded by u of itself. The
// cross product is off by 4u |q| |ab|. So the distance from the line is off by 4u |q| and by 4u of
// itself. The foot of the perpendicular may wrongly be taken to lie between a and b. Then it lies
// beyond them by 4u |q| at most.
inline DistanceBound distance_bound(const Point& p, const Point& a, const Point& b) {
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  constexpr double underflow = 1e-140;
  const Point ab = difference(b, a);
  const Point q = difference(p, a);
  const double along = dot(q, ab);
  const double square = dot(ab, ab);
  const double across = cross(ab, q);
  double length = 0;
  if (along > 0 && along < square && square > underflow * underflow) {
    length = std::abs(across) / std::sqrt(square);
  } else {
    const Point from_end = along > 0 ? difference(p, b) : q;
    length = std::sqrt(dot(from_end, from_end));
  }
  const double slack = 16 * u * (std::abs(q.x) + std::abs(q.y) + length) + underflow;
  return {length + slack, across >= 0};
}

}  // namespace gcv
