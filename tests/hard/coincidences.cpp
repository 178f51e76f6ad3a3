// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Ties: points on lines, lines on lines, and what misses being one by very little.
#include <cmath>

#include "catalogue.hpp"
#include "shapes.hpp"

namespace gcv::hard {

namespace {

// Thousands of superset edges overlap on a few lines.
Pairs collinear_overlaps() {
  Pairs pairs;
  for (const int teeth : {30, 100}) {
    const Polygon a = comb(teeth, 1, 1, 7);
    pairs.insert(pairs.end(), {{a, a}, {a, negated(a)}, {a, mapped(a, {0, -1, 1, 0})}});
  }
  return pairs;
}

// On an axis of symmetry, edges cross in threes and fours, with a vertex among them.
Pairs edges_through_one_point() {
  Random random(21);
  Pairs pairs;
  for (int k = 0; k < 40; ++k) {
    const auto star = [&] {
      const int valley = uniform(random, 1, 3);
      const int diagonal = uniform(random, 2 * valley, 12);
      return symmetric_star(uniform(random, 3 * valley, 16), diagonal, valley);
    };
    const Polygon a = star();
    pairs.insert(pairs.end(), {{a, star()}, {a, scaled(a, 2)}, {a, rectangle(2, 2)}});
  }
  return pairs;
}

// On a small grid every other junction is a tie.
Pairs small_grids() {
  Random random(22);
  Pairs pairs;
  for (int k = 0; k < 300; ++k) {
    const int extent = uniform(random, 2, 5);
    const Polygon a = random_on_grid(random, uniform(random, 3, 7), extent);
    pairs.push_back({a, random_on_grid(random, uniform(random, 3, 7), extent)});
  }
  return pairs;
}

// One polygon on even integers beyond 2^53, the other on small odd ones: sums lie half a
// unit in the last place from doubles, and from edges.
Pairs half_an_ulp() {
  Random random(23);
  const double far = std::ldexp(1.0, 53);
  Pairs pairs;
  for (int k = 0; k < 100; ++k) {
    const Polygon a = random_on_grid(random, uniform(random, 3, 7), 4);
    const Polygon b = random_on_grid(random, uniform(random, 3, 7), 4);
    const Polygon odd = moved(scaled(b, 2), 1, 1);
    pairs.push_back({moved(scaled(a, 2), far, far), odd});
    // The same beside 1, where each sum differs from the next by half a unit.
    pairs.push_back({moved(scaled(a, std::ldexp(1.0, -52)), 1, 1), scaled(odd, 0x1p-53)});
  }
  return pairs;
}

}  // namespace

std::vector<Family> coincidences() {
  return {{"collinear_overlaps", collinear_overlaps},
          {"edges_through_one_point", edges_through_one_point},
          {"small_grids", small_grids},
          {"half_an_ulp", half_an_ulp}};
}

}  // namespace gcv::hard
