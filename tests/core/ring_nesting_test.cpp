// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Rings with small integer coordinates, full of ties, against another theory.
#include "ring_nesting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "error.hpp"
#include "generators.hpp"
#include "polygon.hpp"
#include "ring_pieces.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Ring;
using test::uniform;
using test::pieces::all_may_lie;
using test::pieces::between;
using test::pieces::cross;
using test::pieces::end_of;
using test::pieces::location;
using test::pieces::may_lie;
using Rings = std::vector<Ring>;

TEST(Reference, KnowsTheFirstCases) {
  const Ring square{{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  const Ring diamond{{4, 0}, {8, 4}, {4, 8}, {0, 4}};
  const Ring spike{{2, 2}, {9, 4}, {2, 6}};
  const Ring part{{2, 0}, {6, 0}, {4, 3}};
  EXPECT_TRUE(all_may_lie({square, diamond}));
  EXPECT_FALSE(all_may_lie({diamond, square}));
  EXPECT_FALSE(all_may_lie({square, square}));
  EXPECT_FALSE(all_may_lie({square, spike}));
  EXPECT_FALSE(all_may_lie({square, part}));
  EXPECT_EQ(location(square, {8, 16, 2}), 0);
  EXPECT_EQ(location(square, {8, 15, 2}), 1);
  EXPECT_EQ(location(square, {8, 17, 2}), -1);
}

// ------------------------------------------------------------------------------ the rings --

// The message, or nothing where they are accepted.
std::string verdict(const Rings& rings) {
  try {
    const Polygon polygon = make_polygon(rings, "polygon");
    EXPECT_EQ(polygon.ring_count(), rings.size());
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::not_simple) << error.what();
    return error.what();
  }
}

std::string text(const Rings& rings) {
  std::string result;
  for (const Ring& ring : rings) {
    result += "(";
    for (const Point& p : ring) {
      result += std::to_string(static_cast<int>(p.x)) + " " +
                std::to_string(static_cast<int>(p.y)) + ", ";
    }
    result += ") ";
  }
  return result;
}

// The straight edge of a ring, of which the edge of that number, through all rings, is a part.
std::pair<Point, Point> straight_edge(const Rings& rings, std::size_t k, unsigned number) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < k; ++i) {
    first += rings[i].size();
  }
  const auto kind = k == 0 ? gcv::Boundary::Kind::outer : gcv::Boundary::Kind::hole;
  const gcv::Boundary ring = make_ring(rings[k], "ring", kind, {first, {}});
  for (Index i = 0; i < ring.size(); ++i) {
    const Point& p = ring.vertices[i];
    const Point& q = ring.vertices[ring.next(i)];
    if (ring.corners[i].edge_number == number) {
      for (const Point& end : {rings[k].at(number - first), end_of(rings[k], number - first)}) {
        EXPECT_EQ(cross(between(p, q), between(p, end)), 0);
      }
      return {p, q};
    }
  }
  ADD_FAILURE() << "there is no edge " << number;
  return {};
}

// The rings that are named may not lie as they do, and the edges that are named meet.
void expect_true(const Rings& rings, const std::string& message) {
  unsigned r = 0;
  unsigned s = 0;
  std::array<unsigned, 2> edges{};
  const std::size_t meet = message.find("edges");
  if (meet != std::string::npos) {
    ASSERT_EQ(std::sscanf(message.c_str(), "polygon: rings %u and %u", &r, &s), 2) << message;
    ASSERT_EQ(std::sscanf(message.c_str() + meet, "edges %u and %u meet", &edges[0], &edges[1]), 2);
    const auto [p, q] = straight_edge(rings, r, edges[0]);
    const auto [a, b] = straight_edge(rings, s, edges[1]);
    EXPECT_TRUE(cross(between(p, q), between(p, a)) * cross(between(p, q), between(p, b)) <= 0 &&
                cross(between(a, b), between(a, p)) * cross(between(a, b), between(a, q)) <= 0)
        << message;
  } else {
    const std::size_t where = std::min(message.find("inside"), message.find("outside"));
    ASSERT_NE(where, std::string::npos) << message;
    ASSERT_EQ(std::sscanf(message.c_str(), "polygon: ring %u,", &r), 1) << message;
    ASSERT_EQ(std::sscanf(message.c_str() + where, "%*s ring %u", &s), 1) << message;
    EXPECT_EQ(message[where] == 'o', s == 0) << message;
  }
  ASSERT_NE(r, s);
  EXPECT_FALSE(may_lie(rings, r, s)) << message;
}

struct Counts {
  int accepted = 0;
  int refused = 0;
  int touching = 0;
  int located = 0;
};

bool touch(const Ring& p, const Ring& q) {
  return std::any_of(p.begin(), p.end(), [&](const Point& x) {
    return location(q, {static_cast<std::int64_t>(x.x), static_cast<std::int64_t>(x.y), 1}) == 0;
  });
}

void expect_right(const Rings& rings, bool expected, Counts& counts) {
  const std::string message = verdict(rings);
  ASSERT_EQ(message.empty(), expected) << message << "\n" << text(rings);
  if (!expected) {
    expect_true(rings, message);
    ++counts.refused;
    counts.located += message.find("hole") != std::string::npos ? 1 : 0;
    return;
  }
  ++counts.accepted;
  for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
    counts.touching += touch(rings.back(), rings[k]) || touch(rings[k], rings.back()) ? 1 : 0;
  }
}

// A way to map the plane of integers onto itself.
struct Map {
  int xx, xy, yx, yy;
  static Map any(Random& random) {
    const int shear = uniform(random, -2, 2);
    const int sign = uniform(random, 0, 1) == 0 ? 1 : -1;
    return uniform(random, 0, 1) == 0 ? Map{sign, shear, 0, 1} : Map{0, 1, sign, shear};
  }
  Ring operator()(Ring ring) const {
    for (Point& p : ring) {
      p = {xx * p.x + xy * p.y, yx * p.x + yy * p.y};
    }
    return ring;
  }
};

// Somewhere in a square of that size, or a bit outside, from any vertex and in any orientation.
Ring any_ring(Random& random, int vertices, int extent, int size) {
  const int most = (extent + 1) * (extent + 1);
  Ring ring = test::random_small_integer_polygon(random, std::min(vertices, most), extent);
  const int dx = uniform(random, -1, size - extent + 1);
  const int dy = uniform(random, -1, size - extent + 1);
  for (Point& p : ring) {
    p = {p.x + dx, p.y + dy};
  }
  std::rotate(ring.begin(), ring.begin() + uniform(random, 0, static_cast<int>(ring.size()) - 1),
              ring.end());
  if (uniform(random, 0, 1) == 0) {
    std::reverse(ring.begin(), ring.end());
  }
  return ring;
}

Rings mapped(const Map& map, Rings rings) {
  for (Ring& ring : rings) {
    ring = map(ring);
  }
  return rings;
}

TEST(RingNesting, OfRandomRingsIsAsThePiecesSay) {
  Random random(21);
  Counts counts;
  for (int round = 0; round < 6000; ++round) {
    const int size = uniform(random, 4, 9);
    const double s = size;
    const Map map = Map::any(random);
    Rings rings{{{0, 0}, {s, 0}, {s, s}, {0, s}}};
    if (uniform(random, 0, 1) == 0) {
      rings = {any_ring(random, uniform(random, 4, 12), size, size)};
    }
    // Holes one by one; those that may not lie so are taken away again.
    for (int k = 0; k < 12; ++k) {
      const int extent = uniform(random, 1, uniform(random, 2, size));
      rings.push_back(any_ring(random, uniform(random, 3, 6), extent, size));
      bool may = true;
      for (std::size_t i = 0; may && i + 1 < rings.size(); ++i) {
        may = may_lie(rings, i, rings.size() - 1);
      }
      ASSERT_NO_FATAL_FAILURE(expect_right(mapped(map, rings), may, counts));
      if (!may) {
        rings.pop_back();
      }
    }
  }
  EXPECT_GT(counts.accepted, 5000);
  EXPECT_GT(counts.touching, 5000);
  EXPECT_GT(counts.refused, 5000);
  EXPECT_GT(counts.located, 500);
}

// All at once, so that what is wrong is not always the last.
TEST(RingNesting, OfRandomRingsAllAtOnceIsAsThePiecesSay) {
  Random random(22);
  Counts counts;
  for (int round = 0; round < 30000; ++round) {
    const int size = uniform(random, 6, 12);
    const double s = size;
    Rings rings{{{0, 0}, {s, 0}, {s, s}, {0, s}}};
    for (int holes = uniform(random, 2, 5); holes > 0; --holes) {
      rings.push_back(any_ring(random, 3 + holes % 3, uniform(random, 1, 4), size - 1));
    }
    ASSERT_NO_FATAL_FAILURE(
        expect_right(mapped(Map::any(random), rings), all_may_lie(rings), counts));
  }
  EXPECT_GT(counts.accepted, 1000);
  EXPECT_GT(counts.refused, 5000);
}

// Diamonds and rectangles in a box, side by side and in one another: they touch, but do not cross.
void add_nested(Random& random, const Point& low, const Point& high, Rings& rings) {
  const Point size{high.x - low.x, high.y - low.y};
  if (std::min(size.x, size.y) < 4) {
    return;
  }
  const Point middle{low.x + size.x / 2, low.y + size.y / 2};
  const Point quarter{low.x + size.x / 4, low.y + size.y / 4};
  switch (uniform(random, 0, 4)) {
    case 0:
      add_nested(random, low, {middle.x, high.y}, rings);
      add_nested(random, {middle.x, low.y}, high, rings);
      return;
    case 1:
      add_nested(random, low, {high.x, middle.y}, rings);
      add_nested(random, {low.x, middle.y}, high, rings);
      return;
    case 2:
      rings.push_back(
          {{middle.x, low.y}, {high.x, middle.y}, {middle.x, high.y}, {low.x, middle.y}});
      break;
    case 3:
      rings.push_back({{low.x + 1, low.y + 1},
                       {high.x - 1, low.y + 1},
                       {high.x - 1, high.y - 1},
                       {low.x + 1, high.y - 1}});
      break;
    default:
      return;
  }
  if (uniform(random, 0, 11) == 0) {
    add_nested(random, quarter, {quarter.x + size.x / 2, quarter.y + size.y / 2}, rings);
  }
}

TEST(RingNesting, OfRingsThatDoNotCrossIsAsThePiecesSay) {
  Random random(23);
  Counts counts;
  for (int round = 0; round < 20000; ++round) {
    Rings rings{{{0, 0}, {32, 0}, {32, 32}, {0, 32}}};
    if (uniform(random, 0, 3) == 0) {
      rings = {{{0, 0}, {16, 0}, {16, 32}, {0, 32}}};
    }
    for (int k = 0; k < 3 && rings.size() < 4; ++k) {
      rings.resize(1);
      add_nested(random, {0, 0}, {32, 32}, rings);
    }
    if (rings.size() > 1) {
      std::shuffle(rings.begin() + 1, rings.end(), random);
      ASSERT_NO_FATAL_FAILURE(
          expect_right(mapped(Map::any(random), rings), all_may_lie(rings), counts));
    }
  }
  EXPECT_GT(counts.accepted, 3000);
  EXPECT_GT(counts.touching, 3000);
  EXPECT_GT(counts.located, 1000);
}

// ------------------------------------------------------------------------------ the effort --

// A plate with columns and rows of holes, of which each touches the next one of its row where
// `touching`. Predicates that it takes to check it.
std::uint64_t predicates(int columns, int rows, bool touching) {
  const double width = columns;
  const double height = rows;
  std::vector<gcv::Boundary> rings;
  rings.push_back(
      make_ring({{-1, -1}, {width + 1, -1}, {width + 1, height + 1}, {-1, height + 1}}, "plate"));
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double x = i;
      const double y = j;
      const double right = touching ? x + 1 : x + 0.875;
      rings.push_back(
          make_ring({{x, y + 0.5}, {x + 0.5, y + 0.25}, {right, y + 0.5}, {x + 0.5, y + 0.75}},
                    "hole", gcv::Boundary::Kind::hole));
    }
  }
  std::vector<const gcv::Boundary*> pointers;
  for (const gcv::Boundary& ring : rings) {
    pointers.push_back(&ring);
  }
  const Tally tally = check_nesting(pointers, "plate");
  EXPECT_EQ(tally.rational, 0U);
  return tally.filtered + tally.fixed_width;
}

TEST(RingNesting, OfManyHolesTakesFewPredicates) {
  constexpr int holes = 25000;
  constexpr std::uint64_t most = std::uint64_t{holes} * 4 * 40;
  EXPECT_LT(predicates(158, 158, false), most);
  EXPECT_LT(predicates(158, 158, true), most);
  EXPECT_LT(predicates(1, holes, false), most);
  EXPECT_LT(predicates(holes, 1, false), most);
  EXPECT_LT(predicates(holes, 1, true), most);
  EXPECT_LT(predicates(2, holes / 2, true), most);
  EXPECT_GT(predicates(158, 158, false), std::uint64_t{holes});
}

}  // namespace
}  // namespace gcv
