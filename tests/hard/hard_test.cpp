// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The invariants on the catalogue of hard cases.
#include <gtest/gtest.h>

#include "catalogue.hpp"
#include "invariants.hpp"

namespace gcv::hard {
namespace {

class Hard : public ::testing::TestWithParam<Family> {};

std::string describe(const Polygon& polygon) {
  return polygon.size() > 200 ? std::to_string(polygon.size()) + " vertices"
                              : invariants::wkt(polygon);
}

TEST_P(Hard, KeepsTheInvariants) {
  const Pairs pairs = GetParam().pairs();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto& [a, b] = pairs[k];
    for (const std::string& sentence : invariants::broken_invariants(a, b, GetParam().effort)) {
      ADD_FAILURE() << "pair " << k << ": " << sentence << "\nA = " << describe(a)
                    << "\nB = " << describe(b);
    }
  }
}

std::string name(const ::testing::TestParamInfo<Family>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(fits, Hard, ::testing::ValuesIn(fits()), name);
INSTANTIATE_TEST_SUITE_P(directions, Hard, ::testing::ValuesIn(directions()), name);
INSTANTIATE_TEST_SUITE_P(coincidences, Hard, ::testing::ValuesIn(coincidences()), name);
INSTANTIATE_TEST_SUITE_P(curves, Hard, ::testing::ValuesIn(curves()), name);
INSTANTIATE_TEST_SUITE_P(magnitudes, Hard, ::testing::ValuesIn(magnitudes()), name);

}  // namespace
}  // namespace gcv::hard
