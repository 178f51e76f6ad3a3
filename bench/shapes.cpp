// SPDX-License-Identifier: LGPL-3.0-or-later
#include "shapes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace gcv::bench {

namespace {

Point at_angle(double angle, double radius) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

Ring coast(Random& random, int vertices) {
  const auto n = static_cast<std::size_t>(vertices);
  std::vector<double> radius(n + 1, 100);
  std::vector<std::pair<std::size_t, std::size_t>> arcs{{0, n}};
  for (std::size_t next = 0; next < arcs.size(); ++next) {
    const auto [begin, end] = arcs[next];
    const std::size_t middle = (begin + end) / 2;
    if (middle == begin) {
      continue;
    }
    const double displacement = test::uniform(random, -1000000, 1000000) / 1000000.0;
    const double length = static_cast<double>(end - begin) / vertices;
    radius[middle] = (radius[begin] + radius[end]) / 2 + 60 * length * displacement;
    arcs.emplace_back(begin, middle);
    arcs.emplace_back(middle, end);
  }
  Ring ring;
  for (std::size_t k = 0; k < n; ++k) {
    ring.push_back(at_angle(2 * std::numbers::pi * static_cast<double>(k) / vertices, radius[k]));
  }
  return ring;
}

Ring regular(int vertices, double radius) {
  Ring ring;
  for (int k = 0; k < vertices; ++k) {
    ring.push_back(at_angle(2 * std::numbers::pi * k / vertices, radius));
  }
  return ring;
}

Ring random_convex(Random& random, int vertices) {
  Ring ring;
  for (int k = 0; k < vertices; ++k) {
    const double jitter = test::uniform(random, 0, 900) / 1000.0;
    ring.push_back(at_angle(2 * std::numbers::pi * (k + jitter) / vertices, 100));
  }
  return ring;
}

Ring tiny(Random& random) {
  const int vertices = test::uniform(random, 3, 8);
  Ring ring;
  for (int k = 0; k < vertices; ++k) {
    const double radius = test::uniform(random, 30, 100);
    const Point p = at_angle(2 * std::numbers::pi * k / vertices, radius);
    ring.push_back({std::round(p.x), std::round(p.y)});
  }
  return ring;
}

Ring comb(int teeth) {
  Ring ring{{0, -1}, {2.0 * teeth - 1, -1}};
  for (int k = teeth - 1; k >= 0; --k) {
    const double x = 2.0 * k;
    ring.insert(ring.end(), {{x + 1, 7}, {x, 7}});
    if (k > 0) {
      ring.insert(ring.end(), {{x, 0}, {x - 1, 0}});
    }
  }
  return ring;
}

Ring uneven_comb(Random& random, int teeth) {
  std::vector<double> sides{0};  // of teeth, from left to right: both of the first one, ...
  while (sides.size() < 2 * static_cast<std::size_t>(teeth)) {
    sides.push_back(sides.back() + 1 + 0x1p-16 * test::uniform(random, 0, 1023));
  }
  Ring ring = comb(teeth);
  for (Point& p : ring) {
    p.x = sides[static_cast<std::size_t>(p.x)];
  }
  return ring;
}

Ring quarter_turned(Ring ring) {
  for (Point& p : ring) {
    p = {0.0 - p.y, p.x};
  }
  return ring;
}

Ring koch(int level) {
  const double h = std::sqrt(0.75);
  Ring ring{{0, 0}, {243, 0}, {121.5, 243 * h}};
  for (int k = 0; k < level; ++k) {
    Ring finer;
    for (std::size_t e = 0; e < ring.size(); ++e) {
      const Point& p = ring[e];
      const Point& q = ring[(e + 1) % ring.size()];
      const double dx = (q.x - p.x) / 3;
      const double dy = (q.y - p.y) / 3;
      finer.insert(finer.end(), {p,
                                 {p.x + dx, p.y + dy},
                                 {p.x + 1.5 * dx + h * dy, p.y + 1.5 * dy - h * dx},
                                 {p.x + 2 * dx, p.y + 2 * dy}});
    }
    ring = std::move(finer);
  }
  return ring;
}

Ring zigzag(int corners) {
  Ring ring;
  Ring upper;
  for (int k = 0; k < corners; ++k) {
    const double y = k % 2 == 0 ? 0 : 40;
    ring.push_back({static_cast<double>(k), y});
    upper.push_back({static_cast<double>(k), y + 1});
  }
  ring.insert(ring.end(), upper.rbegin(), upper.rend());
  return ring;
}

Ring spiral(int turns) {
  Ring ring;
  Ring inner;
  double low = 0;
  double high = 4.0 * turns;
  for (int k = 0; k < turns; ++k) {
    ring.insert(ring.end(), {{low, low}, {high, low}, {high, high}, {low + 2, high}});
    inner.insert(
        inner.end(),
        {{low + 1, low + 1}, {high - 1, low + 1}, {high - 1, high - 1}, {low + 3, high - 1}});
    low += 2;
    high -= 2;
  }
  ring.insert(ring.end(), inner.rbegin(), inner.rend());
  return ring;
}

Ring needles(int spikes) {
  Ring ring;
  for (int k = 0; k < spikes; ++k) {
    ring.push_back({1, 0.1 * k});
    ring.push_back({100 + k / 7.0, 0.1 * k + 0.05});
  }
  ring.insert(ring.end(), {{1, 0.1 * spikes}, {0, 0.1 * spikes}, {0, 0}});
  return ring;
}

Ring scaled(Ring ring, double factor) {
  for (Point& p : ring) {
    p = {factor * p.x, factor * p.y};
  }
  return ring;
}

Ring moved(Ring ring, double x, double y) {
  for (Point& p : ring) {
    p = {p.x + x, p.y + y};
  }
  return ring;
}

}  // namespace gcv::bench
