// SPDX-License-Identifier: LGPL-3.0-or-later
#include <string>
#include <utility>

#include "generators.hpp"
#include "region_families.hpp"
#include "sets.hpp"
#include "systems/whole.hpp"

namespace gcv::bench {

using test::uniform;

Set random_small_pairs(int count) {
  Set set{.name = "random small polygons"};
  test::Random random(7);
  const auto draw = [&] {
    const int vertices = uniform(random, 3, 12);
    return test::random_small_integer_polygon(random, vertices, uniform(random, 4, 20));
  };
  for (int k = 0; k < count; ++k) {
    const auto a = draw();
    const auto b = draw();
    set.pairs.push_back({std::to_string(k), [a, b] { return Rings{a, b}; }});
  }
  return set;
}

Set region_ties(int of_each_family) {
  constexpr int most_tries = 1000;
  Set set{.name = "ties"};
  for (const test::RegionFamily& family : test::region_families()) {
    test::Random random(2);
    int found = 0;
    for (int k = 0; k < most_tries && found < of_each_family; ++k) {
      const test::RegionCase drawn = family.next_case(random);
      if (drawn.inner_fit || drawn.a.size() != 1 || drawn.b.size() != 1) {
        continue;
      }
      const RegionSize size = libgcv_region_size(tidy(drawn.a.front()), tidy(drawn.b.front()));
      if (size.holes + size.fits > 0) {
        set.pairs.push_back({std::string(family.name) + " " + std::to_string(k),
                             [a = drawn.a.front(), b = drawn.b.front()] {
                               return Rings{a, b};
                             }});
        ++found;
      }
    }
  }
  return set;
}

}  // namespace gcv::bench
