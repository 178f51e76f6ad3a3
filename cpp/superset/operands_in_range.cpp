// SPDX-License-Identifier: LGPL-3.0-or-later
#include "operands_in_range.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "box.hpp"

namespace gcv {

namespace {

// Extents of 2^-400 to 2^400 stay as they are. Others are brought near to that, so that small
// coordinates of large polygons are not lost.
constexpr int exponent_that_stays = 400;
constexpr int scaled_exponent = 150;

// The binary logarithm of the extents of both.
int exponent_of_extents(const Operands& operands) {
  const double extents = extents_of(operands.a.bounds) + extents_of(operands.b.bounds);
  return std::isfinite(extents) ? std::ilogb(extents) : std::numeric_limits<double>::max_exponent;
}

bool is_exact(double x, double scale) {
  const double scaled = x * scale;
  return std::isfinite(scaled) && scaled / scale == x;
}

bool is_exact(const PointVector& points, double scale) {
  return std::all_of(points.begin(), points.end(),
                     [&](const Point& p) { return is_exact(p.x, scale) && is_exact(p.y, scale); });
}

bool is_exact(const Boundary& boundary, double scale) {
  return is_exact(boundary.vertices, scale) && is_exact(boundary.positions, scale);
}

}  // namespace

OperandsInRange::Scaled::Scaled(const Operands& given, double scale)
    : a(given.a.scaled(scale)), b(given.b.scaled(scale)), operands{a, b, given.directions} {
  if (given.focus) {
    operands.focus = gcv::scaled(*given.focus, scale);
  }
}

OperandsInRange::OperandsInRange(const Operands& operands) : given_(operands) {
  const int exponent = exponent_of_extents(operands);
  if (std::abs(exponent) <= exponent_that_stays) {
    return;
  }
  const double scale =
      std::ldexp(1, (exponent > 0 ? scaled_exponent : -scaled_exponent) - exponent);
  if (is_exact(operands.a, scale) && is_exact(operands.b, scale)) {
    scaled_.emplace(operands, scale);
    scale_ = scale;
  }
}

std::optional<Point> OperandsInRange::scaled(const Point& p) const {
  return is_exact(p.x, scale_) && is_exact(p.y, scale_)
             ? std::optional(Point{scale_ * p.x, scale_ * p.y})
             : std::nullopt;
}

}  // namespace gcv
