// SPDX-License-Identifier: LGPL-3.0-or-later
//
// fma() in software against that of the C library: products with their own rounding error, sums
// near ties, numbers of all sizes.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "software_fma.hpp"

namespace gcv {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void expect_same(double x, double y, double z) {
  const double wanted = std::fma(x, y, z);
  for (const double got : {fma_by_integers(x, y, z), software_fma(x, y, z)}) {
    EXPECT_TRUE(std::isnan(wanted)
                    ? std::isnan(got)
                    : std::bit_cast<std::uint64_t>(got) == std::bit_cast<std::uint64_t>(wanted))
        << x << " * " << y << " + " << z << " is " << wanted << ", not " << got;
  }
}

TEST(Fma, OfSpecialNumbers) {
  const double numbers[] = {0.0,       -0.0,     1,        -1,        0x1p-1074,   -0x1p-1074,
                            0x1p-537,  0x1p1023, 0x1p-600, 0x1p512,   0.1,         0x1p-480,
                            0x1.fp990, 0x1.8p9,  infinity, -infinity, std::nan("")};
  for (const double x : numbers) {
    for (const double y : numbers) {
      for (const double z : numbers) {
        expect_same(x, y, z);
      }
    }
  }
}

TEST(Fma, OfRandomNumbers) {
  std::mt19937_64 random(20261126);
  const auto number = [&](int most) {
    const auto mantissa = static_cast<double>(static_cast<std::int64_t>(random()) >> 10);
    const auto exponents = static_cast<unsigned>(2 * most);
    return std::ldexp(mantissa, static_cast<int>(random() % exponents) - most - 53);
  };
  for (int k = 0; k < 300000; ++k) {
    const int most = k % 2 == 0 ? 20 : 1060;
    const double x = number(most);
    const double y = number(most);
    const double z = number(most);
    expect_same(x, y, z);
    expect_same(x, y, -(x * y));
    expect_same(x, y, std::nextafter(-(x * y), infinity));
    expect_same(x, y, std::ldexp(-(x * y), 1));
    const double quotient = z / y;
    expect_same(-quotient, y, z);
    expect_same(x, y, std::ldexp(-(x * y), 53 + k % 5));
  }
}

}  // namespace
}  // namespace gcv
