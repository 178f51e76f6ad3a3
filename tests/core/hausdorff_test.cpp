// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The bounds on errors that the benchmarks report, against distances that are known and
// against those of many points of both curves.
#include "hausdorff.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "generators.hpp"

namespace gcv::bench {
namespace {

using test::Random;
using test::uniform;

WideRing square(double side) { return {{0, 0}, {side, 0}, {side, side}, {0, side}}; }

double distance(double x, double y, const WidePoint& p, const WidePoint& q) {
  const auto dx = static_cast<double>(q.x - p.x);
  const auto dy = static_cast<double>(q.y - p.y);
  const double to_x = x - static_cast<double>(p.x);
  const double to_y = y - static_cast<double>(p.y);
  const double t = std::clamp((to_x * dx + to_y * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(to_x - t * dx, to_y - t * dy);
}

// The largest distance from q of points that divide the edges of p into `parts`.
double sampled(const WideRing& p, const WideRing& q, int parts) {
  double largest = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const WidePoint& from = p[k];
    const WidePoint& to = p[(k + 1) % p.size()];
    for (int part = 0; part < parts; ++part) {
      const Wide t = Wide(part) / parts;
      const auto x = static_cast<double>(from.x + t * (to.x - from.x));
      const auto y = static_cast<double>(from.y + t * (to.y - from.y));
      double least = HUGE_VAL;
      for (std::size_t j = 0; j < q.size(); ++j) {
        least = std::min(least, distance(x, y, q[j], q[(j + 1) % q.size()]));
      }
      largest = std::max(largest, least);
    }
  }
  return largest;
}

TEST(Hausdorff, IsZeroOfTheSameCurve) {
  const WideRing split{{0, 0}, {1, 0}, {3, 0}, {3, 3}, {2, 3}, {0, 3}};
  const Bounds bounds = hausdorff_distance(square(3), split);
  EXPECT_EQ(bounds.lower, 0);
  EXPECT_LT(bounds.upper, 1e-28);
}

TEST(Hausdorff, FindsWhatDoublesDoNotHold) {
  for (const int exponent : {1, 20, 50, 60, 80}) {
    WideRing moved = square(3);
    const double step = std::ldexp(1, -exponent);
    moved[2].x += step;
    const Bounds bounds = hausdorff_distance(square(3), moved);
    EXPECT_LE(bounds.lower, step);
    EXPECT_GE(bounds.upper, step);
    EXPECT_GT(bounds.lower, 0.95 * step);
  }
}

TEST(Hausdorff, FindsTheEndOfASlit) {
  WideRing slit = square(10);
  slit.insert(slit.begin() + 1, {{5, 0}, {5, 3}, {5 + Wide(0x1p-60), 0}});
  const Bounds bounds = hausdorff_distance(square(10), slit);
  EXPECT_LE(bounds.lower, 3);
  EXPECT_GE(bounds.upper, 3);
}

TEST(Hausdorff, AgreesWithManyPoints) {
  Random random(1);
  const auto curve = [&] {
    WideRing ring;
    for (int k = uniform(random, 3, 30); k > 0; --k) {
      ring.push_back({Wide(uniform(random, 0, 1000)), Wide(uniform(random, 0, 1000))});
    }
    return ring;
  };
  constexpr int parts = 400;
  constexpr double between = 1415.0 / parts;
  for (int k = 0; k < 100; ++k) {
    const WideRing p = curve();
    const WideRing q = curve();
    const Bounds bounds = hausdorff_distance(p, q);
    const double reached = std::max(sampled(p, q, parts), sampled(q, p, parts));
    EXPECT_GE(bounds.upper, reached);
    EXPECT_LE(bounds.lower, reached + between);
    EXPECT_LE(bounds.upper, 1.0501 * bounds.lower);
  }
}

}  // namespace
}  // namespace gcv::bench
