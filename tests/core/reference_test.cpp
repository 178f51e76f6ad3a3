// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The walk against two references, vertex for vertex as fractions: the arrangement of
// the explicit superset (the paper's way 2), and CGAL's own reduced convolution.
#include "reference.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <memory>

#include "data.hpp"
#include "generators.hpp"
#include "minkowski_sum.hpp"
#include "polygon.hpp"
#include "wkt.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Ring;

reference::FractionRing walked(const Polygon& a, const Polygon& b) {
  Tally tally;
  Task task;
  Walk walk = walk_outer_face(a, b, task, tally);
  const ExactRing ring{{std::make_shared<Polygon>(a), "a"},
                       {std::make_shared<Polygon>(b), "b"},
                       {0, 0},
                       std::move(walk.vertices)};
  reference::FractionRing fractions;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    fractions.push_back(exact_vertex(ring, k));
  }
  return fractions;
}

std::string describe(const Ring& a, const Ring& b) {
  return "A = " + format_polygon(a) + "\nB = " + format_polygon(b);
}

void expect_agreement(const Ring& ring_a, const Ring& ring_b) {
  const Polygon a = make_polygon(ring_a, "a");
  const Polygon b = make_polygon(ring_b, "b");
  const reference::FractionRing ring = walked(a, b);
  ASSERT_EQ(ring, reference::arrangement_outer_face(superset(a, b))) << describe(ring_a, ring_b);
  ASSERT_EQ(ring, reference::reduced_convolution(a.vertices, b.vertices))
      << describe(ring_a, ring_b);
}

using Pair = std::pair<Ring, Ring>;

void expect_agreement_on(int count, std::uint64_t seed, const std::function<Pair(Random&)>& pair) {
  ::testing::Test::RecordProperty("pairs", count);
  std::printf("%d pairs, seed %llu\n", count, static_cast<unsigned long long>(seed));
  Random random(seed);
  for (int k = 0; k < count; ++k) {
    const auto [a, b] = pair(random);
    expect_agreement(a, b);
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

TEST(Reference, RealPairs) {
  const auto directory = test::data_directory();
  if (!directory) {
    GTEST_SKIP() << "no polygon data: set GCV_DATA_DIR";
  }
  int compared = 0;
  for (const test::NamedPair& pair : test::read_pairs(*directory)) {
    if (pair.a.size() < 300 && pair.b.size() < 300) {
      SCOPED_TRACE(pair.name);
      expect_agreement(pair.a, pair.b);
      ++compared;
    }
  }
  std::printf("%d real pairs\n", compared);
  EXPECT_GE(compared, 15);
}

}  // namespace
}  // namespace gcv
