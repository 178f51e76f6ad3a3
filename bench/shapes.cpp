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

// The middle of an arc is displaced by up to height times what part it is of the whole, to that
// power.
Ring displaced_circle(Random& random, int vertices, double height, double power) {
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
    radius[middle] =
        (radius[begin] + radius[end]) / 2 + height * std::pow(length, power) * displacement;
    arcs.emplace_back(begin, middle);
    arcs.emplace_back(middle, end);
  }
  Ring ring;
  for (std::size_t k = 0; k < n; ++k) {
    ring.push_back(at_angle(2 * std::numbers::pi * static_cast<double>(k) / vertices, radius[k]));
  }
  return ring;
}

}  // namespace

Ring coast(Random& random, int vertices) { return displaced_circle(random, vertices, 60, 1); }

Ring rough_coast(Random& random, int vertices, double hurst) {
  // So that no radius, of 100 at first, is below 10.
  return displaced_circle(random, vertices, 90 * (1 - std::pow(2, -hurst)), hurst);
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

Ring comb(int teeth, double width, double height) {
  Ring ring{{0, -1}, {(2.0 * teeth - 1) * width, -1}};
  for (int k = teeth - 1; k >= 0; --k) {
    const double x = 2.0 * k * width;
    ring.insert(ring.end(), {{x + width, height}, {x, height}});
    if (k > 0) {
      ring.insert(ring.end(), {{x, 0}, {x - width, 0}});
    }
  }
  return ring;
}

Ring comb(int teeth) { return comb(teeth, 1, 7); }

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

Ring zigzag(int corners, double height) {
  Ring ring;
  Ring upper;
  for (int k = 0; k < corners; ++k) {
    const double y = k % 2 == 0 ? 0 : height;
    ring.push_back({static_cast<double>(k), y});
    upper.push_back({static_cast<double>(k), y + 1});
  }
  ring.insert(ring.end(), upper.rbegin(), upper.rend());
  return ring;
}

Ring divided_square(int points_a_side) {
  const Ring corners = regular(4, 100);
  Ring ring;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point& p = corners[k];
    const Point& q = corners[(k + 1) % corners.size()];
    for (int part = 0; part < points_a_side; ++part) {
      const double share = static_cast<double>(part) / points_a_side;
      ring.push_back({p.x + (q.x - p.x) * share, p.y + (q.y - p.y) * share});
    }
  }
  return slanting(std::move(ring));
}

Ring slanting(Ring ring) {
  for (Point& p : ring) {
    p = {4 * p.x - 3 * p.y, 3 * p.x + 4 * p.y};
  }
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

Ring hairbrush(Random& random, int bristles) {
  Ring ring{{0, -2}, {static_cast<double>(bristles), -2}};
  for (int k = bristles - 1; k >= 0; --k) {
    const double x = k + 0.5;
    const double tip = x + test::uniform(random, -400, 400) / 1000.0;
    const double length = test::uniform(random, 5000, 50000) / 1000.0;
    ring.insert(ring.end(), {{x + 0.05, 0}, {tip, length}, {x - 0.05, 0}});
  }
  return ring;
}

namespace {

// The outline of a branch, from the right to the left of its root.
void grow(Random& random, Ring& ring, const Point& root, double angle, double length, int levels) {
  const double turned = angle + test::uniform(random, -50, 50) / 1000.0;
  const Point ahead = at_angle(turned, 1);
  const Point tip{root.x + length * ahead.x, root.y + length * ahead.y};
  if (levels == 0) {
    ring.push_back(tip);
    return;
  }
  const double half = 0.02 * length;
  ring.push_back({tip.x + half * ahead.y, tip.y - half * ahead.x});
  grow(random, ring, tip, turned - 0.9, 0.55 * length, levels - 1);
  ring.push_back({tip.x + half * ahead.x, tip.y + half * ahead.y});
  grow(random, ring, tip, turned + 0.9, 0.55 * length, levels - 1);
  ring.push_back({tip.x - half * ahead.y, tip.y + half * ahead.x});
}

}  // namespace

Ring forked_tree(Random& random, int levels) {
  Ring ring{{-2, 0}, {2, 0}};
  grow(random, ring, {0, 0}, std::numbers::pi / 2, 100, levels);
  return ring;
}

Ring sunburst(int arms, int pieces) {
  Ring ring;
  for (int k = 0; k < arms; ++k) {
    for (int j = -pieces; j <= pieces; ++j) {
      const double out = 1 - std::abs(j) / static_cast<double>(pieces);  // 1 at the tip
      const double side = (j < 0 ? -0.25 : 0.25) * (1 - out);
      ring.push_back(at_angle(2 * std::numbers::pi * (k + side) / arms + 1.5 * out, 10 + 90 * out));
    }
  }
  return ring;
}

Ring wire(Random& random, int steps) {
  Ring ring;
  Ring upper;
  double y = 0;
  for (int k = 0; k <= steps; ++k) {
    ring.push_back({static_cast<double>(k), y});
    upper.push_back({static_cast<double>(k), y + 0.125});
    y += test::uniform(random, -5000, 5000) / 1000.0;
  }
  ring.insert(ring.end(), upper.rbegin(), upper.rend());
  return ring;
}

Ring gear(int teeth) {
  Ring ring;
  for (int k = 0; k < teeth; ++k) {
    for (const auto& [part, radius] : {Point{0, 90}, {0.15, 100}, {0.4, 100}, {0.55, 90}}) {
      ring.push_back(at_angle(2 * std::numbers::pi * (k + part) / teeth, radius));
    }
  }
  return ring;
}

Ring saw(int teeth) {
  Ring ring{{0, -5}, {static_cast<double>(teeth), -5}};
  for (int k = teeth; k > 0; --k) {
    ring.insert(ring.end(), {{static_cast<double>(k), 0}, {k - 1.0, 3}});
  }
  return ring;
}

Ring plate(int holes_in_a_row) {
  constexpr double half_slit = 0x1p-7;
  const double size = 2.0 * holes_in_a_row + 1;
  Ring ring{{0, 0}, {size, 0}};
  for (int row = 0; row < holes_in_a_row; ++row) {
    const double middle = 2 * row + 1.5;
    Ring lower{{size, middle - half_slit}};
    for (int k = holes_in_a_row - 1; k >= 0; --k) {
      const double left = 2 * k + 1;
      lower.insert(
          lower.end(),
          {{left + 1, middle - half_slit}, {left + 1, middle - 0.5}, {left, middle - 0.5}});
      if (k > 0) {
        lower.push_back({left, middle - half_slit});
      }
    }
    Ring upper(lower.rbegin(), lower.rend());
    for (Point& p : upper) {
      p.y = 2 * middle - p.y;
    }
    ring.insert(ring.end(), lower.begin(), lower.end());
    ring.insert(ring.end(), upper.begin(), upper.end());
  }
  ring.insert(ring.end(), {{size, size}, {0, size}});
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
