// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Directions and lengths in doubles, some of them with error bounds.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "point.hpp"

namespace gcv {

// The direction from p to q: q - p, rounded. A quarter of q - p if that overflows.
inline Point direction(const Point& p, const Point& q) {
  const Point d{q.x - p.x, q.y - p.y};
  return std::isfinite(std::abs(d.x) + std::abs(d.y)) ? d
                                                      : Point{q.x / 4 - p.x / 4, q.y / 4 - p.y / 4};
}

// The unit vector of the direction, longer or shorter by at most 5 u. NaN for (0, 0).
inline Point unit_vector(const Point& direction) {
  const double size = std::max(std::abs(direction.x), std::abs(direction.y));
  const Point scaled{direction.x / size, direction.y / size};
  const double length = std::sqrt(scaled.x * scaled.x + scaled.y * scaled.y);
  return {scaled.x / length, scaled.y / length};
}

// The next larger double. x must not be negative.
inline double next_up(double x) {
  return x < infinity ? std::bit_cast<double>(std::bit_cast<std::uint64_t>(x + 0.0) + 1) : x;
}

// sqrt(x^2 + y^2), within 4 u. Unlike std::hypot the same bits from every standard library.
inline double length_of(double x, double y) {
  const double longer = std::max(std::abs(x), std::abs(y));
  const double shorter = std::min(std::abs(x), std::abs(y));
  if (shorter == 0) {
    return longer;
  }
  const double ratio = shorter / longer;
  return longer * std::sqrt(1 + ratio * ratio);
}

// At least sqrt(x^2 + y^2). There are five roundings, each below u; the factor covers them. If the
// smaller number underflows beside the larger one, its share of the result is negligible too.
inline double length_bound(double x, double y) {
  const double rounded = length_of(x, y);
  return x == 0 || y == 0 ? rounded
                          : next_up(rounded * (1 + 4 * std::numeric_limits<double>::epsilon()));
}

// A power of two by which lengths up to that size can be multiplied, so that their squares are in
// range.
inline double scale_for_squares(double size) {
  return size > 0x1p400 ? 0x1p-600 : size < 0x1p-400 ? 0x1p600 : 1;
}

}  // namespace gcv
