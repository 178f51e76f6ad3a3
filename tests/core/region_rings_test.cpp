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

// In its second vertex.
bool is_turned_left(const PointVector& ring) {
  const Point& p = ring[1];
  return (p.x - ring[0].x) * (ring[2].y - p.y) > (p.y - ring[0].y) * (ring[2].x - p.x);
}

// Rounded to these rings: a polygon with its holes, then the next one. They may be off by as much
// as they are large.
struct Rounded {
  ExactRegion region{};
  RegionRings rings{region};

  explicit Rounded(const std::vector<PointVector>& points) {
    Index polygon = RegionPart::no_polygon;
    for (const PointVector& ring : points) {
      const bool is_outer = region.parts.empty() || is_turned_left(ring);
      polygon += is_outer ? 1 : 0;
      const PartKind kind = is_outer ? PartKind::outer : PartKind::hole;
      region.parts.push_back({kind, polygon, rings.places.size(), ring.size()});
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

TEST(RegionRings, WhatOnlyDroppedRingsAreInTheWayOfStays) {
  Tally tally;
  Rounded chain({square(0, 0, 30), hole(12, 12, 3), hole(8, 8, 5), hole(1, 1, 9)});
  chain.rings.rings.back().replaced = hole(1, 1, 9);
  make_valid(chain.rings, tally);
  EXPECT_EQ(chain.dropped(), (std::vector{false, false, true, false}));
  EXPECT_EQ(chain.rings.dropped, 1U);
}

TEST(RegionRings, PolygonsInsideOfOthersAreDropped) {
  Tally tally;
  Rounded islands({square(0, 0, 10), hole(1, 1, 5), square(2, 2, 1), square(7, 7, 1),
                   square(12, 0, 9), hole(13, 1, 5), square(14, 2, 3), hole(15, 3, 1)});
  make_valid(islands.rings, tally);
  EXPECT_EQ(islands.dropped(),
            (std::vector{false, false, false, true, false, false, false, false}));
  // It touches the other one from inside, and has a hole.
  const PointVector touching{{0, 5}, {6, 1}, {6, 9}};
  Rounded inside({square(0, 0, 10), touching, hole(4, 4, 1), square(-4, 0, 3)});
  make_valid(inside.rings, tally);
  EXPECT_EQ(inside.dropped(), (std::vector{false, true, true, false}));
  // What lies in a hole that was dropped.
  Rounded filled({square(0, 0, 30), hole(1, 1, 5), hole(4, 4, 9), square(2, 2, 1)});
  filled.rings.rings.back().replaced = square(2, 2, 1);
  filled.rings.error_bound = 0x1p-60;
  make_valid(filled.rings, tally);
  EXPECT_EQ(filled.dropped(), (std::vector{false, true, false, true}));
  EXPECT_EQ(filled.rings.dropped, 2U);
}

// By the nearest doubles, wherever its vertices were moved.
TEST(RegionRings, WhatIsLostIsMeasuredWhereItWas) {
  Tally tally;
  Rounded outside({square(0, 0, 10), hole(11, 1, 3)});
  for (std::size_t k = 4; k < 8; ++k) {
    outside.rings.nearest[k] = {2 * outside.rings.nearest[k].x, 2 * outside.rings.nearest[k].y};
  }
  make_valid(outside.rings, tally);
  EXPECT_GE(outside.rings.lost, 6 * 1.4142);
}

TEST(RegionRings, AHoleThatIsDroppedWithItsPolygonCountsOnce) {
  Tally tally;
  Rounded flat({{{1, 1}, {1, 1}, {1, 1}}, {{1, 1}, {1, 1}, {1, 1}}});
  make_valid(flat.rings, tally);
  EXPECT_EQ(flat.dropped(), (std::vector{true, true}));
  EXPECT_EQ(flat.rings.dropped, 2U);
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
