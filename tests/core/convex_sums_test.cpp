// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Convex pieces of small polygons, in fractions; and their sums, in the open sum of a scene and a
// polygon.
#include "convex_sums.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "convex_pieces.hpp"
#include "exact_pieces.hpp"
#include "exact_rings.hpp"
#include "generators.hpp"
#include "tree_product.hpp"
#include "witness_search.hpp"

namespace gcv {
namespace {

using invariants::Exact;
using invariants::Rational;
using test::Random;
using test::Ring;

Ring random_ring(Random& random, int k) {
  const int n = 3 + k % 11;
  return k % 4 == 0   ? test::random_histogram(random, 2 + n / 2, 5)
         : k % 4 == 1 ? test::random_small_integer_polygon(random, n, 7)
         : k % 4 == 2 ? test::random_spiky_star(random, n)
                      : test::random_small_integer_polygon(random, n, 1000);
}

TEST(ConvexPieces, AreConvexAndLieInTheRing) {
  Random random(412);
  int whole = 0;
  for (int k = 0; k < 400; ++k) {
    const Boundary ring = make_ring(random_ring(random, k), "ring");
    ASSERT_LE(ring.size(), 32U);
    const ConvexPieces pieces = find_convex_pieces(ring.vertices);
    const invariants::Ring exact_ring = test::exact(ring.vertices);
    ASSERT_GT(pieces.count(), 0U);
    ASSERT_LE(pieces.count(), 4U);
    Rational area = 0;
    Rational before = invariants::twice_area(exact_ring);
    std::vector<invariants::Ring> others;
    for (std::size_t n = 0; n < pieces.count(); ++n) {
      invariants::Ring piece;
      for (const Index i : pieces.piece(n)) {
        piece.push_back(exact_ring[i]);
      }
      for (std::size_t i = 0; i < piece.size(); ++i) {
        const Exact& p = piece[i];
        const Exact& q = invariants::next(piece, i);
        ASSERT_GE(invariants::cross(q - p, invariants::next(piece, (i + 1) % piece.size()) - q), 0);
      }
      const invariants::Sides sides = invariants::sides(piece, exact_ring);
      ASSERT_FALSE(sides.outside);
      for (const invariants::Ring& other : others) {
        ASSERT_FALSE(invariants::interiors_overlap(piece, other));
      }
      ASSERT_LE(invariants::twice_area(piece), before + before / 1000000);  // the largest first
      before = invariants::twice_area(piece);
      area += before;
      others.push_back(piece);
    }
    ASSERT_LE(area, invariants::twice_area(exact_ring));
    whole += area == invariants::twice_area(exact_ring) ? 1 : 0;
    if (ring.is_convex) {
      ASSERT_EQ(pieces.count(), 1U);
      ASSERT_EQ(area, invariants::twice_area(exact_ring));
    }
  }
  EXPECT_GT(whole, 150);
}

// Squares of distances overflow, or are below the smallest double.
TEST(ConvexPieces, OfHugeAndTinyRings) {
  for (const double size : {0x1p1000, 0x1p-1060}) {
    Ring ring{{0, 0}, {4, 0}, {4, 4}, {3, 1}, {2, 4}, {1, 1}, {0, 4}};
    for (Point& p : ring) {
      p = {size * p.x, size * p.y};
    }
    EXPECT_GT(find_convex_pieces(ring).count(), 1U);
  }
  Ring large;  // of too many vertices
  for (int k = 0; k < 40; ++k) {
    large.push_back({k * 1.0, k % 2 * 1.0});
  }
  large.push_back({20, 90});
  EXPECT_EQ(find_convex_pieces(make_ring(large, "ring").vertices).count(), 0U);
}

// A strip of small integers, with members in it.
struct SmallScene {
  Boundary container;
  std::vector<Boundary> shapes;
  std::vector<Point> positions;
  Boundary moving;
  Boundary solids;
  Tally tally = {};
  Operands operands;

  static Boundary join(const SmallScene& scene) {
    std::vector<PlacedBoundary> parts{{scene.container, {0, 0}}};
    for (std::size_t k = 0; k < scene.shapes.size(); ++k) {
      parts.push_back({scene.shapes[k], scene.positions[k]});
    }
    return joined(parts);
  }
  SmallScene(Random& random, int k)
      : container(make_ring({{0, 0}, {40, 0}, {40, 12}, {0, 12}}, "container").complement()),
        shapes(members(random, k)),
        positions(places(random, shapes.size())),
        moving(make_ring(random_ring(random, 4 * k + 1), "moving")),
        solids(join(*this)),
        operands{solids, moving, merge_directions(solids, moving, tally)} {}

  static std::vector<Boundary> members(Random& random, int k) {
    std::vector<Boundary> shapes;
    for (int n = 0; n < 1 + k % 12; ++n) {
      shapes.push_back(make_ring(random_ring(random, 4 * (k + n) + n % 2), "member"));
    }
    return shapes;
  }
  static std::vector<Point> places(Random& random, std::size_t count) {
    std::vector<Point> positions(count);
    for (Point& p : positions) {
      p = {test::uniform(random, 0, 36) * 1.0, test::uniform(random, 0, 8) * 1.0};
    }
    return positions;
  }

  // Is the point, in relative coordinates, in the open sum? By the definition.
  [[nodiscard]] bool covers(const Exact& x) const {
    const Exact place =
        x + test::exact(solids.vertices.front()) + test::exact(moving.vertices.front());
    invariants::Ring reflected;
    bool is_out = false;
    for (const Point& p : moving.vertices) {
      const Exact at = place - test::exact(p);
      is_out = is_out || at.x < 0 || at.y < 0 || at.x > 40 || at.y > 12;
      reflected.push_back(at);
    }
    for (std::size_t k = 0; k < shapes.size() && !is_out; ++k) {
      invariants::Ring member;
      for (const Point& p : shapes[k].vertices) {
        member.push_back(test::exact(p) + test::exact(positions[k]));
      }
      is_out = invariants::interiors_overlap(member, reflected);
    }
    return is_out;
  }
};

TEST(ConvexSums, LieInTheOpenSum) {
  Random random(413);
  int reached = 0;
  int held = 0;
  int held_by_cells = 0;
  for (int k = 0; k < 40; ++k) {
    const SmallScene scene(random, k);
    CoveredCells cells(scene.operands, slack_of(scene.operands));
    ConvexSums sums(scene.operands, slack_of(scene.operands), cells);
    ASSERT_FALSE(sums.is_empty());
    const auto place = [&] {
      return Point{test::uniform(random, -20, 180) * 0.25, test::uniform(random, -20, 70) * 0.25};
    };
    for (int n = 0; n < 60; ++n) {
      const Point p = place();
      const Point q = n % 3 == 0   ? Point{p.x, place().y}
                      : n % 3 == 1 ? Point{place().x, p.y}
                                   : place();
      if (p == q) {
        continue;
      }
      const RelativeLine line{p, q.x - p.x, q.y - p.y};
      const double start = 0.125 * test::uniform(random, 0, 4);
      const double end = sums.reach(line, start, 0x1p-20);
      ASSERT_GE(end, start);
      ASSERT_LE(end, 1);
      for (const double part : {0.0, 0.375, 0.625, 1.0}) {
        const Rational t = Rational(start) + Rational(part) * (Rational(end) - Rational(start));
        ASSERT_TRUE(end == start ||
                    scene.covers(test::exact(p) + t * Exact{Rational(line.dx), Rational(line.dy)}));
      }
      reached += end > start ? 1 : 0;
      const Box box = box_of(p, {p.x + 0.5, p.y + 0.25});
      held += sums.hold(box) ? 1 : 0;
      held_by_cells += cells.hold(box) ? 1 : 0;
      if (sums.hold(box) || cells.hold(box)) {
        for (const Point& corner :
             {Point{box.x0, box.y0}, Point{box.x1, box.y0}, Point{box.x1, box.y1}}) {
          ASSERT_TRUE(scene.covers(test::exact(corner)));
        }
      }
    }
  }
  EXPECT_GT(reached, 800);
  EXPECT_GT(held, 800);
  EXPECT_GT(held_by_cells, 700);
}

// Products of coordinates overflow.
TEST(ConvexSums, AreNotAskedInHugeScenes) {
  for (const double size : {1.0, 0x1p600}) {
    const double side = 9 * size;
    const Boundary outside =
        make_ring({{0, 0}, {side, 0}, {side, side}, {0, side}}, "container").complement();
    const Boundary triangle = make_ring({{0, 0}, {2 * size, 0}, {2 * size, 2 * size}}, "triangle");
    const Boundary all =
        joined(std::vector<PlacedBoundary>{{outside, {0, 0}}, {triangle, {3 * size, 4 * size}}});
    Tally tally;
    const Operands operands{all, triangle, merge_directions(all, triangle, tally)};
    WitnessSearch search(operands);
    const Point inside{6 * size, 5 * size};
    const Point free{4 * size, 7 * size};
    EXPECT_EQ(search.covers({inside.x, inside.y, inside.x, inside.y}), size == 1);
    EXPECT_FALSE(search.covers({free.x, free.y, free.x, free.y}));
    search.begin({free, size, 0});
    EXPECT_EQ(search.reach(0), 0);
    search.begin({inside, free.x - inside.x, free.y - inside.y});
    EXPECT_LT(search.reach(0), 0.5);  // where it leaves the sum of the triangles
  }
}

// A line that goes along the side of a sum is not in it.
TEST(ConvexSums, AreOpen) {
  const Boundary outside = make_ring({{0, 0}, {9, 0}, {9, 9}, {0, 9}}, "container").complement();
  const Boundary square = make_ring({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, "square");
  const Boundary all = joined(std::vector<PlacedBoundary>{{outside, {0, 0}}, {square, {3, 4}}});
  Tally tally;
  const Operands operands{all, square, merge_directions(all, square, tally)};
  CoveredCells cells(operands, slack_of(operands));
  ConvexSums sums(operands, slack_of(operands), cells);
  // The sum of the squares is from (3, 4) to (7, 8).
  EXPECT_EQ(sums.reach({{3, 5}, 0, 1}, 0, 0x1p-20), 0);
  EXPECT_EQ(sums.reach({{5, 8}, 1, 0}, 0, 0x1p-20), 0);
  EXPECT_NEAR(sums.reach({{5, 5}, 4, 0}, 0, 0x1p-20), 0.5, 1e-9);
  EXPECT_LT(sums.reach({{5, 5}, 4, 0}, 0, 0x1p-20), 0.5);
  EXPECT_EQ(sums.reach({{3, 5}, 4, 0}, 0.25, 0x1p-20),
            sums.reach({{5, 5}, 2, 0}, 0, 0x1p-20) / 2 + 0.5);
  EXPECT_FALSE(sums.hold({3, 5, 4, 6}));
  EXPECT_TRUE(sums.hold({3.125, 5, 4, 6}));
  // Beyond the container: from (2, 2) to (9, 9) a square's reflection is free of it.
  EXPECT_EQ(sums.reach({{2, 0}, 0, 9}, 0, 0x1p-20), sums.reach({{2.5, 0}, 0, 9}, 0, 0x1p-20));
  EXPECT_EQ(sums.reach({{1, 3}, 0, 3}, 0, 0x1p-20), 1);
  EXPECT_EQ(sums.reach({{2, 3}, 0, 3}, 0, 0x1p-20), 0);
  EXPECT_EQ(sums.reach({{10, 3}, -2, 0}, 1, 0x1p-20), 1);
  EXPECT_LT(sums.reach({{10, 5}, -2, 0}, 0, 0x1p-20), 0.5);
}

}  // namespace
}  // namespace gcv
