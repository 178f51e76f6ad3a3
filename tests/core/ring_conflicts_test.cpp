// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Conflicts between rings against a theory of its own (ring_pieces.hpp). Small integers, full of
// ties.
#include "ring_conflicts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "box.hpp"
#include "generators.hpp"
#include "ring_pieces.hpp"

namespace gcv {
namespace {

using Rings = std::vector<PointVector>;

PointVector moved(PointVector ring, double x, double y) {
  for (Point& p : ring) {
    p = {p.x + x, p.y + y};
  }
  return ring;
}

const Point& end_of(const PointVector& ring, std::size_t edge) {
  return ring[(edge + 1) % ring.size()];
}

// Do all pieces of each ring lie on one side of the other, strictly?
bool keep_apart(const PointVector& p, const PointVector& q) {
  const auto is_on_a_side = [](const PointVector& ring, const PointVector& of) {
    return test::pieces::lies(ring, 1, of) || test::pieces::lies(ring, -1, of);
  };
  return is_on_a_side(p, q) && is_on_a_side(q, p);
}

double cross(const Point& p, const Point& q, const Point& r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

// Closed edges, in doubles that are exact here.
bool edges_meet(const Point& p, const Point& q, const Point& r, const Point& s) {
  return !are_apart(box_of(p, q), box_of(r, s)) && cross(p, q, r) * cross(p, q, s) <= 0 &&
         cross(r, s, p) * cross(r, s, q) <= 0;
}

// The conflicts name edges that meet, in an order of their own.
void expect_meetings(const Rings& rings, const std::vector<RingConflict>& conflicts) {
  for (const RingConflict& conflict : conflicts) {
    const auto& [e, f] = conflict;
    ASSERT_TRUE(e.ring < f.ring || (e.ring == f.ring && e.edge < f.edge));
    ASSERT_TRUE(edges_meet(rings[e.ring][e.edge], end_of(rings[e.ring], e.edge),
                           rings[f.ring][f.edge], end_of(rings[f.ring], f.edge)));
  }
}

TEST(RingConflicts, AreFoundBetweenTwoRings) {
  test::Random random(331);
  int conflicts = 0;
  int touches = 0;
  for (int k = 0; k < 3000; ++k) {
    const auto ring = [&](int extent) {
      const int vertices = test::uniform(random, 3, 7);
      return test::random_small_integer_polygon(random, vertices, extent);
    };
    const PointVector first = ring(k % 2 == 0 ? 9 : 5);
    const int x = test::uniform(random, -4, 6);
    const PointVector second = moved(ring(4), x, test::uniform(random, -4, 6));
    const Rings rings{first, second};
    const std::vector<RingConflict> found = find_ring_conflicts(rings);
    ASSERT_EQ(found.empty(), keep_apart(first, second)) << k;
    expect_meetings(rings, found);
    conflicts += found.empty() ? 0 : 1;
    const bool meet = are_rings_near(rings, 0);
    touches += found.empty() && meet ? 1 : 0;
  }
  EXPECT_GT(conflicts, 500);
  EXPECT_GT(touches, 100);
}

// With several rings, the conflicts are those of each pair.
TEST(RingConflicts, OfManyRingsAreThoseOfPairs) {
  test::Random random(332);
  std::size_t conflicts = 0;
  for (int k = 0; k < 150; ++k) {
    Rings rings;
    for (int r = test::uniform(random, 3, 6); r > 0; --r) {
      const int x = test::uniform(random, 0, 9);
      const int y = test::uniform(random, 0, 9);
      rings.push_back(moved(test::random_small_integer_polygon(random, 4, 4), x, y));
    }
    const std::vector<RingConflict> found = find_ring_conflicts(rings);
    expect_meetings(rings, found);
    conflicts += found.size();
    std::size_t expected = 0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
      for (std::size_t j = i + 1; j < rings.size(); ++j) {
        const std::size_t of_pair = find_ring_conflicts(Rings{rings[i], rings[j]}).size();
        expected += of_pair;
        const auto is_of_pair = [&](const RingConflict& c) {
          return c.first.ring == i && c.second.ring == j;
        };
        ASSERT_EQ(std::count_if(found.begin(), found.end(), is_of_pair),
                  static_cast<std::ptrdiff_t>(of_pair));
      }
    }
    ASSERT_EQ(found.size(), expected);
  }
  EXPECT_GT(conflicts, 500U);
}

TEST(RingConflicts, AreFoundInOneRing) {
  const PointVector bow_tie{{0, 0}, {4, 4}, {4, 0}, {0, 4}};
  const PointVector touching{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}};
  const PointVector simple{{10, 0}, {14, 0}, {14, 4}};
  const std::vector<RingConflict> of_bow_tie = find_ring_conflicts(Rings{simple, bow_tie});
  ASSERT_EQ(of_bow_tie.size(), 1U);
  EXPECT_EQ(of_bow_tie[0].first.ring, 1U);
  EXPECT_EQ(of_bow_tie[0].first.edge, 0U);
  EXPECT_EQ(of_bow_tie[0].second.edge, 2U);
  EXPECT_FALSE(find_ring_conflicts(Rings{touching}).empty());
  EXPECT_TRUE(find_ring_conflicts(Rings{simple}).empty());
  EXPECT_TRUE(find_ring_conflicts(Rings{}).empty());
}

// A corner that pokes through an edge exactly in a vertex of it, and one that does not.
TEST(RingConflicts, TellTouchingFromCrossing) {
  const PointVector square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const PointVector through{{4, 4}, {8, 2}, {5, 8}, {3, 3}};
  const PointVector beside{{4, 4}, {8, 2}, {5, 8}};
  EXPECT_FALSE(find_ring_conflicts(Rings{square, through}).empty());
  EXPECT_TRUE(find_ring_conflicts(Rings{square, beside}).empty());
  EXPECT_FALSE(find_ring_conflicts(Rings{square, square}).empty());
}

TEST(RingConflicts, RingsAreNear) {
  test::Random random(333);
  int near = 0;
  int far = 0;
  for (int k = 0; k < 500; ++k) {
    const PointVector first = test::random_small_integer_polygon(random, 5, 6);
    const int x = test::uniform(random, -12, 12);
    const PointVector second =
        moved(test::random_small_integer_polygon(random, 4, 4), x, test::uniform(random, -12, 12));
    const double distance = test::uniform(random, 0, 3);
    double least = 1000;
    for (std::size_t i = 0; i < first.size(); ++i) {
      for (std::size_t j = 0; j < second.size(); ++j) {
        const Box p = box_of(first[i], end_of(first, i));
        const Box q = box_of(second[j], end_of(second, j));
        least = std::min(least, std::max({p.x0 - q.x1, q.x0 - p.x1, p.y0 - q.y1, q.y0 - p.y1}));
      }
    }
    const bool are_near = are_rings_near(Rings{first, second}, distance);
    ASSERT_TRUE(are_near || least > distance);
    ASSERT_TRUE(!are_near || least <= 2 * distance);
    near += are_near ? 1 : 0;
    far += are_near ? 0 : 1;
  }
  EXPECT_GT(near, 50);
  EXPECT_GT(far, 50);
  EXPECT_FALSE(are_rings_near(Rings{{{0, 0}, {4, 0}, {4, 4}}}, 100));
}

}  // namespace
}  // namespace gcv
