// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Regions against their definition: rings, segments and points as text, on random cases full of
// ties. The reference knows nothing of supersets, witnesses or walks.
#include "region_reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>

#include "case_options.hpp"
#include "region_families.hpp"
#include "regions.hpp"

namespace gcv {
namespace {

test::CaseOptions chosen{200};

Region region_of(const test::RegionCase& c, const RegionOptions& options = {}) {
  return c.inner_fit ? test::fit_region(c.a, c.b, c.shift, options)
                     : test::sum_region(c.a, c.b, c.shift, options);
}

std::string reference_of(const test::RegionCase& c) {
  return reference::text(c.inner_fit ? reference::inner_fit_region(c.a, c.b, c.shift)
                                     : reference::sum_region(c.a, c.b, c.shift));
}

class Regions : public ::testing::TestWithParam<test::RegionFamily> {};

TEST_P(Regions, AreThoseOfTheDefinition) {
  test::Random random(chosen.seed);
  std::size_t holes = 0;
  std::size_t fits = 0;
  for (int k = 0; k < chosen.cases; ++k) {
    const test::RegionCase c = GetParam().next_case(random);
    const Region region = region_of(c);
    ASSERT_EQ(test::text_of(region.exact), reference_of(c)) << "case " << k;
    ASSERT_NO_THROW(static_cast<void>(test::rounded_polygons(region.rounded))) << "case " << k;
    for (const RegionPart& part : region.exact.parts) {
      holes += part.kind == PartKind::hole ? 1U : 0U;
      fits += part.is_ring() ? 0U : 1U;
    }
  }
  std::printf("%d cases, seed %llu: %zu holes, %zu fits\n", chosen.cases,
              static_cast<unsigned long long>(chosen.seed), holes, fits);
}

INSTANTIATE_TEST_SUITE_P(Families, Regions,
                         ::testing::ValuesIn(test::region_families().begin(),
                                             test::region_families().end()),
                         [](const auto& family) { return name_of_family(family); });

}  // namespace
}  // namespace gcv

int main(int argc, char** argv) { return gcv::test::run_with(gcv::chosen, argc, argv); }
