// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Directions that doubles cannot tell apart, or that are all the same.
#include <cmath>

#include "catalogue.hpp"
#include "shapes.hpp"

namespace gcv::hard {

namespace {

// Angles of 1e-16 between edges that would be parallel.
Pairs near_parallel_edges() {
  Random random(11);
  const auto nudged = [&](Polygon polygon) {
    for (auto& [x, y] : polygon) {
      x += std::ldexp(uniform(random, -2, 2), -48);
      y += std::ldexp(uniform(random, -2, 2), -48);
    }
    return polygon;
  };
  Pairs pairs;
  for (const Polygon& shape : small_shapes()) {
    for (int k = 0; k < 6; ++k) {
      const Polygon a = nudged(shape);
      pairs.push_back({a, nudged(k % 2 == 0 ? shape : negated(shape))});
    }
  }
  return pairs;
}

// Shapes squeezed onto a diagonal, one of them tiny: spikes and slits of 1e-12 radians,
// most of which rounding closes.
Pairs squeezed_shapes() {
  Random random(14);
  Pairs pairs;
  for (int k = 0; k < 100; ++k) {
    const Map squeeze{1, 1, 1, 1 + std::ldexp(1.0, -uniform(random, 20, 42))};
    // One random number a statement: compilers evaluate arguments in different orders.
    const auto star = [&] {
      const int tip = uniform(random, 8, 12);
      const int diagonal_tip = uniform(random, 5, 9);
      return mapped(symmetric_star(tip, diagonal_tip, 1), squeeze);
    };
    const Polygon a = star();
    const int halvings = uniform(random, 0, 30);
    const Polygon b = scaled(star(), std::ldexp(1.0, -halvings));
    if (invariants::is_simple(a) && invariants::is_simple(b)) {
      pairs.insert(pairs.end(), {{a, b}, {moved(a, 512, 128), b}});
    }
  }
  return pairs;
}

// Quotients of successive Fibonacci numbers differ by less than the spacing of doubles,
// alternately upwards and downwards.
Pairs fibonacci_directions() {
  std::vector<Point> steps{{1, 1}};
  while (steps.size() < 38) {
    const auto [x, y] = steps.back();
    steps.push_back({y, x + y});
  }
  const auto strip = [&](std::size_t first, std::size_t stride, double width) {
    Polygon polygon{{0, 0}};
    for (std::size_t k = first; k < steps.size(); k += stride) {
      const auto [x, y] = polygon.back();
      polygon.push_back({x + steps[k][0], y + steps[k][1]});
    }
    for (std::size_t k = polygon.size(); k-- > 0;) {
      const auto [x, y] = polygon[k];
      polygon.push_back({x - width, y + width});
    }
    return polygon;
  };
  Pairs pairs;
  for (const std::size_t stride : {1U, 2U, 3U}) {
    for (const double width : {0.5, 1e6}) {
      const Polygon a = strip(20, 1, 2);
      const Polygon b = strip(24, stride, width);
      pairs.insert(pairs.end(), {{a, b}, {a, negated(b)}, {b, b}, {b, negated(b)}});
    }
  }
  return pairs;
}

// All edges merge, and a descent by boxes has nothing to go by.
Pairs identical_regular_polygons() {
  const Polygon a = circle(25000);
  return {{a, a}};
}

// As the above, but small enough to be checked completely, and turned a little.
Pairs regular_polygons() {
  Random random(12);
  Pairs pairs;
  for (const int quarter : {1, 3, 25, 100}) {
    const Polygon a = circle(quarter);
    pairs.insert(pairs.end(), {{a, a}, {a, negated(a)}, {a, mapped(a, random_rotation(random))}});
  }
  return pairs;
}

// Every edge is parallel to half of all the others.
Pairs two_directions() {
  Random random(13);
  Pairs pairs;
  for (int k = 0; k < 30; ++k) {
    const Map map = k % 3 == 0 ? Map{} : k % 3 == 1 ? Map{3, 1, -1, 2} : random_rotation(random);
    const Polygon a = mapped(histogram(random, uniform(random, 2, 12), 9), map);
    const Polygon b = mapped(histogram(random, uniform(random, 2, 12), 9), map);
    pairs.insert(pairs.end(), {{a, b}, {a, negated(b)}});
  }
  return pairs;
}

// An aspect of 1e15.
Pairs needles() {
  const double far = 1e15;
  const std::vector<Polygon> shapes{
      {{0, 0}, {far, 0.5}, {far, 1}},
      {{0, 0}, {far, far}, {far - 0.125, far + 0.125}},
      {{0, 0}, {1, 0}, {0.5, far}},
      {{0, 0}, {far, -0.125}, {1, 0.5}, {0.5, far}},
      {{1, 0}, {far, 1}, {0, 1}, {1, far}, {-1, 0.5}, {-far, -1}, {0, -1}, {-1, -far}}};
  Pairs pairs;
  for (const Polygon& a : shapes) {
    for (const Polygon& b : shapes) {
      pairs.insert(pairs.end(), {{a, b}, {a, negated(b)}});
    }
  }
  return pairs;
}

}  // namespace

std::vector<Family> directions() {
  return {{"near_parallel_edges", near_parallel_edges},
          {"squeezed_shapes", squeezed_shapes, {.may_be_out_of_range = true}},
          {"fibonacci_directions", fibonacci_directions},
          {"identical_regular_polygons", identical_regular_polygons},
          {"regular_polygons", regular_polygons},
          {"two_directions", two_directions},
          {"needles", needles}};
}

}  // namespace gcv::hard
