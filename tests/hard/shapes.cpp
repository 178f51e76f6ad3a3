// SPDX-License-Identifier: LGPL-3.0-or-later
#include "shapes.hpp"

#include <cstdint>
#include <set>
#include <utility>

namespace gcv::hard {

int uniform(Random& random, int low, int high) {
  const auto count = static_cast<std::uint64_t>(high - low) + 1;
  return low + static_cast<int>(random() % count);
}

Polygon mapped(Polygon polygon, const Map& map) {
  for (auto& [x, y] : polygon) {
    const double old_x = x;
    x = map.xx * old_x + map.xy * y + map.x0;
    y = map.yx * old_x + map.yy * y + map.y0;
  }
  return polygon;
}

Polygon negated(const Polygon& polygon) { return scaled(polygon, -1); }

Polygon scaled(const Polygon& polygon, double factor) {
  return mapped(polygon, {factor, 0, 0, factor});
}

Polygon moved(const Polygon& polygon, double x, double y) {
  return mapped(polygon, {1, 0, 0, 1, x, y});
}

Map exact_rotation(int m, int n) {
  const double c = m * m - n * n;
  const double s = 2 * m * n;
  return {c, -s, s, c};
}

Map rotation(int m, int n) {
  Map map = exact_rotation(m, n);
  const double r = m * m + n * n;
  for (double* const entry : {&map.xx, &map.xy, &map.yx, &map.yy}) {
    *entry /= r;
  }
  return map;
}

Map random_rotation(Random& random) {
  const int m = uniform(random, 2, 1000);
  return rotation(m, uniform(random, 1, m - 1));
}

Polygon rectangle(double width, double height) {
  return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

Polygon block_with(const Slot& slot) {
  const double neck = slot.neck_width;
  const double margin = (slot.chamber_width - slot.neck_width) / 2.0;
  const double x = 3 + margin;
  const double top = 3 + slot.chamber_depth + slot.neck_depth;
  const double shoulder = 3 + slot.chamber_depth;
  const double width = 6 + slot.chamber_width;
  return {{0, 0},
          {width, 0},
          {width, top},
          {x + neck, top},
          {x + neck, shoulder},
          {x + neck + margin, shoulder},
          {x + neck + margin, 3},
          {3, 3},
          {3, shoulder},
          {x, shoulder},
          {x, top},
          {0, top}};
}

Polygon key_of(const Slot& slot) {
  const double width = slot.chamber_width;
  const double margin = (slot.chamber_width - slot.neck_width) / 2.0;
  const double shoulder = slot.chamber_depth;
  const double top = shoulder + slot.neck_depth;
  return {{0, 0},
          {width, 0},
          {width, shoulder},
          {width - margin, shoulder},
          {width - margin, top},
          {margin, top},
          {margin, shoulder},
          {0, shoulder}};
}

Slot random_slot(Random& random) {
  const int neck = uniform(random, 1, 9);
  return {neck, uniform(random, 1, 20), neck + uniform(random, 0, 20), uniform(random, 1, 20)};
}

std::pair<Polygon, Polygon> rotated_slot(Random& random, int k) {
  const Slot slot = random_slot(random);
  const Slot straight{slot.neck_width, slot.neck_depth, slot.neck_width, 1};
  const Polygon block = block_with(k % 3 == 0 ? straight : slot);
  const Polygon part = k % 3 == 1
                           ? key_of(slot)
                           : rectangle(slot.neck_width, uniform(random, 1, slot.chamber_depth));
  const Map turn = random_rotation(random);
  return {mapped(block, turn), negated(mapped(part, turn))};
}

Polygon comb(int teeth, double width, double gap, double height) {
  Polygon polygon{{0, -1}, {(teeth - 1) * (width + gap) + width, -1}};
  for (int k = teeth - 1; k >= 0; --k) {
    const double x = k * (width + gap);
    polygon.push_back({x + width, height});
    polygon.push_back({x, height});
    if (k > 0) {
      polygon.push_back({x, 0});
      polygon.push_back({x - gap, 0});
    }
  }
  return polygon;
}

Polygon square_spiral(int turns) {
  Polygon outer;
  Polygon inner;
  double low = 0;
  double high = 4.0 * turns;
  for (int k = 0; k < turns; ++k) {
    outer.insert(outer.end(), {{low, low}, {high, low}, {high, high}, {low + 2, high}});
    inner.insert(
        inner.end(),
        {{low + 1, low + 1}, {high - 1, low + 1}, {high - 1, high - 1}, {low + 3, high - 1}});
    low += 2;
    high -= 2;
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

Polygon histogram(Random& random, int columns, int extent) {
  Polygon polygon{{0, 0}};
  double x = 0;
  for (int k = 0; k < columns; ++k) {
    const double height = uniform(random, 1, extent);
    polygon.push_back({x, height});
    x += uniform(random, 1, 3);
    polygon.push_back({x, height});
  }
  polygon.push_back({x, 0});
  return polygon;
}

Polygon symmetric_star(int tip, int diagonal_tip, int valley) {
  const double t = tip;
  const double d = diagonal_tip;
  const double v = valley;
  Polygon polygon;
  for (const Map& turn : {Map{1, 0, 0, 1}, Map{0, -1, 1, 0}, Map{-1, 0, 0, -1}, Map{0, 1, -1, 0}}) {
    const Polygon quarter = mapped({{t, 0}, {2 * v, v}, {d, d}, {v, 2 * v}}, turn);
    polygon.insert(polygon.end(), quarter.begin(), quarter.end());
  }
  return polygon;
}

Polygon circle(int quarter) {
  Polygon polygon;
  for (int turn = 0; turn < 4; ++turn) {
    for (int k = 0; k < quarter; ++k) {
      const double t = static_cast<double>(k) / quarter;
      const double x = (1 - t * t) / (1 + t * t);
      const double y = 2 * t / (1 + t * t);
      const Point turns[] = {{x, y}, {-y, x}, {-x, -y}, {y, -x}};
      polygon.push_back(turns[turn]);
    }
  }
  return polygon;
}

Polygon random_star(Random& random, int quarter) {
  Polygon polygon = circle(quarter);
  for (auto& [x, y] : polygon) {
    const double radius = uniform(random, 100, 1000) / 10.0;
    x *= radius;
    y *= radius;
  }
  return polygon;
}

Polygon spiky_star(Random& random, int quarter) {
  Polygon polygon = circle(quarter);
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const double radius = (k % 2 == 0 ? 50 : 10) + uniform(random, 0, 200) / 10.0;
    polygon[k] = {polygon[k][0] * radius, polygon[k][1] * radius};
  }
  return polygon;
}

Polygon random_on_grid(Random& random, int vertices, int extent) {
  while (true) {
    std::set<Point> places;
    while (static_cast<int>(places.size()) < vertices) {
      const double x = uniform(random, 0, extent);
      places.insert({x, static_cast<double>(uniform(random, 0, extent))});
    }
    Polygon polygon(places.begin(), places.end());
    for (std::size_t k = polygon.size() - 1; k > 0; --k) {
      std::swap(polygon[k], polygon[static_cast<std::size_t>(random() % (k + 1))]);
    }
    if (invariants::is_simple(polygon)) {
      return polygon;
    }
  }
}

std::vector<Polygon> small_shapes() {
  Random random(100);
  const Slot slot{2, 3, 6, 4};
  return {rectangle(2, 3),
          {{0, 0}, {5, 1}, {2, 4}},
          block_with(slot),
          key_of(slot),
          comb(4, 1, 2, 5),
          histogram(random, 5, 6),
          symmetric_star(12, 9, 2),
          random_on_grid(random, 7, 6),
          random_on_grid(random, 8, 5)};
}

}  // namespace gcv::hard
