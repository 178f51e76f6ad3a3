// SPDX-License-Identifier: LGPL-3.0-or-later
#include "units.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "vector.hpp"

namespace gcv {

double unit_in_last_place(double x) {
  const double size = std::abs(x);
  const double next = next_up(size);
  return std::isfinite(next) ? next - size : size - std::nextafter(size, 0.0);
}

Point units_in_last_place(const PointVector& points) {
  Point largest{0, 0};
  for (const Point& p : points) {
    largest = {std::max(largest.x, std::abs(p.x)), std::max(largest.y, std::abs(p.y))};
  }
  return {unit_in_last_place(largest.x), unit_in_last_place(largest.y)};
}

double sum_bound(double x, double y) {
  assert(x >= 0 && y >= 0);
  return x == 0 || y == 0 ? x + y : next_up(x + y);
}

}  // namespace gcv
