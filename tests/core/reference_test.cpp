// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The walk against two references, vertex for vertex as fractions: the arrangement of
// the explicit superset (the paper's way 2), and CGAL's own reduced convolution.
#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <utility>

#include "agreement.hpp"
#include "generators.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Ring;

using Pair = std::pair<Ring, Ring>;

void expect_agreement_on(int count, std::uint64_t seed, const std::function<Pair(Random&)>& pair) {
  ::testing::Test::RecordProperty("pairs", count);
  std::printf("%d pairs, seed %llu\n", count, static_cast<unsigned long long>(seed));
  Random random(seed);
  for (int k = 0; k < count; ++k) {
    const auto [a, b] = pair(random);
    reference::expect_agreement(a, b);
    if (::testing::Test::HasFatalFailure()) {
      return;
    }
  }
}

TEST(Reference, SmallIntegers) {
  expect_agreement_on(8000, 1, [](Random& random) {
    const int extent = test::uniform(random, 2, 8);
    const auto polygon = [&] {
      return test::random_small_integer_polygon(random, test::uniform(random, 3, 8), extent);
    };
    return Pair{polygon(), polygon()};
  });
}

TEST(Reference, Histograms) {
  expect_agreement_on(4000, 2, [](Random& random) {
    const auto polygon = [&] {
      return test::random_histogram(random, test::uniform(random, 1, 6), 5);
    };
    return Pair{polygon(), polygon()};
  });
}

TEST(Reference, SpikyStars) {
  expect_agreement_on(2000, 3, [](Random& random) {
    const auto polygon = [&] {
      return test::random_spiky_star(random, test::uniform(random, 3, 14));
    };
    return Pair{polygon(), polygon()};
  });
}

Ring random_tied(Random& random) {
  return test::uniform(random, 0, 1) == 0
             ? test::random_small_integer_polygon(random, test::uniform(random, 3, 9), 6)
             : test::random_histogram(random, test::uniform(random, 2, 6), 4);
}

TEST(Reference, WithItsReflection) {
  expect_agreement_on(3500, 4, [](Random& random) {
    const Ring a = random_tied(random);
    return Pair{a, test::negated(a)};
  });
}

TEST(Reference, WithItself) {
  expect_agreement_on(3500, 5, [](Random& random) {
    const Ring a = random_tied(random);
    return Pair{a, a};
  });
}

}  // namespace
}  // namespace gcv
