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

double exact_extents_bound(double extents, double error) {
  return sum_bound(sum_bound(error, error), sum_bound(error, extents));
}

// A bound of the distance from a point near the foot of the perpendicular. The coordinates of that
// point are off by a few units in the last place at most. Scales where squares would overflow or
// underflow. What smaller coordinates lose by that is far below a unit.
double distance_bound(Point p, Point a, Point b, double unit) {
  const double scale = unit > 0x1p400 ? 0x1p-600 : unit < 0x1p-400 ? 0x1p600 : 1;
  for (Point* const point : {&p, &a, &b}) {
    *point = {point->x * scale, point->y * scale};
  }
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double foot = ((p.x - a.x) * dx + (p.y - a.y) * dy) / square;
  const double t = foot > 0 ? std::min(foot, 1.0) : 0.0;
  return length_bound(p.x - (a.x + t * dx), p.y - (a.y + t * dy)) / scale + 8 * unit;
}

}  // namespace gcv
