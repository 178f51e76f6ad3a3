// SPDX-License-Identifier: LGPL-3.0-or-later
#include "exact_ring.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <memory>
#include <sstream>
#include <vector>

#include "generators.hpp"
#include "minkowski_sum.hpp"
#include "ring_predicates.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Ring;

using Rational = boost::multiprecision::mpq_rational;

struct Fractions {
  Rational x;
  Rational y;
};

Fractions vertex(const ExactRing& ring, std::size_t k) {
  std::istringstream text(exact_vertex(ring, k));
  Fractions p;
  text >> p.x >> p.y;
  return p;
}

ExactRing ring_of(const Ring& a, const Ring& b) {
  const auto operand = [](const Ring& ring, const char* name) {
    return Operand{std::make_shared<const gcv::Boundary>(make_ring(ring, name)), name};
  };
  Task task;
  return minkowski_sum(operand(a, "a"), operand(b, "b"), {0, 0}, Rounding::nearest, task).exact;
}

// Each vertex against the line of each edge, in fractions.
void expect_right_sides(const ExactRing& ring) {
  std::vector<Fractions> vertices;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    vertices.push_back(vertex(ring, k));
  }
  Tally tally;
  for (std::size_t e = 0; e < ring.size(); ++e) {
    const Fractions& p = vertices[e];
    const Fractions& q = vertices[e + 1 == ring.size() ? 0 : e + 1];
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Fractions& r = vertices[k];
      const Rational cross = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
      ASSERT_EQ(exact_side(ring, e, k, tally), cross.sign());
    }
  }
}

TEST(ExactRing, SidesOfVertices) {
  Random random(91);
  for (int k = 0; k < 20; ++k) {
    expect_right_sides(
        ring_of(test::random_spiky_star(random, 20), test::random_spiky_star(random, 16)));
    expect_right_sides(ring_of(test::random_small_integer_polygon(random, 12, 9),
                               test::random_histogram(random, 6, 5)));
  }
}

// Crossings of all lines of superset edges, many of which lie on lines of other edges.
TEST(ExactRing, SidesOfCrossingsOfAllEdges) {
  Random random(94);
  int on_line = 0;
  for (int k = 0; k < 8; ++k) {
    const gcv::Boundary a = make_ring(test::random_small_integer_polygon(random, 4, 4), "a");
    const gcv::Boundary b = make_ring(test::random_histogram(random, 2, 4), "b");
    std::vector<EdgeName> names;
    for (Index i = 0; i < a.size(); ++i) {
      for (Index j = 0; j < b.size(); ++j) {
        names.push_back({EdgeName::translated, i, j});
        names.push_back({EdgeName::corner, i, j});
      }
    }
    // Small integers, and so are all products.
    const auto cross = [](const Fractions& v, const Fractions& w) {
      return Rational(v.x * w.y - v.y * w.x);
    };
    const auto origin = [](const SumEdge& e) {
      return Fractions{e.origin.a.x + e.origin.b.x, e.origin.a.y + e.origin.b.y};
    };
    const auto direction = [](const SumEdge& e) { return Fractions{e.dx, e.dy}; };
    const auto between = [](const Fractions& p, const Fractions& q) {
      return Fractions{q.x - p.x, q.y - p.y};
    };
    Tally tally;
    for (const EdgeName& first : names) {
      for (const EdgeName& second : names) {
        const SumEdge s = coordinates(a, b, first);
        const SumEdge t = coordinates(a, b, second);
        const Rational turn = cross(direction(s), direction(t));
        if (turn == 0) {
          continue;
        }
        const Fractions o = origin(s);
        const Rational lambda = cross(between(o, origin(t)), direction(t)) / turn;
        const Fractions p{o.x + lambda * s.dx, o.y + lambda * s.dy};
        const RingVertex vertex = RingVertex::crossing(first, second);
        for (const EdgeName& name : names) {
          const SumEdge line = coordinates(a, b, name);
          const int side = cross(direction(line), between(origin(line), p)).sign();
          ASSERT_EQ(side_of_vertex(a, b, line, vertex, tally), side);
          on_line += side == 0 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(on_line, 10000);
}

// Vertices next to lines, by a few units in the last place, far from the origin and next to it.
TEST(ExactRing, SidesOfVerticesNextToLines) {
  Random random(92);
  for (int k = 0; k < 20; ++k) {
    const Ring a = test::random_spiky_star(random, 16);
    Ring b = test::negated(a);
    for (Point& p : b) {
      p = {std::ldexp(p.x, -40 - k), std::ldexp(p.y, -40 - k)};
    }
    expect_right_sides(ring_of(a, b));
    Ring far = a;
    for (Point& p : far) {
      p = {p.x + 0x1p40, p.y - 0x1p40};
    }
    expect_right_sides(ring_of(far, b));
  }
}

TEST(ExactRing, SidesAtTheEndsOfTheRange) {
  Random random(93);
  for (const int exponent : {-1070, -1000, -500, 480, 1010}) {
    for (int k = 0; k < 5; ++k) {
      Ring a = test::random_spiky_star(random, 16);
      Ring b = test::random_spiky_star(random, 12);
      for (Ring* const ring : {&a, &b}) {
        for (Point& p : *ring) {
          p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
        }
      }
      expect_right_sides(ring_of(a, b));
    }
  }
}

}  // namespace
}  // namespace gcv
