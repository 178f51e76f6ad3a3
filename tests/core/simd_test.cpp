// SPDX-License-Identifier: LGPL-3.0-or-later
//
// SIMD vectors against the same operations on separate numbers.
#include "simd.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "generators.hpp"

namespace gcv {
namespace {

using test::Random;
using test::uniform;

constexpr int rounds = 1000;

// The lanes in which holds(lane), as bits.
template <class Holds>
unsigned bits_where(std::uint32_t width, Holds holds) {
  unsigned bits = 0;
  for (std::uint32_t lane = 0; lane < width; ++lane) {
    bits |= holds(lane) ? 1U << lane : 0U;
  }
  return bits;
}

// Few different numbers, so that many are equal; both zeros among them.
double some_double(Random& random) {
  constexpr double numbers[] = {-std::numeric_limits<double>::infinity(), -3, -0.0, 0, 0.5, 7};
  return numbers[uniform(random, 0, 5)];
}

// All of the range, and often its ends.
std::int16_t some_short(Random& random) {
  const int number = std::clamp(uniform(random, -40000, 40000), -0x8000, 0x7fff);
  return static_cast<std::int16_t>(number);
}

TEST(Simd, CompareDoubles) {
  Random random(1);
  for (int round = 0; round < rounds; ++round) {
    double p[SimdDouble::width];
    double q[SimdDouble::width];
    std::generate(std::begin(p), std::end(p), [&] { return some_double(random); });
    std::generate(std::begin(q), std::end(q), [&] { return some_double(random); });
    const double x = some_double(random);
    const auto bits = [](auto holds) { return bits_where(SimdDouble::width, holds); };
    const SimdDouble lanes = SimdDouble::load(p);
    const SimdDouble others = SimdDouble::load(q);
    EXPECT_EQ((lanes < others).bits(), bits([&](auto k) { return p[k] < q[k]; }));
    EXPECT_EQ((lanes > others).bits(), bits([&](auto k) { return p[k] > q[k]; }));
    EXPECT_EQ((lanes < x).bits(), bits([&](auto k) { return p[k] < x; }));
    EXPECT_EQ((lanes > x).bits(), bits([&](auto k) { return p[k] > x; }));
    EXPECT_EQ(((lanes > x) | (others > x)).bits(),
              bits([&](auto k) { return p[k] > x || q[k] > x; }));
    double sizes[SimdDouble::width];
    magnitude(lanes).store(sizes);
    for (std::uint32_t k = 0; k < SimdDouble::width; ++k) {
      EXPECT_EQ(sizes[k], std::abs(p[k]));
    }
  }
}

TEST(Simd, CompareNothingWithoutANumber) {
  const SimdDouble lanes = SimdDouble::of(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ((lanes < 0).bits() | (lanes > 0).bits(), 0U);
}

TEST(Simd, CompareFloats) {
  Random random(2);
  for (int round = 0; round < rounds; ++round) {
    float p[SimdFloat::width];
    std::generate(std::begin(p), std::end(p),
                  [&] { return static_cast<float>(some_double(random)); });
    const auto x = static_cast<float>(some_double(random));
    const auto bits = [](auto holds) { return bits_where(SimdFloat::width, holds); };
    const SimdFloat lanes = SimdFloat::load(p);
    EXPECT_EQ((lanes < x).bits(), bits([&](auto k) { return p[k] < x; }));
    EXPECT_EQ((lanes > x).bits(), bits([&](auto k) { return p[k] > x; }));
    EXPECT_EQ(smallest(lanes), *std::min_element(std::begin(p), std::end(p)));
    EXPECT_EQ(largest(lanes), *std::max_element(std::begin(p), std::end(p)));
  }
}

TEST(Simd, RoundPairsToFloats) {
  const PairOfDoubles p{0.1, -1e300};
  const PairOfDoubles q{-0.0, 0x1.000001p0};
  const FourFloats four = rounded(p, q);
  for (std::uint32_t k = 0; k < 4; ++k) {
    EXPECT_EQ(four[k], static_cast<float>(k < 2 ? p[k] : q[k - 2]));
  }
}

template <int distance>
void expect_turned() {
  const float numbers[SimdFloat::width] = {0, 1, 2, 3, 4, 5, 6, 7};
  float turned[SimdFloat::width];
  SimdFloat::load(numbers).turned<distance>().store(turned);
  for (std::uint32_t k = 0; k < SimdFloat::width; ++k) {
    EXPECT_EQ(turned[k], numbers[(k + distance) % SimdFloat::width]);
  }
}

TEST(Simd, TurnFloats) {
  expect_turned<1>();
  expect_turned<2>();
  expect_turned<3>();
  expect_turned<4>();
}

using FloatBox = SimdBox<SimdFloat>;
using FloatBoxes = BoxBlock<SimdFloat, FloatBox>;

template <int distance>
void expect_overlapping_at(const FloatBoxes& block) {
  const auto overlap = [&](std::uint32_t lane) {
    const FloatBox p = block.box(lane);
    const FloatBox q = block.box((lane + distance) % SimdFloat::width);
    return p.x0 <= q.x1 && q.x0 <= p.x1 && p.y0 <= q.y1 && q.y0 <= p.y1;
  };
  EXPECT_EQ(block.overlapping_at<distance>(), bits_where(SimdFloat::width, overlap));
}

TEST(Simd, FindOverlappingBoxesSoFarBehind) {
  Random random(4);
  for (int round = 0; round < rounds; ++round) {
    FloatBoxes block;
    for (std::uint32_t lane = 0; lane < SimdFloat::width; ++lane) {
      const auto number = [&] { return static_cast<float>(uniform(random, 0, 9)); };
      const float x = number();
      const float y = number();
      block.put(lane, {x, y, x + number() / 3, y + number() / 3});
    }
    expect_overlapping_at<1>(block);
    expect_overlapping_at<2>(block);
    expect_overlapping_at<3>(block);
    expect_overlapping_at<4>(block);
  }
}

TEST(Simd, CompareAndMultiplyShorts) {
  Random random(3);
  for (int round = 0; round < rounds; ++round) {
    std::int16_t p[SimdShort::width];
    std::int16_t q[SimdShort::width];
    std::generate(std::begin(p), std::end(p), [&] { return some_short(random); });
    std::generate(std::begin(q), std::end(q), [&] { return some_short(random); });
    const auto bits = [](auto holds) { return bits_where(SimdShort::width, holds); };
    const SimdShort lanes = SimdShort::load(p);
    const SimdShort others = SimdShort::load(q);
    EXPECT_EQ((lanes < others).bits(), bits([&](auto k) { return p[k] < q[k]; }));
    EXPECT_EQ((lanes > others).bits(), bits([&](auto k) { return p[k] > q[k]; }));
    EXPECT_EQ(smallest(lanes), *std::min_element(std::begin(p), std::end(p)));
    EXPECT_EQ(largest(lanes), *std::max_element(std::begin(p), std::end(p)));
    const SimdShort product = high_product(lanes, others);
    for (std::uint32_t k = 0; k < SimdShort::width; ++k) {
      EXPECT_EQ(product.numbers[k], std::floor(p[k] * q[k] / 65536.0));
    }
  }
}

}  // namespace
}  // namespace gcv
