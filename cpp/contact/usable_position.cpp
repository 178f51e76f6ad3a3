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
    x = std::nextafter(x, infinity);
  }
  for (; steps < 0; ++steps) {
    x = std::nextafter(x, -infinity);
  }
  return x + 0.0;
}

struct Steps {
  int x;
  int y;
  [[nodiscard]] int square() const { return x * x + y * y; }
};

// All of at most two doubles each way but none at all, from the shortest on.
using AllSteps = std::array<Steps, NearbyPositions::other_count>;

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

std::optional<Point> NearbyPositions::other(std::size_t k) {
  static const AllSteps steps = all_steps();
  const Steps& step = steps[k];
  if (!sides_ && step.square() >= 4) {
    sides_ = {compare_x(exact_, shift_, nearest_.x, tally_),
              compare_y(exact_, shift_, nearest_.y, tally_)};
  }
  const Point position{stepped(nearest_.x, step.x), stepped(nearest_.y, step.y)};
  const bool is_near = (!sides_ || (is_within_two_ulps(step.x, sides_->x) &&
                                    is_within_two_ulps(step.y, sides_->y))) &&
                       std::isfinite(position.x) && std::isfinite(position.y);
  return is_near ? std::optional(position) : std::nullopt;
}

UsablePosition usable_position(const PolygonPair& pair, const ExactPoint& exact,
                               const std::optional<EdgePair>& edges, Tally& tally) {
  return usable_position(exact, {0, 0}, tally, NearbyRelations(pair, {0, 0}, edges, tally));
}

}  // namespace gcv
