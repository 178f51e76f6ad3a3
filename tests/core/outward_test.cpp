// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Rounding outward contains the exact ring, in fractions, within its error bound.
#include "outward.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "box.hpp"
#include "error.hpp"
#include "exact_rings.hpp"
#include "generators.hpp"
#include "outer_face.hpp"
#include "units.hpp"

namespace gcv {
namespace {

using test::exact;
using test::Random;
using test::scaled;
using test::shifted_ring;

ExactRing ring_of_sum(const PointVector& a, const PointVector& b, const Point& shift) {
  const auto polygon_a = test::polygon_of(a);
  const auto polygon_b = test::polygon_of(b);
  Task task;
  Tally tally;
  Walk walk = walk_outer_face(*polygon_a, *polygon_b, task, tally);
  return {{polygon_a, "a"}, {polygon_b, "b"}, shift, std::move(walk.vertices)};
}

RoundedRing outward(const ExactRing& ring) {
  Task task;
  Tally tally;
  const auto outer_face_of = [&](const auto& a, const auto& b) {
    return walk_outer_face(a, b, task, tally).vertices;
  };
  return round_outward(ring, outer_face_of, task, tally);
}

double largest_unit(const RoundedRing& ring) {
  const Point unit = units_in_last_place(ring.vertices);
  return std::max(unit.x, unit.y);
}

RoundedRing expect_promises(const ExactRing& ring) {
  RoundedRing rounded = outward(ring);
  const invariants::Ring inner = exact(ring);
  const invariants::Ring outer = exact(rounded.vertices);
  EXPECT_TRUE(test::is_simple_and_counter_clockwise(outer));
  EXPECT_EQ(lexicographic_min(rounded.vertices), 0U);
  EXPECT_TRUE(test::contains(outer, inner));
  EXPECT_TRUE(test::are_within(outer, inner, rounded.error_bound));
  return rounded;
}

TEST(Outward, ContainsSums) {
  Random random(1);
  double furthest = 0;
  for (int k = 0; k < 60; ++k) {
    SCOPED_TRACE(k);
    const PointVector a = test::random_spiky_star(random, 10);
    const PointVector b = k % 2 == 0 ? test::random_spiky_star(random, 8)
                                     : test::random_small_integer_polygon(random, 8, 20);
    const Point shift{k % 3 == 0 ? 0 : 1e6 / 7, k % 5 == 0 ? -1e12 / 3 : 0.125};
    const RoundedRing rounded = expect_promises(ring_of_sum(a, b, shift));
    furthest = std::max(furthest, rounded.error_bound / largest_unit(rounded));
  }
  EXPECT_LE(furthest, 32);  // units in the last place
}

TEST(Outward, ContainsSumsAtAllMagnitudes) {
  Random random(2);
  for (const int exponent : {-1070, -1060, -1000, -500, 500, 1000, 1016}) {
    for (int k = 0; k < 3; ++k) {
      SCOPED_TRACE(testing::Message() << exponent << ", " << k);
      const PointVector a = scaled(test::random_spiky_star(random, 10), exponent);
      const PointVector b = scaled(test::random_spiky_star(random, 8), exponent - k);
      expect_promises(ring_of_sum(a, b, {std::ldexp(k, exponent + 5), 0}));
    }
  }
}

TEST(Outward, LeavesExactRingsAsTheyAre) {
  Random random(3);
  for (int k = 0; k < 20; ++k) {
    const PointVector a = test::random_small_integer_polygon(random, 9, 9);
    const RoundedRing rounded = outward(shifted_ring(a, {-5, 0x1p40}));
    EXPECT_EQ(rounded.error_bound, 0);
    EXPECT_EQ(rounded.vertices_repaired, 0U);
    EXPECT_EQ(exact(rounded.vertices), exact(shifted_ring(a, {-5, 0x1p40})));
  }
}

// Wide slits stay open, narrow ones close: their ends are then inside, 2 above the base.
TEST(Outward, ClosesNarrowSlitsAlone) {
  const Point shift{0x1p30 + 1.0 / 3, 0x1p30 + 1.0 / 3};
  constexpr double unit = 0x1p-22;
  for (const double slant : {0.0, 0.3, 3.0}) {
    for (const double width : {0x1p-40, 0x1p-24, unit}) {
      SCOPED_TRACE(testing::Message() << width << ", " << slant);
      const RoundedRing closed =
          expect_promises(shifted_ring(test::block_with_slits(3, width, slant), shift));
      EXPECT_LT(closed.vertices.size(), 4U + 3 * 4);
      EXPECT_GE(closed.error_bound, 2);
      EXPECT_LE(closed.error_bound, 8);
    }
    for (const double width : {100 * unit, 0.1}) {
      SCOPED_TRACE(testing::Message() << width << ", " << slant);
      const RoundedRing open =
          expect_promises(shifted_ring(test::block_with_slits(3, width, slant), shift));
      EXPECT_GE(open.vertices.size(), 4U + 3 * 4);
      EXPECT_LE(open.error_bound, 16 * unit);
    }
  }
}

// Slits about as wide as they are narrowed, which may leave less than a unit of them.
TEST(Outward, ContainsSlitsThatNearlyClose) {
  constexpr double unit = 0x1p-22;
  for (int width = 1; width <= 12; ++width) {
    for (int slant = -30; slant <= 30; ++slant) {
      SCOPED_TRACE(testing::Message() << width << ", " << slant);
      const PointVector block = test::block_with_slits(1, width * unit, slant / 10.0);
      expect_promises(shifted_ring(block, {0x1p30 + 1.0 / 3, 0x1p30 + 1.0 / 3}));
    }
  }
}

// Neither reflex vertices nor edges along an axis make the bound larger than that of corners.
TEST(Outward, ContainsConvexPolygons) {
  Random random(5);
  const PointVector kite{{0, -1}, {2, 0}, {0, 3}, {-1, 0}};
  for (int k = 0; k < 100; ++k) {
    const Point shift{test::uniform(random, -99, 99) / 7.0, test::uniform(random, -99, 99) / 7.0};
    const RoundedRing rounded = expect_promises(shifted_ring(scaled(kite, k % 3, k % 2), shift));
    EXPECT_LE(rounded.error_bound, 12 * largest_unit(rounded));
  }
}

// Where rounding to nearest leaves parts out, growing takes them in.
TEST(Outward, ContainsWhatRoundingToNearestCutsOff) {
  Random random(4);
  int cut_off = 0;
  for (const int exponent : {-700, 0, 700}) {
    for (int k = 0; k < 6; ++k) {
      SCOPED_TRACE(testing::Message() << exponent << ", " << k);
      const PointVector tiny = scaled(test::random_spiky_star(random, 14), exponent - 30);
      const PointVector huge = scaled(test::random_spiky_star(random, 9), exponent + 23);
      const ExactRing ring = ring_of_sum(tiny, huge, {0, 0});
      const RoundedRing rounded = expect_promises(ring);
      EXPECT_LE(rounded.error_bound, 64 * largest_unit(rounded));
      Task task;
      Tally tally;
      const RoundedRing nearest = round_to_nearest(ring, task, tally);
      cut_off += test::contains(exact(nearest.vertices), exact(ring)) ? 0 : 1;
    }
  }
  EXPECT_GT(cut_off, 9);
}

// Two blocks joined by a neck that falls onto a line, and slits that are too many to be kept open:
// rounding to nearest keeps the larger block alone.
TEST(Outward, ContainsBlocksThatRoundingToNearestLoses) {
  constexpr double thin = 0x1p-40;
  PointVector blocks{{0, 0},  {8, 0},  {8, 4},         {12, 4},       {12, 0}, {18, 0},
                     {18, 8}, {12, 8}, {12, 4 + thin}, {8, 4 + thin}, {8, 8}};
  for (int k = 40; k > 0; --k) {
    const double x = 4 + 2 * k * thin;
    blocks.insert(blocks.end(), {{x + thin, 8}, {x + thin, 6}, {x, 6}, {x, 8}});
  }
  blocks.push_back({0, 8});
  const ExactRing ring = shifted_ring(blocks, {0x1p30, 0x1p30});
  Task task;
  Tally tally;
  const RoundedRing nearest = round_to_nearest(ring, task, tally);
  EXPECT_EQ(box_of(nearest.vertices).x1, 0x1p30 + 8);
  EXPECT_GE(nearest.error_bound, 10);
  expect_promises(ring);
}

TEST(Outward, RefusesWhatGoesBeyondTheLargestDouble) {
  constexpr double largest = std::numeric_limits<double>::max();
  const PointVector triangle{{0, 0}, {largest, 0}, {0, largest}};
  EXPECT_EQ(outward(shifted_ring(triangle, {0, 0})).error_bound, 0);
  try {
    outward(shifted_ring(triangle, {-1, 0}));
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::range);
  }
}

}  // namespace
}  // namespace gcv
