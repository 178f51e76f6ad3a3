// SPDX-License-Identifier: LGPL-3.0-or-later
#include "covered_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "boundary.hpp"
#include "chord_tree.hpp"
#include "convex_sums.hpp"
#include "directions.hpp"
#include "generators.hpp"
#include "solid_cells.hpp"
#include "tree_product.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Ring;

double turn(const Point& p, const Point& q, const Point& r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

bool cross(const Point& p, const Point& q, const Point& r, const Point& s) {
  return turn(p, q, r) * turn(p, q, s) < 0 && turn(r, s, p) * turn(r, s, q) < 0;
}

bool is_inside(const Ring& ring, const Point& x) {
  bool result = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point& p = ring[k];
    const Point& q = ring[(k + 1) % ring.size()];
    if ((p.y > x.y) != (q.y > x.y) && (turn(p, q, x) > 0) == (q.y > p.y)) {
      result = !result;
    }
  }
  return result;
}

// A pair of polygons by their vertices, relative to the first ones.
struct Pair {
  Boundary a;
  Boundary b;
  Ring ring_a;
  Ring ring_b;

  static Ring relative(const Boundary& polygon) {
    Ring ring;
    for (Index i = 0; i < polygon.size(); ++i) {
      ring.push_back(polygon.relative(i));
    }
    return ring;
  }
  Pair(const Ring& p, const Ring& q)
      : a(make_ring(p, "A")), b(make_ring(q, "B")), ring_a(relative(a)), ring_b(relative(b)) {}

  // Is x, in relative coordinates, in the open sum? By the definition: A and x - B overlap.
  [[nodiscard]] bool is_in_sum(const Point& x) const {
    Ring turned;
    for (const Point& p : ring_b) {
      turned.push_back({x.x - p.x, x.y - p.y});
    }
    for (std::size_t i = 0; i < ring_a.size(); ++i) {
      for (std::size_t j = 0; j < turned.size(); ++j) {
        if (cross(ring_a[i], ring_a[(i + 1) % ring_a.size()], turned[j],
                  turned[(j + 1) % turned.size()])) {
          return true;
        }
      }
    }
    return is_inside(ring_a, turned.front()) || is_inside(turned, ring_a.front());
  }
};

class Grid {
 public:
  // In focus are the two thirds in the middle, both ways; or all.
  explicit Grid(const Pair& pair, bool has_focus = false)
      : pair_(pair),
        tally_{},
        operands_{pair.a, pair.b, merge_directions(pair.a, pair.b, tally_)},
        cells_(has_focus ? focused() : operands_, slack_of(operands_)) {}

  void add_all_witnesses() {
    const ChordTree& a = pair_.a.cover_index().chords;
    const ChordTree& b = pair_.b.cover_index().chords;
    const auto for_each_node = [](const ChordTree& tree, auto visit) {
      for (ChordTree::Node node = 0; node < tree.blocks.size() * ChordTree::width; ++node) {
        if ((tree.block_of(node).lanes >> ChordTree::lane_of(node) & 1U) != 0) {
          visit(node);
        }
      }
    };
    for_each_node(a, [&](ChordTree::Node p) {
      for_each_node(b, [&](ChordTree::Node q) {
        cells_.add(Witness(Chord::of(a, p), Chord::of(b, q), slack_of(operands_)));
      });
    });
  }

  // Points of lines and boxes that covered cells are said to hold are in the open sum. Returns how
  // much of the lines they hold.
  double check(Random& random, int lines) const {
    const Box box = operands_.relative_bounds();
    // No vertex lies on an edge there, as may be where a cell ends.
    const auto share = [&] { return (test::uniform(random, 0, 1000) + 0.3717) / 1001; };
    const auto place = [&] {
      const double x = box.x0 + (box.x1 - box.x0) * share();
      return Point{x, box.y0 + (box.y1 - box.y0) * share()};
    };
    double held = 0;
    for (int k = 0; k < lines; ++k) {
      const Point p = place();
      const Point q = place();
      const RelativeLine line{p, q.x - p.x, q.y - p.y};
      const double end = cells_.reach(line, 0);
      EXPECT_LE(end, 1);
      held += end;
      for (const double part : {0.0, 0.25, 0.5, 0.75, 0.9999}) {
        if (end > 0) {
          EXPECT_TRUE(pair_.is_in_sum(line.at(part * end)));
        }
      }
      // On its way it is in covered cells.
      for (double t = 0; t < end; t += 0x1p-9) {
        const Point x = line.at(t);
        EXPECT_TRUE(cells_.hold({x.x, x.y, x.x, x.y}));
      }
      const Box around{p.x - 0.02 * (box.x1 - box.x0), p.y - 0.03 * (box.y1 - box.y0),
                       p.x + 0.03 * (box.x1 - box.x0), p.y + 0.02 * (box.y1 - box.y0)};
      if (box.x0 < around.x0 && around.x1 < box.x1 && box.y0 < around.y0 && around.y1 < box.y1 &&
          cells_.hold(around)) {
        for (const Point& corner : {Point{around.x0, around.y0}, Point{around.x1, around.y0},
                                    Point{around.x0, around.y1}, Point{around.x1, around.y1}}) {
          EXPECT_TRUE(pair_.is_in_sum(corner));
        }
      }
    }
    return held / lines;
  }

 private:
  const Operands& focused() {
    const Box box = operands_.relative_bounds();
    const double x = (box.x1 - box.x0) / 6;
    const double y = (box.y1 - box.y0) / 6;
    operands_.focus = {box.x0 + x, box.y0 + y, box.x1 - x, box.y1 - y};
    return operands_;
  }

  const Pair& pair_;
  Tally tally_;
  Operands operands_;
  CoveredCells cells_;
};

bool meets(const Point& p, const Point& q, const Box& box) {
  if (std::max(p.x, q.x) < box.x0 || std::min(p.x, q.x) > box.x1 || std::max(p.y, q.y) < box.y0 ||
      std::min(p.y, q.y) > box.y1) {
    return false;
  }
  int left = 0;
  int right = 0;
  for (const Point& corner : {Point{box.x0, box.y0}, Point{box.x1, box.y0}, Point{box.x1, box.y1},
                              Point{box.x0, box.y1}}) {
    left += turn(p, q, corner) > 0 ? 1 : 0;
    right += turn(p, q, corner) < 0 ? 1 : 0;
  }
  return left < 4 && right < 4;
}

// On the lines of the grid, too, an edge is in the cells on both sides.
TEST(SolidCells, AreThoseThatNoEdgeMeets) {
  Random random(3);
  constexpr double margin = 0x1p-20;
  std::size_t found = 0;
  for (int k = 0; k < 60; ++k) {
    for (const Ring& ring : {test::random_histogram(random, 3 + k / 4, 40),
                             test::random_small_integer_polygon(random, 4 + k / 8, 30)}) {
      const Boundary solid = make_ring(ring, "A");
      const Ring vertices = Pair::relative(solid);
      const Box bounds = solid.relative_bounds();
      const auto columns = static_cast<std::size_t>(bounds.x1 - bounds.x0) + 1;
      const auto rows = static_cast<std::size_t>(bounds.y1 - bounds.y0) + 1;
      std::vector<std::vector<bool>> is_in(rows, std::vector<bool>(columns));
      for (const auto& [row, from, to] : cells_inside(solid, bounds, {1, 1}, margin)) {
        for (std::uint32_t column = from; column < to; ++column) {
          is_in[row][column] = true;
          ++found;
        }
      }
      for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
          const double x = bounds.x0 + static_cast<double>(column);
          const double y = bounds.y0 + static_cast<double>(row);
          const Box cell{x - margin, y - margin, x + 1 + margin, y + 1 + margin};
          bool is_free = is_inside(vertices, {x + 0.5, y + 0.5});
          for (std::size_t i = 0; i < vertices.size() && is_free; ++i) {
            is_free = !meets(vertices[i], vertices[(i + 1) % vertices.size()], cell);
          }
          EXPECT_EQ(is_in[row][column], is_free) << k << ": " << column << ' ' << row;
        }
      }
    }
  }
  EXPECT_GT(found, 4000);
}

TEST(CoveredCells, LieInTheOpenSum) {
  Random random(1);
  double by_solids = 0;
  double with_witnesses = 0;
  double in_focus = 0;
  for (int k = 0; k < 12; ++k) {
    const std::array<Ring, 3> rings = {test::random_spiky_star(random, 10 + 6 * k),
                                       test::random_histogram(random, 5 + k, 40),
                                       test::random_small_integer_polygon(random, 8 + k, 12)};
    for (const Ring& p : rings) {
      for (const Ring& q : rings) {
        const Pair pair(p, q);
        Grid grid(pair);
        Random same_lines = random;
        by_solids += grid.check(same_lines, 20);
        grid.add_all_witnesses();
        with_witnesses += grid.check(random, 20);
        // Much smaller than the focus, so that lines leave the grid.
        Ring small = q;
        for (Point& x : small) {
          x = {x.x / 16, x.y / 16};
        }
        in_focus += Grid(Pair(p, small), true).check(random, 40);
      }
    }
  }
  // What is held of lines, on an average. So the test tests something.
  EXPECT_GT(by_solids / 108, 0.1);
  EXPECT_GT(with_witnesses, by_solids);
  EXPECT_GT(in_focus / 108, 0.05);
}

// The solid is outside of the ring, and in what was a hole.
TEST(CoveredCells, LieInTheOpenSumOfAComplement) {
  const Boundary outer = make_ring({{0, 0}, {100, 0}, {100, 100}, {0, 100}}, "container");
  const Boundary hole =
      make_ring({{40, 40}, {60, 40}, {60, 60}, {40, 60}}, "hole", Boundary::Kind::hole);
  const Boundary container = joined(outer, std::array{&hole}).complement();
  Ring ring;  // enough vertices for a grid
  for (int k = 0; k < 40; ++k) {
    const double low = k % 2 == 0 ? 0 : 0.25;
    ring.push_back({k * 0.5, low});
  }
  ring.insert(ring.end(), {{20, 0}, {20, 20}, {0, 20}});
  const Boundary b = make_ring(ring, "B");
  Tally tally;
  const Operands operands{container, b, merge_directions(container, b, tally)};
  const CoveredCells cells(operands, slack_of(operands));
  const auto holds = [&](double x, double y) {
    const Point& p = container.vertices.front();
    const Point& q = b.vertices.front();
    const Point at{x - p.x - q.x, y - p.y - q.y};
    return cells.hold({at.x, at.y, at.x, at.y});
  };
  EXPECT_TRUE(holds(60, 60));
  EXPECT_FALSE(holds(30, 30));
  EXPECT_FALSE(holds(90, 90));
  EXPECT_FALSE(holds(21, 99));
  EXPECT_FALSE(holds(39, 60));
}

// Cells are so small that some lie inside each brick of a wall.
TEST(CoveredCells, LieInTheOpenSumOfBricks) {
  constexpr int side = 40;
  const Boundary brick = make_ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, "brick");
  std::vector<PlacedBoundary> bricks;
  for (int k = 0; k < side * side; ++k) {
    bricks.push_back({brick, {2.0 * (k % side), 2.0 * (k / side)}});
  }
  const Boundary wall = joined(bricks);
  const Boundary b = make_ring({{0, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}, "B");
  Tally tally;
  for (const bool is_wall_first : {true, false}) {
    const Boundary& first = is_wall_first ? wall : b;
    const Boundary& second = is_wall_first ? b : wall;
    const Operands operands{first, second, merge_directions(first, second, tally)};
    CoveredCells cells(operands, slack_of(operands));
    ConvexSums sums(operands, slack_of(operands), cells);
    for (int k = 0; k < side; ++k) {
      // They are added where sums are asked.
      for (const Point& corner : {Point{2.0 * k + 0.5, 0.5}, Point{0.5, 2.0 * k + 0.5}}) {
        EXPECT_EQ(sums.hold(box_of(corner, corner)), is_wall_first);
      }
      const auto holds = [&](double x, double y) { return cells.hold({x, y, x, y}); };
      EXPECT_TRUE(holds(2 * k + 0.75, 0.75)) << k;
      EXPECT_TRUE(holds(0.75, 2 * k + 0.75)) << k;
      EXPECT_FALSE(holds(2 * k + 1.75, 0.75)) << k;
      EXPECT_FALSE(holds(0.75, 2 * k + 1.55)) << k;
    }
  }
}

// Where a cell is as small as a rounding error, none is covered.
TEST(CoveredCells, HoldNothingOfNeedles) {
  const Pair pair({{0, 0}, {1, 0}, {1, 1e-15}, {0.5, 5e-16}}, {{0, 0}, {1, 0}, {1, 1e-15}});
  Grid grid(pair);
  grid.add_all_witnesses();
  Random random(2);
  EXPECT_EQ(grid.check(random, 50), 0);
}

}  // namespace
}  // namespace gcv
