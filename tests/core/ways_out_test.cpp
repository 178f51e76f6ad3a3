// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Ways out of overlaps by searches and by the whole boundary: the same, to the bit.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "error.hpp"
#include "generators.hpp"
#include "penetration.hpp"
#include "region_families.hpp"
#include "regions.hpp"

namespace gcv {
namespace {

using Numbers = std::vector<std::uint64_t>;

Numbers numbers_of(const Escape& escape) {
  const auto& [depth, way, place, contact] = escape;
  Numbers numbers;
  for (const double x :
       {depth, way.x, way.y, place.position.x, place.position.y, contact.gap, contact.normal.x,
        contact.normal.y, contact.on_a.x, contact.on_a.y, contact.on_b.x, contact.on_b.y}) {
    numbers.push_back(std::bit_cast<std::uint64_t>(x));
  }
  numbers.push_back(static_cast<std::uint64_t>(place.relation));
  numbers.push_back(static_cast<std::uint64_t>(contact.kind));
  numbers.push_back(contact.a);
  numbers.push_back(contact.b);
  return numbers;
}

// Steps that no search takes, and places that so many are asked.
constexpr std::uint64_t many_steps = std::uint64_t{1} << 40;
constexpr std::size_t many_places = 1001;

class WaysOfPair {
 public:
  WaysOfPair(const test::PolygonRings& a, const test::PolygonRings& reflected_b, double scale)
      : a_(*test::region_operand(scaled(a, scale), "a").polygon),
        b_(*test::region_operand(scaled(test::negated_rings(reflected_b), scale), "b").polygon),
        reflected_(*test::region_operand(scaled(reflected_b, scale), "b").polygon),
        pair_(a_, b_) {}

  // In the box of all overlaps.
  [[nodiscard]] Point place(test::Random& random) const {
    const Box box = sum_of(a_.boundary().bounds, reflected_.boundary().bounds);
    const auto between = [&](double low, double high) {
      return low + (high - low) * test::uniform(random, 0, 48) / 48;
    };
    const double x = between(box.x0, box.x1);
    return {x, between(box.y0, box.y1)};
  }

  [[nodiscard]] Numbers find(const Point& translation, const WantedParts& wanted,
                             std::uint64_t steps) const {
    Task task;
    Tally tally;
    const WaysOut ways(a_, reflected_, wanted, many_places, task, tally);
    for (int k = 0; k < 4; ++k) {
      ways.add_search(steps / 4);
    }
    EXPECT_EQ(ways.boundary(task) != nullptr,
              steps > 0 || (a_.boundary().is_convex && b_.boundary().is_convex));
    return numbers_of(EscapeSearch(ways, tally).find(PlacedPair(pair_, translation), task));
  }

 private:
  static test::PolygonRings scaled(test::PolygonRings rings, double scale) {
    for (PointVector& ring : rings) {
      for (Point& p : ring) {
        p = {scale * p.x, scale * p.y};
      }
    }
    return rings;
  }

  Polygon a_;
  Polygon b_;
  Polygon reflected_;
  PolygonPair pair_;
};

void compare_ways(int cases, double scale, int places) {
  int overlaps = 0;
  for (const test::RegionFamily& family : test::region_families()) {
    test::Random random(11);
    for (int k = 0; k < cases; ++k) {
      const test::RegionCase c = family.next_case(random);
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(k));
      const WaysOfPair ways(c.a, c.b, scale);
      for (int n = 0; n < places; ++n) {
        const Point translation = ways.place(random);
        for (const WantedParts& wanted : {WantedParts{true, true}, WantedParts{true, false},
                                          WantedParts{false, true}, WantedParts{false, false}}) {
          const Numbers by_search = ways.find(translation, wanted, 0);
          EXPECT_EQ(by_search, ways.find(translation, wanted, many_steps))
              << translation.x << ' ' << translation.y;
          overlaps += by_search[0] != 0 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(overlaps, cases * places);
}

TEST(WaysOut, AreTheSameBySearchAndByBoundary) { compare_ways(12, 1, 12); }

TEST(WaysOut, AreTheSameForHugeAndTinyPolygons) {
  for (const double scale : {0x1p1010, 0x1p-1060, 0x1p500, 0x1p-520}) {
    SCOPED_TRACE(scale);
    compare_ways(3, scale, 4);
  }
}

// A comb with itself, whose gaps fit no tooth, each by another bit: the region takes long.
test::PolygonRings comb(int teeth, double bit = 0x1p-12) {
  const auto right = [&](int k) { return k + 0.5 + k % 7 * k * bit; };  // of a tooth
  PointVector ring{{0, 0}, {right(teeth - 1), 0}};
  for (int k = teeth - 1; k >= 0; --k) {
    ring.insert(ring.end(), {{right(k), 9}, {1.0 * k, 9}});
    if (k > 0) {
      ring.insert(ring.end(), {{1.0 * k, 1}, {right(k - 1), 1}});
    }
  }
  return {ring};
}

// Half of the steps of the searches to come may be spent.
TEST(WaysOut, GiveUpARegionThatTakesLonger) {
  const Polygon a = *test::region_operand(comb(60), "a").polygon;
  Task task;
  Tally tally;
  const WaysOut ways(a, a, {}, many_places, task, tally);
  const std::uint64_t few = estimated_cover_steps(a.boundary(), a.boundary()) / 4;
  EXPECT_EQ(ways.boundary(task), nullptr);
  const auto add = [&](std::uint64_t steps) {
    for (int k = 0; k < 4; ++k) {
      ways.add_search(steps);
    }
  };
  add(few / 500);
  EXPECT_EQ(ways.boundary(task), nullptr);  // not begun
  add(few / 500 + 8);
  EXPECT_EQ(ways.boundary(task), nullptr);  // given up
  add(few / 500 + 8);
  EXPECT_EQ(ways.boundary(task), nullptr);  // not begun
  ways.add_search(many_steps);
  const FreeBoundary* const boundary = ways.boundary(task);
  EXPECT_NE(boundary, nullptr);
  EXPECT_EQ(ways.boundary(task), boundary);
}

// Where one search takes long, the boundary is found, or given up for a longer search.
TEST(WaysOut, OfALongSearchAreThoseOfTheBoundary) {
  int found = 0;
  for (const double bit : {0.0, 0x1p-12}) {
    for (const int teeth : {20, 60, 120}) {
      SCOPED_TRACE(teeth);
      const Polygon a = *test::region_operand(comb(teeth, bit), "a").polygon;
      const Polygon b = *test::region_operand(test::negated_rings(comb(teeth, bit)), "b").polygon;
      const PolygonPair pair(a, b);
      const PlacedPair placed(pair, {0.3 * teeth + 0.1, 10.1});
      Task task;
      Tally tally;
      const WaysOut ways(a, a, {}, 1, task, tally);
      const Numbers by_search = numbers_of(EscapeSearch(ways, tally).find(placed, task));
      const WaysOut known(a, a, {}, 1, task, tally);
      EXPECT_NE(known.boundary(task, many_steps), nullptr);
      EXPECT_EQ(by_search, numbers_of(EscapeSearch(known, tally).find(placed, task)));
      EXPECT_NE(by_search[0], 0);
      found += ways.boundary(task) != nullptr ? 1 : 0;
    }
  }
  EXPECT_GT(found, 0);
  EXPECT_LT(found, 6);
}

TEST(WaysOut, AreSearchedForWhereFewAreLeft) {
  const Polygon a = *test::region_operand(comb(60), "a").polygon;
  Task task;
  Tally tally;
  const WaysOut ways(a, a, {}, 1, task, tally);
  ways.add_search(many_steps);
  EXPECT_EQ(ways.boundary(task), nullptr);
}

TEST(WaysOut, AreCancelledInARegionToo) {
  const Polygon a = *test::region_operand(comb(60), "a").polygon;
  Task task;
  Tally tally;
  const WaysOut ways(a, a, {}, many_places, task, tally);
  for (int k = 0; k < 4; ++k) {
    ways.add_search(many_steps);
  }
  Task cancelled(
      1, [](void*, std::uint64_t, std::uint64_t) { return std::int32_t{1}; }, nullptr);
  EXPECT_THROW((void)ways.boundary(cancelled), Error);
  EXPECT_NE(ways.boundary(task), nullptr);
}

}  // namespace
}  // namespace gcv
