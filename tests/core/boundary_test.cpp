// SPDX-License-Identifier: LGPL-3.0-or-later
#include "boundary.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "area.hpp"
#include "error.hpp"
#include "generators.hpp"
#include "numbers.hpp"
#include "polygon.hpp"
#include "region_families.hpp"
#include "vector.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Rational;
using test::rational;
using test::Ring;

Status status_of(const Ring& ring) {
  try {
    make_ring(ring, "polygon");
    return Status::ok;
  } catch (const Error& error) {
    return error.status();
  }
}

std::string message_of(const Ring& ring) {
  try {
    make_ring(ring, "polygon");
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

std::vector<Index> vertex_numbers(const gcv::Boundary& polygon) {
  std::vector<Index> numbers;
  for (const gcv::Boundary::Corner& corner : polygon.corners) {
    numbers.push_back(corner.vertex_number);
  }
  return numbers;
}

std::vector<Index> edge_numbers(const gcv::Boundary& polygon) {
  std::vector<Index> numbers;
  for (const gcv::Boundary::Corner& corner : polygon.corners) {
    numbers.push_back(corner.edge_number);
  }
  return numbers;
}

const Ring square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};

TEST(Boundary, IsNormalised) {
  // Clockwise, closed, with repeated and collinear vertices, from elsewhere.
  const Ring ring{{2, 2}, {2, 2}, {2, 1}, {2, 0}, {1, 0}, {0, 0}, {0, 0}, {0, 2}, {2, 2}};
  const gcv::Boundary polygon = make_ring(ring, "polygon");
  EXPECT_EQ(polygon.vertices, square);
  EXPECT_EQ(vertex_numbers(polygon), (std::vector<Index>{6, 3, 1, 7}));
  // Counter-clockwise, the edge behind (0, 0) is the caller's from (1, 0) to (0, 0).
  EXPECT_EQ(edge_numbers(polygon), (std::vector<Index>{4, 2, 7, 6}));
}

TEST(Boundary, KeepsNumbersOfCounterClockwiseInput) {
  const Ring ring{{2, 0}, {2, 1}, {2, 2}, {0, 2}, {0, 0}, {1, 0}};
  const gcv::Boundary polygon = make_ring(ring, "polygon");
  EXPECT_EQ(polygon.vertices, square);
  EXPECT_EQ(vertex_numbers(polygon), (std::vector<Index>{4, 0, 2, 3}));
  EXPECT_EQ(edge_numbers(polygon), (std::vector<Index>{4, 0, 2, 3}));
}

TEST(Boundary, NegativeZeroBecomesZero) {
  const gcv::Boundary polygon = make_ring(Ring{{-0.0, 0}, {1, -0.0}, {0, 1}}, "polygon");
  for (const Point& p : polygon.vertices) {
    EXPECT_FALSE(std::signbit(p.x));
    EXPECT_FALSE(std::signbit(p.y));
  }
}

TEST(Boundary, OrientationFarFromTheOrigin) {
  // A shoelace sum in doubles has the wrong sign here.
  const double far = 1e15;
  Ring ring{
      {far, far}, {far + 1, far}, {far + 1, far + 1}, {far + 0.5, far + 0.25}, {far, far + 1}};
  const gcv::Boundary forward = make_ring(ring, "polygon");
  std::reverse(ring.begin(), ring.end());
  const gcv::Boundary backward = make_ring(ring, "polygon");
  EXPECT_EQ(forward.vertices, backward.vertices);
  ASSERT_EQ(forward.size(), backward.size());
  for (Index i = 0; i < forward.size(); ++i) {
    EXPECT_EQ(forward.corners[i].convex, backward.corners[i].convex);
  }
  EXPECT_EQ(ring_area(forward.vertices), 0.625);
}

TEST(Boundary, Refusals) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(status_of({}), Status::degenerate);
  EXPECT_EQ(status_of({{1, 1}}), Status::degenerate);
  EXPECT_EQ(status_of({{1, 1}, {2, 2}}), Status::degenerate);
  EXPECT_EQ(status_of({{1, 1}, {1, 1}, {1, 1}, {1, 1}}), Status::degenerate);
  EXPECT_EQ(status_of({{1, 1}, {2, 2}, {3, 3}, {0, 0}}), Status::degenerate);
  EXPECT_EQ(status_of({{0, 0}, {1, nan}, {1, 1}}), Status::not_finite);
  EXPECT_EQ(status_of({{0, 0}, {1, 0}, {-inf, 1}}), Status::not_finite);
  EXPECT_EQ(status_of({{0, 0}, {2, 2}, {2, 0}, {0, 2}}), Status::not_simple);          // bow-tie
  EXPECT_EQ(status_of({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}}), Status::not_simple);  // touch
  EXPECT_EQ(status_of({{0, 0}, {4, 0}, {6, 0}, {4, 0}, {4, 4}}), Status::not_simple);  // spike
  EXPECT_EQ(status_of({{0, 0}, {2, 0}, {2, 2}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}),
            Status::not_simple);
  EXPECT_NE(message_of({{0, 0}, {1, nan}, {1, 1}}).find("the y coordinate of vertex 1 is nan"),
            std::string::npos);
  EXPECT_NE(message_of({{0, 0}, {4, 0}, {4, 4}, {4, 2}, {0, 4}})
                .find("edges 1 and 2 overlap: the ring turns back at vertex 2 (4, 4)"),
            std::string::npos);
  EXPECT_NE(message_of({{0, 0}, {2, 2}, {2, 0}, {0, 2}}).find("edges 0 and 2 meet"),
            std::string::npos);
}

TEST(Boundary, DirectionsAreSortedExactly) {
  Random random(5);
  for (int k = 0; k < 500; ++k) {
    const gcv::Boundary polygon =
        make_ring(k % 2 == 0 ? test::random_small_integer_polygon(random, 8, 6)
                             : test::random_spiky_star(random, 20),
                  "polygon");
    const auto direction = [&](Index i) {
      const Point& p = polygon.vertices[i];
      const Point& q = polygon.vertices[polygon.next(i)];
      const bool up = polygon.line_directions().edges[i].points_up;
      return up ? std::pair(rational(q.x) - rational(p.x), rational(q.y) - rational(p.y))
                : std::pair(rational(p.x) - rational(q.x), rational(p.y) - rational(q.y));
    };
    const auto& edges = polygon.line_directions().edges;
    for (Index i = 0; i < polygon.size(); ++i) {
      const auto d = direction(i);
      ASSERT_TRUE(d.second > 0 || (d.second == 0 && d.first > 0));
      for (Index j = 0; j < polygon.size(); ++j) {
        const auto e = direction(j);
        const int turn = Rational(d.first * e.second - d.second * e.first).sign();
        const int order = edges[i].line < edges[j].line   ? 1
                          : edges[i].line > edges[j].line ? -1
                                                          : 0;
        ASSERT_EQ(turn, order);
      }
    }
  }
}

TEST(Boundary, ReflectionIsThePolygonOfTheReflectedRing) {
  Random random(6);
  for (int k = 0; k < 200; ++k) {
    const Ring ring = test::random_small_integer_polygon(random, 9, 8);
    const gcv::Boundary reflection =
        gcv::Boundary::reflected(std::make_shared<gcv::Boundary>(make_ring(ring, "polygon")));
    const gcv::Boundary expected = make_ring(test::negated(ring), "polygon");
    const auto shift = reflection.lexicographic_min;
    ASSERT_EQ(reflection.size(), expected.size());
    for (Index i = 0; i < expected.size(); ++i) {
      const Index j = (i + shift) % expected.size();
      ASSERT_EQ(reflection.vertices[j], expected.vertices[i]);
      ASSERT_EQ(reflection.corners[j].vertex_number, expected.corners[i].vertex_number);
      ASSERT_EQ(reflection.corners[j].edge_number, expected.corners[i].edge_number);
      ASSERT_EQ(reflection.corners[j].convex, expected.corners[i].convex);
      const auto& edge = reflection.line_directions().edges[j];
      const auto& expected_edge = expected.line_directions().edges[i];
      ASSERT_EQ(edge.line, expected_edge.line);
      ASSERT_EQ(edge.points_up, expected_edge.points_up);
    }
  }
}

TEST(Area, IsCorrectlyRounded) {
  Random random(8);
  for (int k = 0; k < 2000; ++k) {
    const int scale = k % 3 == 0 ? 0 : test::uniform(random, -500, 400);
    Ring ring = test::random_spiky_star(random, 3 + k % 12);
    for (Point& p : ring) {
      p = {std::ldexp(p.x, scale) + (k % 5 == 0 ? std::ldexp(1.0, scale + 40) : 0),
           std::ldexp(p.y, scale)};
    }
    Rational twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point& p = ring[i];
      const Point& q = ring[(i + 1) % ring.size()];
      twice += rational(p.x) * rational(q.y) - rational(q.x) * rational(p.y);
    }
    const Rational exact = twice / 2;
    const double area = ring_area(ring);
    const auto error = [&](double value) { return Rational(abs(rational(value) - exact)); };
    ASSERT_LE(error(area), error(std::nextafter(area, HUGE_VAL)));
    ASSERT_LE(error(area), error(std::nextafter(area, -HUGE_VAL)));
  }
}

// The edge from p to q is that from q to p of the complement, with the same number.
TEST(Boundary, HasAComplement) {
  Random random(71);
  std::size_t rings = 0;
  for (int k = 0; k < 100; ++k) {
    const test::RegionCase c = test::with_holes(random);
    const Polygon polygon = make_polygon(c.a, "polygon");
    const gcv::Boundary& boundary = polygon.boundary();
    const gcv::Boundary complement = boundary.complement();
    rings += polygon.ring_count();
    ASSERT_EQ(complement.size(), boundary.size());
    ASSERT_EQ(complement.layout.ring_count(), boundary.layout.ring_count());
    ASSERT_EQ(complement.kind, gcv::Boundary::Kind::hole);
    ASSERT_EQ(complement.lexicographic_min, 0U);
    ASSERT_EQ(complement.vertices[complement.lexicographic_max],
              boundary.vertices[boundary.lexicographic_max]);
    ASSERT_EQ(complement.bounds.x0, boundary.bounds.x0);
    ASSERT_EQ(complement.bounds.y1, boundary.bounds.y1);
    for (Index ring = 0; ring < boundary.layout.ring_count(); ++ring) {
      ASSERT_EQ(complement.layout.begin(ring), boundary.layout.begin(ring));
      Index there = boundary.layout.begin(ring);
      for (Index i = there; i < boundary.layout.end(ring); ++i) {
        const Index before = boundary.previous(there);
        ASSERT_EQ(complement.vertices[i], boundary.vertices[there]);
        ASSERT_EQ(complement.corners[i].vertex_number, boundary.corners[there].vertex_number);
        ASSERT_EQ(complement.corners[i].convex, !boundary.corners[there].convex);
        ASSERT_EQ(complement.vertices[complement.next(i)], boundary.vertices[before]);
        ASSERT_EQ(complement.corners[i].edge_number, boundary.corners[before].edge_number);
        there = before;
      }
    }
    const gcv::Boundary back = complement.complement();
    ASSERT_EQ(back.vertices, boundary.vertices);
    ASSERT_EQ(back.kind, boundary.kind);
    ASSERT_EQ(back.lexicographic_max, boundary.lexicographic_max);
    ASSERT_EQ(edge_numbers(back), edge_numbers(boundary));
    ASSERT_EQ(vertex_numbers(back), vertex_numbers(boundary));
  }
  EXPECT_GT(rings, 120U);
}

}  // namespace
}  // namespace gcv
