// SPDX-License-Identifier: LGPL-3.0-or-later
#include "catalogue.hpp"

#include <algorithm>
#include <functional>

namespace worlds {
namespace {

// Counter-clockwise, from the smallest corner on, in the corner of the grid.
Ring normalised(Ring ring) {
  Point low = ring[0];
  for (const Point& p : ring) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  }
  for (Point& p : ring) {
    p = p - low;
  }
  if (twice_area(ring) < 0) {
    std::reverse(ring.begin(), ring.end());
  }
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

}  // namespace

Catalogue::Catalogue(int grid, int corners) {
  Ring ring;
  const std::function<void()> extend = [&] {
    if (ring.size() > 2 && twice_area(ring) > 0 && is_simple(ring) && normalised(ring) == ring) {
      rings_.push_back(ring);
    }
    if (ring.size() == static_cast<std::size_t>(corners)) {
      return;
    }
    for (Int x = 0; x < grid; ++x) {
      for (Int y = 0; y < grid; ++y) {
        const Point p{x, y};
        if (ring.empty() || (p > ring[0] && std::find(ring.begin(), ring.end(), p) == ring.end())) {
          ring.push_back(p);
          extend();
          ring.pop_back();
        }
      }
    }
  };
  extend();
  std::sort(rings_.begin(), rings_.end());
  for (int symmetry = 0; symmetry < 8; ++symmetry) {
    for (Ring turned : rings_) {
      for (Point& p : turned) {
        p = image(symmetry, p);
      }
      const auto found = std::lower_bound(rings_.begin(), rings_.end(), normalised(turned));
      images_[static_cast<std::size_t>(symmetry)].push_back(
          static_cast<std::size_t>(found - rings_.begin()));
    }
  }
}

Int Random::below(Int end) {
  state_ += 0x9e3779b97f4a7c15;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  z ^= z >> 31;
  return static_cast<Int>(z % static_cast<std::uint64_t>(end));
}

Ring random_ring(Random& random, int grid, int corners) {
  for (;;) {
    Ring ring(static_cast<std::size_t>(3 + random.below(corners - 2)));
    for (Point& p : ring) {
      p = {random.below(grid), random.below(grid)};
    }
    if (is_simple(ring)) {
      return ring;
    }
  }
}

Sample random_polygon(Random& random, int grid, int holes) {
  Sample sample{{random_ring(random, grid, 6)}, {}};
  for (int tries = 0; tries < 20 && static_cast<int>(sample.polygon.size()) <= holes; ++tries) {
    Polygon polygon = sample.polygon;
    polygon.push_back(random_ring(random, grid, 4));
    if (is_valid(polygon)) {
      sample.polygon = polygon;
    } else {
      sample.refused.push_back(polygon);
    }
  }
  return sample;
}

}  // namespace worlds
