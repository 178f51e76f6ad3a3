// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The rings of regions against unions of convex sums, as fractions: random cases full of ties, and
// pairs with many holes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

#include "case_options.hpp"
#include "decomposition_reference.hpp"
#include "error.hpp"
#include "region_families.hpp"
#include "regions.hpp"

namespace gcv {
namespace {

using test::Random;
using test::RegionCase;

test::CaseOptions chosen{100, 11};

// Compares `count` cases.
void expect_agreement_on(int count, std::uint64_t seed, RegionCase (*next_case)(Random&)) {
  Random random(seed);
  std::size_t holes = 0;
  for (int k = 0; k < count; ++k) {
    const RegionCase c = next_case(random);
    const Region region =
        c.inner_fit ? test::fit_region(c.a, c.b, c.shift) : test::sum_region(c.a, c.b, c.shift);
    ASSERT_EQ(test::ring_texts(region.exact), c.inner_fit
                                                  ? reference::rings_of_inner_fit(c.a, c.b, c.shift)
                                                  : reference::rings_of_sum(c.a, c.b, c.shift))
        << "case " << k;
    holes += test::hole_count(region.exact);
  }
  std::printf("%d cases, seed %llu: %zu holes\n", count, static_cast<unsigned long long>(seed),
              holes);
}

class RegionRings : public ::testing::TestWithParam<test::RegionFamily> {};

TEST_P(RegionRings, AreThoseOfTheUnion) {
  expect_agreement_on(chosen.cases, chosen.seed, GetParam().next_case);
}

INSTANTIATE_TEST_SUITE_P(Families, RegionRings,
                         ::testing::ValuesIn(test::region_families().begin(),
                                             test::region_families().end()),
                         [](const auto& family) { return name_of_family(family); });

TEST(RegionRings, OfSpikyStars) {
  expect_agreement_on(15, 12, [](Random& random) {
    const auto star = [&] {
      return test::random_spiky_star(random, test::uniform(random, 10, 24));
    };
    return RegionCase{{star()}, {star()}};
  });
}

// A plate with a hole in most cells of a grid, many of which touch, and a small polygon.
RegionCase random_plate(Random& random) {
  constexpr int cells = 5;
  constexpr int size = 4;
  constexpr double width = cells * size + 1;
  test::Rings plate{{{-1, -1}, {width, -1}, {width, width}, {-1, width}}};
  for (int k = 0; k < cells * cells; ++k) {
    test::Rings with_hole = plate;
    with_hole.push_back(
        test::random_small_integer_polygon(random, test::uniform(random, 3, 7), size));
    for (Point& p : with_hole.back()) {
      p = {p.x + size * (k % cells), p.y + size * (k / cells)};
    }
    try {
      static_cast<void>(make_polygon(with_hole, "plate"));
    } catch (const Error&) {
      continue;  // the hole overlaps an edge of another one
    }
    plate = std::move(with_hole);
  }
  test::Ring part = test::random_small_integer_polygon(random, test::uniform(random, 3, 4), 2);
  for (Point& p : part) {
    p = {p.x / 4, p.y / 4};
  }
  return {plate, {part}, test::uniform(random, 0, 3) == 0};
}

TEST(RegionRings, OfPlates) { expect_agreement_on(30, 13, random_plate); }

}  // namespace
}  // namespace gcv

int main(int argc, char** argv) { return gcv::test::run_with(gcv::chosen, argc, argv); }
