// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Rings that lie in each other's way after rounding.
#include "region_rings.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace gcv {
namespace {

PointVector square(double x, double y, double size) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

PointVector hole(double x, double y, double size) {
  return {{x, y}, {x, y + size}, {x + size, y + size}, {x + size, y}};
}

// One polygon, rounded to these rings. They may be off by as much as they are large.
struct Rounded {
  ExactRegion region{};
  RegionRings rings{region};

  explicit Rounded(const std::vector<PointVector>& points) {
    for (const PointVector& ring : points) {
      const PartKind kind = region.parts.empty() ? PartKind::outer : PartKind::hole;
      region.parts.push_back({kind, 0, rings.places.size(), ring.size()});
      rings.places.insert(rings.places.end(), ring.begin(), ring.end());
    }
    for (const RegionPart& part : region.parts) {
      rings.rings.push_back({&part});
    }
    rings.nearest = rings.places;
    rings.error_bound = 10;
  }
  Rounded(const Rounded&) = delete;
  Rounded& operator=(const Rounded&) = delete;

  [[nodiscard]] std::vector<bool> dropped() const {
    std::vector<bool> result;
    for (const RoundingRing& ring : rings.rings) {
      result.push_back(ring.is_dropped);
    }
    return result;
  }
};

TEST(RegionRings, StayWhereNoneIsInTheWay) {
  Rounded rounded({square(0, 0, 10), hole(1, 1, 2), hole(5, 1, 2)});
  Tally tally;
  make_valid(rounded.rings, tally);
  EXPECT_EQ(rounded.dropped(), (std::vector{false, false, false}));
  EXPECT_EQ(rounded.rings.lost, 0);
  EXPECT_EQ(rounded.rings.repaired, 0U);
}

TEST(RegionRings, HolesOnTheWrongSideAreDropped) {
  Tally tally;
  Rounded outside({square(0, 0, 10), hole(1, 1, 2), hole(11, 1, 3)});
  make_valid(outside.rings, tally);
  EXPECT_EQ(outside.dropped(), (std::vector{false, false, true}));
  EXPECT_EQ(outside.rings.dropped, 1U);
  EXPECT_GE(outside.rings.lost, 3 * 1.4142);
  Rounded nested({square(0, 0, 10), hole(1, 1, 5), hole(2, 2, 1), hole(7, 7, 1)});
  make_valid(nested.rings, tally);
  EXPECT_EQ(nested.dropped(), (std::vector{false, false, true, false}));
  EXPECT_GE(nested.rings.lost, 1.4142);
}

TEST(RegionRings, TheSmallestThatIsInTheWayIsDroppedUnlessItIsFixed) {
  Tally tally;
  // A ring that was replaced, so that none is moved.
  Rounded crossing({square(0, 0, 10), hole(1, 1, 5), hole(5, 5, 2), hole(1, 7, 1)});
  crossing.rings.rings.back().replaced = hole(1, 7, 1);
  make_valid(crossing.rings, tally);
  EXPECT_EQ(crossing.dropped(), (std::vector{false, false, true, false}));
  Rounded fixed({square(0, 0, 2), hole(1, 1, 5), hole(0.5, 0.5, 0.25)});
  fixed.rings.rings.front().is_fixed = true;
  fixed.rings.rings.back().replaced = hole(0.5, 0.5, 0.25);
  make_valid(fixed.rings, tally);
  EXPECT_EQ(fixed.dropped(), (std::vector{false, true, false}));
}

TEST(RegionRings, SegmentsAreWidenedByAUnit) {
  Tally tally;
  Rounded flat({square(0, 0, 10), {{1, 1}, {3, 1}, {3, 1}}, {{5, 5}, {5, 5}, {5, 5}}});
  make_valid(flat.rings, tally);
  EXPECT_EQ(flat.dropped(), (std::vector{false, false, true}));
  EXPECT_EQ(flat.rings.repaired, 1U);
  EXPECT_GE(flat.rings.furthest, 0x1p-53);
  EXPECT_LE(flat.rings.furthest, 0x1p-50);
}

}  // namespace
}  // namespace gcv
