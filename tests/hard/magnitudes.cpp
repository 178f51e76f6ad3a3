// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Doubles are finite in number and uneven: what fits one size does not fit another.
#include <cmath>
#include <limits>

#include "catalogue.hpp"
#include "shapes.hpp"

namespace gcv::hard {

namespace {

using Transform = Polygon (*)(const Polygon&);

Pairs pairs_of(Transform first, Transform second) {
  Random random(41);
  Pairs pairs;
  for (const Polygon& shape : small_shapes()) {
    for (const Polygon& other : small_shapes()) {
      pairs.push_back({first(shape), second(other)});
    }
    const Map turn = random_rotation(random);
    const Polygon turned = mapped(shape, turn);
    pairs.push_back({first(turned), second(negated(turned))});
  }
  return pairs;
}

Polygon as_it_is(const Polygon& shape) { return shape; }

// Shoelace areas in doubles have the wrong sign here.
Pairs far_from_the_origin() {
  const Transform far = [](const Polygon& shape) { return moved(shape, 1e15, -3e14); };
  Pairs pairs = pairs_of(far, far);
  const Pairs others = pairs_of(far, as_it_is);
  pairs.insert(pairs.end(), others.begin(), others.end());
  return pairs;
}

// Detail of the sum that is finer than the doubles there: many vertices share a place, and
// walls that cannot be told apart fall onto each other.
Pairs detail_below_an_ulp() {
  Random random(43);
  Pairs pairs;
  for (const Polygon& shape : small_shapes()) {
    const Polygon far[] = {
        moved(mapped(shape, random_rotation(random)), 1e15, -3e14),
        moved(scaled(mapped(shape, random_rotation(random)), 0.1), 0x1p49, -0x1p47),
        moved(mapped(shape, {1, 1, 1, 1 + 0x1p-36}), 0x1p16, 0.25)};
    for (const Polygon& other : small_shapes()) {
      for (const double size : {0.2, 0.03, 0.005, 0x1p-50}) {
        const Polygon tiny = scaled(mapped(other, random_rotation(random)), size);
        for (const Polygon& a : far) {
          if (invariants::is_simple(a)) {
            pairs.push_back({a, tiny});
          }
        }
      }
    }
  }
  return pairs;
}

// Features of 1e-9 on parts of 1e9.
Pairs tiny_next_to_huge() {
  Pairs pairs;
  for (const Polygon& shape : small_shapes()) {
    // The shape as the upper left end of a part: below it and right of it all is huge.
    const Polygon tiny = scaled(shape, 1e-9);
    const Polygon part{{0, 0}, {1e9, -1e9}, {1e9, 1e9}, {1e-9, 2e-9}, {2e-9, 1e-9}, {-1e-9, 1e-9}};
    pairs.insert(pairs.end(), {{part, tiny}, {part, negated(tiny)}, {tiny, scaled(shape, 1e9)}});
    for (const Polygon& other : small_shapes()) {
      pairs.push_back({scaled(other, 1e9), tiny});
    }
  }
  return pairs;
}

// Products of these need 106 bits, and comparisons of crossings 200 and more.
Pairs integers_of_52_bits() {
  Random random(42);
  const auto large = [&](Polygon polygon) {
    for (auto& [x, y] : polygon) {
      x = x * 0x1p49 + static_cast<double>(random() >> 16);
      y = y * 0x1p49 + static_cast<double>(random() >> 16);
    }
    return polygon;
  };
  Pairs pairs;
  for (int k = 0; k < 100; ++k) {
    const Polygon a = large(random_on_grid(random, uniform(random, 3, 6), 7));
    const Polygon b = large(random_on_grid(random, uniform(random, 3, 6), 7));
    if (invariants::is_simple(a) && invariants::is_simple(b)) {
      pairs.insert(pairs.end(), {{a, b}, {a, negated(a)}});
    }
  }
  return pairs;
}

// Below the normal doubles, where products vanish.
Pairs subnormal() {
  const Transform small = [](const Polygon& shape) {
    Polygon polygon = shape;
    for (auto& [x, y] : polygon) {
      x = std::nearbyint(4 * x) * std::numeric_limits<double>::denorm_min();
      y = std::nearbyint(4 * y) * std::numeric_limits<double>::denorm_min();
    }
    return polygon;
  };
  return pairs_of(small, small);
}

// Squares overflow.
Pairs of_1e150() {
  const Transform large = [](const Polygon& shape) { return scaled(shape, 1e150); };
  return pairs_of(large, large);
}

// All products overflow.
Pairs of_1e300() {
  const Transform large = [](const Polygon& shape) { return scaled(shape, 1e300); };
  return pairs_of(large, large);
}

// The largest doubles: sums of coordinates may or may not be finite.
Pairs at_the_end_of_the_range() {
  const Transform large = [](const Polygon& shape) { return scaled(shape, 0x1p1019); };
  return pairs_of(large, large);
}

// All products underflow.
Pairs of_1e_300() {
  const Transform small = [](const Polygon& shape) { return scaled(shape, 1e-300); };
  return pairs_of(small, small);
}

// All sizes in one polygon: bits from 1 to 2000.
Pairs mixed() {
  const std::vector<Polygon> shapes{
      {{0, 0}, {1e300, 1e-300}, {1e-300, 1e300}},
      {{1e-300, 1e-300}, {1e300, 0}, {1e150, 1e150}, {1, 1}, {1e-150, 1e300}},
      {{0, 0}, {1e-300, -1e-300}, {1e300, -1e-300}, {1, 1}, {1e-310, 1e-5}},
      {{-1e-300, 0}, {0, -1}, {1e10, 0}, {0, 1e300}},
      {{0, 0}, {5e-324, 0}, {1, 1e200}}};
  Pairs pairs;
  for (const Polygon& a : shapes) {
    for (const Polygon& b : shapes) {
      pairs.insert(pairs.end(), {{a, b}, {a, negated(b)}});
    }
    for (const Polygon& shape : small_shapes()) {
      pairs.insert(pairs.end(),
                   {{a, shape}, {a, scaled(shape, 1e-300)}, {scaled(shape, 1e290), a}});
    }
  }
  return pairs;
}

}  // namespace

std::vector<Family> magnitudes() {
  return {{"far_from_the_origin", far_from_the_origin},
          {"detail_below_an_ulp", detail_below_an_ulp, {.may_be_out_of_range = true}},
          {"tiny_next_to_huge", tiny_next_to_huge},
          {"integers_of_52_bits", integers_of_52_bits},
          {"subnormal", subnormal},
          {"of_1e150", of_1e150},
          {"of_1e300", of_1e300},
          {"at_the_end_of_the_range", at_the_end_of_the_range, {.may_be_out_of_range = true}},
          {"of_1e_300", of_1e_300},
          {"mixed", mixed}};
}

}  // namespace gcv::hard
