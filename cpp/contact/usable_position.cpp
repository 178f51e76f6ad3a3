// SPDX-License-Identifier: LGPL-3.0-or-later
#include "usable_position.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace gcv {

namespace {

// A number of doubles to go up, or down.
double stepped(double x, int steps) {
  for (; steps > 0; --steps) {
    x = std::nextafter(x, std::numeric_limits<double>::infinity());
  }
  for (; steps < 0; ++steps) {
    x = std::nextafter(x, -std::numeric_limits<double>::infinity());
  }
  return x + 0.0;
}

struct Steps {
  int x;
  int y;
  [[nodiscard]] int square() const { return x * x + y * y; }
};

// All of at most two doubles each way but none at all, from the shortest on.
using AllSteps = std::array<Steps, 24>;

AllSteps all_steps() {
  AllSteps all{};
  std::size_t count = 0;
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      if (x != 0 || y != 0) {
        all[count++] = {x, y};
      }
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Steps& p, const Steps& q) { return p.square() < q.square(); });
  return all;
}

// Two doubles away from the nearest one is within 2 ulps, but not on the other side of it than the
// exact number.
bool is_within_two_ulps(int steps, int side_of_exact) {
  return std::abs(steps) < 2 || (steps > 0 ? side_of_exact >= 0 : side_of_exact <= 0);
}

}  // namespace

UsablePosition usable_position(const PolygonPair& pair, const ExactPoint& exact, Tally& tally) {
  const Point nearest = nearest_point(exact, {0, 0}, tally);
  if (!std::isfinite(nearest.x) || !std::isfinite(nearest.y)) {
    return {nearest, Relation::overlapping};
  }
  const Relation there = relation(PlacedPair(pair, nearest), tally);
  if (there != Relation::overlapping) {
    return {nearest, there};
  }
  static const AllSteps steps = all_steps();
  const int side_x = compare_x(exact, nearest.x, tally);
  const int side_y = compare_y(exact, nearest.y, tally);
  for (const Steps& step : steps) {
    const Point position{stepped(nearest.x, step.x), stepped(nearest.y, step.y)};
    if (is_within_two_ulps(step.x, side_x) && is_within_two_ulps(step.y, side_y) &&
        std::isfinite(position.x) && std::isfinite(position.y)) {
      const Relation relation_there = relation(PlacedPair(pair, position), tally);
      if (relation_there != Relation::overlapping) {
        return {position, relation_there};
      }
    }
  }
  return {nearest, Relation::overlapping};
}

}  // namespace gcv
