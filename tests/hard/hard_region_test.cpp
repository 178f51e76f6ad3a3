// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The invariants of regions and of inner fits on the catalogue of hard cases.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "catalogue.hpp"
#include "invariants.hpp"
#include "region_operands.hpp"
#include "shapes.hpp"

namespace gcv::hard {
namespace {

class Regions : public ::testing::TestWithParam<Family> {};

TEST_P(Regions, KeepTheInvariants) {
  Effort effort = GetParam().effort;
  effort.work = 2000;
  const Pairs pairs = region_pairs(GetParam().pairs(), 40);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto& [a, b] = pairs[k];
    const Polygon moving = negated(b);
    std::vector<std::string> broken = invariants::broken_region_invariants(a, b, effort);
    for (const Polygon& other : {moving, scaled(moving, 0.125)}) {
      if (!invariants::is_simple(other)) {
        continue;
      }
      for (std::string& sentence : invariants::broken_fit_invariants(a, other, effort)) {
        broken.push_back(std::move(sentence));
      }
    }
    for (const std::string& sentence : broken) {
      ADD_FAILURE() << "pair " << k << ": " << sentence << "\nA = " << invariants::wkt(a)
                    << "\nB = " << invariants::wkt(b);
    }
  }
}

std::string name(const ::testing::TestParamInfo<Family>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(fits, Regions, ::testing::ValuesIn(fits()), name);
INSTANTIATE_TEST_SUITE_P(directions, Regions, ::testing::ValuesIn(directions()), name);
INSTANTIATE_TEST_SUITE_P(coincidences, Regions, ::testing::ValuesIn(coincidences()), name);
INSTANTIATE_TEST_SUITE_P(curves, Regions, ::testing::ValuesIn(curves()), name);
INSTANTIATE_TEST_SUITE_P(magnitudes, Regions, ::testing::ValuesIn(magnitudes()), name);

}  // namespace
}  // namespace gcv::hard
