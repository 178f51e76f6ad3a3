// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Walks from any place: round the outer face, and round holes that CGAL finds.
#include "walker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "choose.hpp"
#include "generators.hpp"
#include "numbers.hpp"
#include "outer_face.hpp"
#include "polygon.hpp"
#include "reference.hpp"
#include "search.hpp"

namespace gcv {
namespace {

using reference::FractionRing;
using test::Random;
using test::Rational;
using test::Ring;

struct Fractions {
  Rational x;
  Rational y;

  friend bool operator==(const Fractions& p, const Fractions& q) {
    return p.x == q.x && p.y == q.y;
  }
  friend bool operator<(const Fractions& p, const Fractions& q) {
    return p.x < q.x || (p.x == q.x && p.y < q.y);
  }
};

Fractions operator-(const Fractions& p, const Fractions& q) { return {p.x - q.x, p.y - q.y}; }
Rational cross(const Fractions& p, const Fractions& q) { return p.x * q.y - p.y * q.x; }
Rational dot(const Fractions& p, const Fractions& q) { return p.x * q.x + p.y * q.y; }

Fractions exact(const SumPoint& p) {
  return {Rational(p.a.x) + Rational(p.b.x), Rational(p.a.y) + Rational(p.b.y)};
}

std::vector<Fractions> read(const FractionRing& ring) {
  std::vector<Fractions> points;
  for (const std::string& vertex : ring) {
    std::istringstream text(vertex);
    Fractions p;
    text >> p.x >> p.y;
    points.push_back(p);
  }
  return points;
}

// Two polygons, and walks in their sum.
class Pair {
 public:
  Pair(const std::vector<Ring>& a, const std::vector<Ring>& b)
      : polygon_a_(make_polygon(a, "a")),
        polygon_b_(make_polygon(b, "b")),
        operands_{a_, b_, merge_directions(a_, b_, tally_)},
        superset_(operands_) {
    for (Index i = 0; i < a_.size(); ++i) {
      for (Index j = 0; j < b_.size(); ++j) {
        names_.push_back(operands_.translated(i, j));
        names_.push_back(operands_.corner(i, j));
      }
    }
  }

  // From the place where the edge from p to q, with the sum on its left, begins; nothing where no
  // two superset edges name it.
  std::vector<std::vector<Fractions>> rings_from(const Fractions& p, const Fractions& q) {
    std::vector<std::vector<Fractions>> rings;
    for (const PairEdge& edge : names_) {
      if (!is_superset_edge(edge) || !holds(edge, p, q)) {
        continue;
      }
      for (const PairEdge& other : names_) {
        if (exact(operands_.start(other)) == p) {
          rings.push_back(ring(Place::of(start_of(other)), edge));
        } else if (crosses_at(other, edge, p)) {
          rings.push_back(ring(crossing(other, edge), edge));
        }
      }
    }
    return rings;
  }

  // From places between p and q, where any edges, of the superset or not, cross it.
  std::vector<std::vector<Fractions>> rings_between(const Fractions& p, const Fractions& q) {
    std::vector<std::vector<Fractions>> rings;
    for (const PairEdge& edge : names_) {
      if (!is_superset_edge(edge) || !holds(edge, p, q)) {
        continue;
      }
      for (const PairEdge& other : names_) {
        const Fractions o = exact(operands_.start(other));
        const Fractions d = exact(operands_.end(other)) - o;
        const Rational from = cross(d, p - o);
        const Rational to = cross(d, q - o);
        if (from.sign() * to.sign() < 0) {  // on its line, maybe beyond its ends
          rings.push_back(ring(crossing(other, edge), edge));
        }
      }
    }
    return rings;
  }

  std::vector<Fractions> outer_face() {
    Task task;
    return vertices(walk_outer_face(a_, b_, task, tally_));
  }

 private:
  bool is_superset_edge(const PairEdge& e) {
    return e.kind == EdgeName::translated ? operands_.b_contributes(e.j, e.rank)
                                          : operands_.a_contributes(e.i, e.rank);
  }

  // Does it go through p, which is not its end, in the direction of q?
  bool holds(const PairEdge& e, const Fractions& p, const Fractions& q) {
    const Fractions from = exact(operands_.start(e));
    const Fractions to = exact(operands_.end(e));
    return cross(to - from, p - from) == 0 && cross(to - from, q - p) == 0 &&
           dot(to - from, q - p) > 0 && dot(p - from, to - from) >= 0 && dot(to - p, to - from) > 0;
  }

  bool crosses_at(const PairEdge& other, const PairEdge& edge, const Fractions& p) {
    const Fractions from = exact(operands_.start(other));
    const Fractions to = exact(operands_.end(other));
    return search_turns(other, edge) && cross(to - from, p - from) == 0;
  }
  bool search_turns(const PairEdge& e, const PairEdge& f) {
    return Search(superset_).turn(e, f, tally_) != 0;
  }

  Place crossing(const PairEdge& other, const PairEdge& edge) {
    return {false,
            {},
            other,
            crossing_parameter(coordinates(a_, b_, edge), coordinates(a_, b_, other))};
  }

  std::vector<Fractions> ring(const Place& place, const PairEdge& edge) {
    Task task;
    return vertices(Walker(operands_, Search(superset_), superset_.slack(), task)
                        .ring(place, edge, [](const RingVertex&) { return false; })
                        .walk.value());
  }

  // From the smallest one.
  std::vector<Fractions> vertices(const Walk& walk) {
    std::vector<Fractions> points;
    for (const RingVertex& v : walk.vertices) {
      if (v.is_sum()) {
        points.push_back(exact({a_.vertices[v.i()], b_.vertices[v.j()]}));
        continue;
      }
      const Fractions p = exact(operands_.start(v.arriving()));
      const Fractions d = exact(operands_.end(v.arriving())) - p;
      const Fractions r = exact(operands_.start(v.leaving()));
      const Fractions e = exact(operands_.end(v.leaving())) - r;
      const Rational along = cross(r - p, e) / cross(d, e);
      points.push_back({p.x + along * d.x, p.y + along * d.y});
    }
    std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
    return points;
  }

  Tally tally_;
  Polygon polygon_a_;
  Polygon polygon_b_;
  const gcv::Boundary& a_ = polygon_a_.boundary();
  const gcv::Boundary& b_ = polygon_b_.boundary();
  Operands operands_;
  SearchableSuperset superset_;
  std::vector<PairEdge> names_;
};

std::vector<Fractions> turned_round(std::vector<Fractions> ring) {
  std::reverse(ring.begin() + 1, ring.end());
  return ring;
}

// Of all edges of the ring. Gives the number of walks.
std::size_t expect_ring_from_everywhere(Pair& pair, const std::vector<Fractions>& ring) {
  std::size_t walks = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Fractions& p = ring[k];
    const Fractions& q = ring[k + 1 == ring.size() ? 0 : k + 1];
    const auto from = pair.rings_from(p, q);
    EXPECT_FALSE(from.empty());
    for (const auto& rings : {from, pair.rings_between(p, q)}) {
      for (const std::vector<Fractions>& walked : rings) {
        EXPECT_EQ(walked, ring);
        ++walks;
      }
    }
  }
  return walks;
}

TEST(Walker, FindsTheOuterFaceFromAnyPlace) {
  Random random(1);
  std::size_t walks = 0;
  for (int k = 0; k < 60; ++k) {
    Pair pair({test::random_small_integer_polygon(random, 7, 6)},
              {test::random_small_integer_polygon(random, 5, 4)});
    walks += expect_ring_from_everywhere(pair, pair.outer_face());
  }
  EXPECT_GT(walks, 5000U);
}

TEST(Walker, FindsHolesFromAnyPlace) {
  Random random(2);
  std::size_t holes = 0;
  std::size_t walks = 0;
  for (int k = 0; k < 400; ++k) {
    const std::vector<Ring> a{test::random_small_integer_polygon(random, 14, 12)};
    const std::vector<Ring> b{test::random_small_integer_polygon(random, 4, 3)};
    Pair pair(a, b);
    for (const FractionRing& hole : reference::holes(a, b)) {
      ++holes;
      walks += expect_ring_from_everywhere(pair, turned_round(read(hole)));
    }
  }
  EXPECT_GT(holes, 10U);
  EXPECT_GT(walks, 500U);
}

TEST(Walker, GoesRoundTheCavityBehindAMouthThatIsTooNarrow) {
  // The mouth is 1 wide, the square 2; the cavity of 6 x 6 leaves 4 x 4 for its centre.
  const Ring jar{{0, 0}, {10, 0}, {10, 10}, {5.5, 10}, {5.5, 8},  {8, 8},
                 {8, 2}, {2, 2},  {2, 8},   {4.5, 8},  {4.5, 10}, {0, 10}};
  const Ring square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  Pair pair({jar}, {square});
  EXPECT_GT(expect_ring_from_everywhere(pair, {{3, 3}, {3, 7}, {7, 7}, {7, 3}}), 100U);
}

// Some with holes in both, so that the superset has the edges of all rings.
TEST(Walker, FindsHolesOfSumsOfPolygonsWithHoles) {
  Random random(3);
  const auto with_hole = [](double extent, Ring hole) {
    for (Point& p : hole) {
      p = {p.x + 1, p.y + 1};
    }
    return std::vector<Ring>{{{0, 0}, {extent, 1}, {extent + 1, extent}, {-1, extent + 2}}, hole};
  };
  std::size_t holes = 0;
  std::size_t walks = 0;
  for (int k = 0; k < 100; ++k) {
    const std::vector<Ring> a = with_hole(12, test::random_small_integer_polygon(random, 6, 8));
    const std::vector<Ring> b =
        k % 2 == 0 ? with_hole(3, {{0, 0}, {1, 0}, {0, 1}})
                   : std::vector<Ring>{test::random_small_integer_polygon(random, 5, 3)};
    Pair pair(a, b);
    for (const FractionRing& hole : reference::holes(a, b)) {
      ++holes;
      walks += expect_ring_from_everywhere(pair, turned_round(read(hole)));
    }
  }
  EXPECT_GT(holes, 30U);
  EXPECT_GT(walks, 800U);
}

}  // namespace
}  // namespace gcv
