// SPDX-License-Identifier: LGPL-3.0-or-later
#include "answer_sets.hpp"

#include <cstdio>

#include "data.hpp"
#include "generators.hpp"

namespace gcv::bench {

namespace {

// B reflected: sums become no-fit regions.
Set reflected(Set set) {
  for (Pair& pair : set.pairs) {
    pair.make = [make = pair.make] {
      const auto [a, b] = make();
      return Rings{a, test::negated(b)};
    };
  }
  return set;
}

}  // namespace

std::vector<Set> answer_sets(bool quick) {
  std::vector<Set> sets{region_ties(quick ? 3 : 30),
                        {.name = "turned slots", .pairs = rotated_slots(quick ? 10 : 100)}};
  if (const auto directory = test::data_directory()) {
    sets.push_back(lost_holes(*directory));
    Set real{.name = "real pairs"};
    for (const Set& set : blocks_of_pairs(*directory)) {
      real.pairs.insert(real.pairs.end(), set.pairs.begin(), set.pairs.end());
    }
    sets.push_back(real);
    sets.push_back(reflected(nesting(*directory, quick ? 10 : 100)));
  } else {
    std::fputs("The real pairs are left out: their folder is not there.\n", stderr);
  }
  return sets;
}

}  // namespace gcv::bench
