// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What repair does to rings of places that are not simple: slits stay open, in fractions, and
// what is not in the way stays where it is.
#include "repair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "error.hpp"
#include "exact_rings.hpp"
#include "generators.hpp"
#include "rounding.hpp"
#include "units.hpp"

namespace gcv {
namespace {

using test::exact;
using test::Random;
using test::scaled;
using test::shifted_ring;

Placement nearest_places(const ExactRing& ring) {
  Task task;
  Tally tally;
  return place_nearest(ring, task, tally);
}

bool is_simple(const PointVector& places) {
  return test::is_simple_and_counter_clockwise(exact(ring_through(places)));
}

std::optional<PointVector> separated(const ExactRing& ring, const PointVector& places) {
  Tally tally;
  return separate(ring, places, tally);
}

std::uint64_t count_differences(const PointVector& p, const PointVector& q) {
  std::uint64_t differences = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    differences += p[k] == q[k] ? 0 : 1;
  }
  return differences;
}

// No further than six units in the last place, and one for rounding.
bool are_near(const PointVector& places, const PointVector& nearest) {
  const Point unit = units_in_last_place(nearest);
  return std::equal(places.begin(), places.end(), nearest.begin(), nearest.end(),
                    [&](const Point& p, const Point& q) {
                      return std::abs(p.x - q.x) <= 7 * unit.x && std::abs(p.y - q.y) <= 7 * unit.y;
                    });
}

// The ring is made simple, and all of it stays: no slit closes.
void expect_repaired(const ExactRing& ring, std::uint64_t most_repaired) {
  const Placement before = nearest_places(ring);
  ASSERT_FALSE(is_simple(before.places));
  const auto places = separated(ring, before.places);
  ASSERT_TRUE(places);
  EXPECT_TRUE(is_simple(*places));
  EXPECT_TRUE(are_near(*places, before.places));

  Placement after = before;
  Task task;
  Tally tally;
  ASSERT_TRUE(make_simple(ring, after, task, tally));
  EXPECT_EQ(after.places, *places);
  EXPECT_EQ(after.repaired, count_differences(before.places, after.places));
  EXPECT_GT(after.repaired, 0U);
  EXPECT_LE(after.repaired, most_repaired);
  EXPECT_TRUE(test::are_within(exact(ring), exact(ring_through(after.places)), after.error_bound));
  const Point unit = units_in_last_place(before.places);
  EXPECT_LE(after.error_bound, 8 * (unit.x + unit.y));
}

TEST(Snap, KeepsEachPlaceOnce) {
  const Point p{0, 0};
  const Point q{1, 0};
  const Point r{1, 1};
  const SnappedRing same = snap(PointVector{p, q, r});
  EXPECT_EQ(same.vertices, (PointVector{p, q, r}));
  EXPECT_EQ(same.source, (std::vector<std::size_t>{0, 1, 2}));
  // Of equal places in a row, also round the end, the last.
  const SnappedRing fallen = snap(PointVector{p, q, q, q, r, r, p, p});
  EXPECT_EQ(fallen.vertices, (PointVector{p, q, r}));
  EXPECT_EQ(fallen.source, (std::vector<std::size_t>{0, 3, 5}));
  EXPECT_TRUE(snap(PointVector{p, p, p}).vertices.empty());
  // Places that return stay.
  EXPECT_EQ(snap(PointVector{p, q, p, r}).vertices.size(), 4U);
}

TEST(Repair, LeavesSimpleRingsAlone) {
  Random random(1);
  int rounded = 0;
  for (int k = 0; k < 200; ++k) {
    const PointVector polygon = k % 2 == 0 ? test::random_small_integer_polygon(random, 10, 9)
                                           : test::random_spiky_star(random, 16);
    const ExactRing ring = shifted_ring(polygon, {1e9 / 3, -1e6 / 7});
    Placement placement = nearest_places(ring);
    const PointVector nearest = placement.places;
    rounded += placement.error_bound == 0 ? 0 : 1;
    ASSERT_TRUE(is_simple(nearest));
    EXPECT_EQ(separated(ring, nearest), nearest);
    Task task;
    Tally tally;
    const double error_bound = placement.error_bound;
    EXPECT_TRUE(make_simple(ring, placement, task, tally));
    EXPECT_EQ(placement.places, nearest);
    EXPECT_EQ(placement.repaired, 0U);
    EXPECT_EQ(placement.error_bound, error_bound);
  }
  EXPECT_GE(rounded, 100);
}

// Walls that fall onto each other, and slanted ones that cross.
TEST(Repair, KeepsSlitsOpen) {
  for (const int slits : {1, 2, 7}) {
    for (const double slant : {0.0, 0.3, 3.0}) {
      for (const double width : {0x1p-45, 0x1p-40, 0x1p-30, 0x1p-27}) {
        SCOPED_TRACE(testing::Message() << slits << " slits, " << width << ", " << slant);
        const PointVector block = test::block_with_slits(slits, width, slant);
        expect_repaired(shifted_ring(block, {0x1p30 + 1.0 / 3, 0x1p30}),
                        4 * static_cast<std::uint64_t>(slits));
      }
    }
  }
}

TEST(Repair, KeepsSlitsOpenAtAllMagnitudes) {
  const PointVector block = test::block_with_slits(3, 0x1p-26, 0.25);
  for (const int exponent : {-1040, -1000, -300, 300, 900, 990}) {
    SCOPED_TRACE(exponent);
    const double far = std::ldexp(1, exponent + 30);
    expect_repaired(shifted_ring(scaled(block, exponent), {far, -far}), 12);
  }
}

// Notches, with one vertex at the end.
TEST(Repair, KeepsNotchesOpen) {
  const PointVector block{{0, 0}, {8, 0}, {8, 8}, {4 + 0x1p-30, 8}, {3.5, 2}, {4, 8}, {0, 8}};
  const ExactRing ring = shifted_ring(block, {0x1p30, 0x1p30});
  expect_repaired(ring, 3);
  const PointVector places = *separated(ring, nearest_places(ring).places);
  for (const std::size_t corner : {0U, 1U, 2U, 6U}) {
    EXPECT_EQ(places[corner], (Point{block[corner].x + 0x1p30, block[corner].y + 0x1p30}));
  }
}

TEST(Repair, MovesOnlyWhatIsInTheWay) {
  // A wide slit, and a narrow one to the left of it: the last four but one.
  PointVector block = test::block_with_slits(2, 0x1p-30, 0.5);
  block[3].x += 1;
  block[4].x += 1;
  const ExactRing ring = shifted_ring(block, {0x1p30, 0x1p30});
  const PointVector nearest = nearest_places(ring).places;
  const auto places = separated(ring, nearest);
  ASSERT_TRUE(places);
  EXPECT_TRUE(is_simple(*places));
  for (std::size_t k = 0; k < nearest.size(); ++k) {
    if (k < 7 || k > 10) {
      EXPECT_EQ((*places)[k], nearest[k]) << k;
    }
  }
}

// Many slits side by side in less than a unit, and what is smaller than a unit as a whole.
TEST(Repair, GivesUpWhereThereIsNoRoom) {
  const PointVector comb = test::block_with_slits(40, 1, 0);
  const PointVector fine = scaled(comb, -30, 0);
  const PointVector few = scaled(test::block_with_slits(9, 1, 0), -30, 0);
  const PointVector dot = scaled(comb, -60);
  for (const PointVector* const polygon : {&fine, &few, &dot}) {
    const ExactRing ring = shifted_ring(*polygon, {0x1p30, 0x1p30});
    Placement placement = nearest_places(ring);
    const PointVector nearest = placement.places;
    const double error_bound = placement.error_bound;
    EXPECT_FALSE(separated(ring, nearest));
    Task task;
    Tally tally;
    EXPECT_FALSE(make_simple(ring, placement, task, tally));
    EXPECT_EQ(placement.places, nearest);
    EXPECT_EQ(placement.repaired, 0U);
    EXPECT_EQ(placement.error_bound, error_bound);
  }
}

}  // namespace
}  // namespace gcv
