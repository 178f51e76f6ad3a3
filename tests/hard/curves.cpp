// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Boundaries that are long for the room that they take: trees of boxes overlap, and the
// outer face is a small part of the superset or nearly all of it.
#include <cmath>

#include "catalogue.hpp"
#include "shapes.hpp"

namespace gcv::hard {

namespace {

// With small parts that enter the curve and large ones that do not, and with itself.
Pairs with_others(const std::vector<Polygon>& curves) {
  Pairs pairs;
  for (const Polygon& curve : curves) {
    const Polygon part = scaled({{0, 0}, {3, 1}, {2, 3}, {1, 1}}, 0.0625);
    pairs.insert(
        pairs.end(),
        {{curve, part}, {curve, scaled(part, 8)}, {curve, curve}, {curve, negated(curve)}});
  }
  return pairs;
}

Polygon round_spiral(int vertices) {
  const Map turn = rotation(12, 1);
  Polygon outer;
  Polygon inner;
  Polygon direction{{1, 0}};
  for (int k = 0; k < vertices; ++k) {
    const double radius = 2 + k * 0.0625;
    const auto [x, y] = direction.front();
    outer.push_back({x * radius, y * radius});
    inner.push_back({x * (radius - 1), y * (radius - 1)});
    direction = mapped(direction, turn);
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

// All of the inside can be reached, but only along the whole curve.
Pairs spirals() {
  return with_others({square_spiral(2), square_spiral(12), round_spiral(100), round_spiral(200)});
}

// Edges of all sizes in six directions.
Pairs koch_curves() {
  std::vector<Polygon> curves;
  Polygon curve{{0, 0}, {243, 0}, {121.5, 243 * std::sqrt(0.75)}};
  for (int level = 0; level < 4; ++level) {
    Polygon finer;
    for (std::size_t k = 0; k < curve.size(); ++k) {
      const auto [x, y] = curve[k];
      const double dx = (curve[(k + 1) % curve.size()][0] - x) / 3;
      const double dy = (curve[(k + 1) % curve.size()][1] - y) / 3;
      const double h = std::sqrt(0.75);
      finer.insert(finer.end(), {{x, y},
                                 {x + dx, y + dy},
                                 {x + 1.5 * dx + h * dy, y + 1.5 * dy - h * dx},
                                 {x + 2 * dx, y + 2 * dy}});
    }
    curve = finer;
    curves.push_back(curve);
  }
  return with_others(curves);
}

// Moore's closed version of Hilbert's curve: it visits all points of a grid.
Polygon hilbert_curve(int level) {
  Polygon curve{{0, 0}};  // of one quarter, from its first corner to the next along x
  double size = 1;
  for (int k = 1; k < level; ++k, size *= 2) {
    Polygon finer;
    for (const Map& map :
         {Map{0, 1, 1, 0, 0, 0}, Map{1, 0, 0, 1, 0, size}, Map{1, 0, 0, 1, size, size},
          Map{0, -1, -1, 0, 2 * size - 1, size - 1}}) {
      const Polygon part = mapped(curve, map);
      finer.insert(finer.end(), part.begin(), part.end());
    }
    curve = finer;
  }
  Polygon closed;
  for (const Map& map : {Map{0, -1, 1, 0, size - 1, 0}, Map{0, -1, 1, 0, size - 1, size},
                         Map{0, 1, -1, 0, size, 2 * size - 1}, Map{0, 1, -1, 0, size, size - 1}}) {
    const Polygon part = mapped(curve, map);
    closed.insert(closed.end(), part.begin(), part.end());
  }
  return closed;
}

// Everything is near everything, in two directions, and on the grid lines.
Pairs hilbert_curves() {
  return with_others({hilbert_curve(2), hilbert_curve(3), hilbert_curve(4), hilbert_curve(5)});
}

// A thin strip that goes to and fro.
Pairs zigzags() {
  std::vector<Polygon> curves;
  for (const int corners : {10, 100, 400}) {
    Polygon upper;
    Polygon lower;
    for (int k = 0; k < corners; ++k) {
      const double y = k % 2 == 0 ? 0 : 40;
      upper.push_back({k * 1.0, y + 1});
      lower.push_back({k * 1.0, y});
    }
    lower.insert(lower.end(), upper.rbegin(), upper.rend());
    curves.push_back(lower);
  }
  return with_others(curves);
}

// Nearly all of the superset is a crowd of crossings within the sum.
Pairs spiky_stars() {
  Random random(9);
  const Polygon star = spiky_star(random, 80);
  const Polygon other = spiky_star(random, 70);
  return {{star, other}, {star, scaled(other, 0.125)}, {star, star}, {star, negated(star)}};
}

// A coast around a point, by halving and displacing: detail at all scales.
Polygon coast(Random& random, int level) {
  const int count = 1 << level;
  std::vector<double> radius(static_cast<std::size_t>(count), 100);
  for (int step = count; step > 1; step /= 2) {
    for (int k = 0; k < count; k += step) {
      const double ends = radius[static_cast<std::size_t>(k)] +
                          radius[static_cast<std::size_t>((k + step) % count)];
      const double roughness = 60.0 * step / count + 1.0;
      radius[static_cast<std::size_t>(k + step / 2)] =
          ends / 2 + uniform(random, -1000, 1000) / 1000.0 * roughness;
    }
  }
  Polygon polygon = circle(count / 4);
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    polygon[k] = {polygon[k][0] * radius[k], polygon[k][1] * radius[k]};
  }
  return polygon;
}

// Every step of the walk ends at a crossing.
Pairs fractal_coasts() {
  Random random(31);
  Pairs pairs = with_others({coast(random, 5), coast(random, 9)});
  const Polygon a = coast(random, 10);
  pairs.insert(pairs.end(), {{a, coast(random, 10)}, {a, coast(random, 6)}});
  return pairs;
}

}  // namespace

std::vector<Family> curves() {
  return {{"spirals", spirals}, {"koch_curves", koch_curves}, {"hilbert_curves", hilbert_curves},
          {"zigzags", zigzags}, {"spiky_stars", spiky_stars}, {"fractal_coasts", fractal_coasts}};
}

}  // namespace gcv::hard
