// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Turned slots, T-slots and pockets, and the parts that fit them exactly: how often nearest
// doubles alone do not form a simple ring, and that the library's results always do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "invariants.hpp"
#include "shapes.hpp"

namespace gcv::hard {
namespace {

// In units in the last place of the largest coordinate.
double error_in_ulps(const invariants::Rounded& sum) {
  double largest = 0;
  for (const auto& [x, y] : sum.returned) {
    largest = std::max({largest, std::abs(x), std::abs(y)});
  }
  return sum.error_bound / (std::nextafter(largest, HUGE_VAL) - largest);
}

TEST(RotatedSlots, AreSimple) {
  Random random(51);
  int naive_failures = 0;
  int failures = 0;
  double largest_error = 0;
  const int count = 10000;
  for (int k = 0; k < count; ++k) {
    const auto [a, b] = rotated_slot(random, k);
    const invariants::Rounded sum = invariants::rounded_sum(a, b);
    naive_failures += invariants::is_simple(sum.naive) ? 0 : 1;
    if (!invariants::is_simple(sum.returned)) {
      ++failures;
      ADD_FAILURE() << "A = " << invariants::wkt(a) << "\nB = " << invariants::wkt(b);
    }
    largest_error = std::max(largest_error, error_in_ulps(sum));
  }
  std::printf("%d sums: %d not simple (rounded naively: %d); error at most %.3g ulps\n", count,
              failures, naive_failures, largest_error);
  EXPECT_GT(naive_failures, 0);
  EXPECT_LE(largest_error, 8);
}

}  // namespace
}  // namespace gcv::hard
