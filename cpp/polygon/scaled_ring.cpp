// SPDX-License-Identifier: LGPL-3.0-or-later
#include "scaled_ring.hpp"

#include <algorithm>

#include "vector.hpp"

namespace gcv {

ScaledRing::ScaledRing(const PointVector& vertices) {
  double largest = 0;
  for (const Point& p : vertices) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  exponent_ = std::ilogb(largest) + 1;
  points_.reserve(vertices.size());
  for (const Point& p : vertices) {
    points_.push_back(scaled(p));
  }
}

double ScaledRing::extent() const {
  const auto [x0, x1] = std::minmax_element(
      points_.begin(), points_.end(), [](const Point& p, const Point& q) { return p.x < q.x; });
  const auto [y0, y1] = std::minmax_element(
      points_.begin(), points_.end(), [](const Point& p, const Point& q) { return p.y < q.y; });
  return (x1->x - x0->x) + (y1->y - y0->y);
}

double ScaledRing::unscaled_bound(double length) const {
  const double unscaled = std::ldexp(length, exponent_);
  return scaled(unscaled) < length ? next_up(unscaled) : unscaled;
}

}  // namespace gcv
