// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The nearest point of rings, in doubles: how a user of a whole sum finds the way out of an
// overlap.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "point.hpp"

namespace gcv::bench {

struct NearestPoint {
  Point point{};
  double distance = std::numeric_limits<double>::infinity();

  // Segments are rings of two vertices, points of one.
  void look_at(const PointVector& ring, const Point& from) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point& p = ring[k];
      const Point& q = ring[(k + 1) % ring.size()];
      const Point d{q.x - p.x, q.y - p.y};
      const double square = d.x * d.x + d.y * d.y;
      const double along = (from.x - p.x) * d.x + (from.y - p.y) * d.y;
      const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
      const Point foot{p.x + t * d.x, p.y + t * d.y};
      const double here = std::hypot(foot.x - from.x, foot.y - from.y);
      if (here < distance) {
        *this = {foot, here};
      }
    }
  }
};

inline NearestPoint nearest_point(const std::vector<PointVector>& rings, const Point& from) {
  NearestPoint nearest;
  for (const PointVector& ring : rings) {
    nearest.look_at(ring, from);
  }
  return nearest;
}

}  // namespace gcv::bench
