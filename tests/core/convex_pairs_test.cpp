// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Two convex polygons in doubles. A walk round both ends where they are nearest: of all pairs of an
// edge and a vertex, none is nearer, and those as near have the same name or are of edges that face
// each other. And the contact that a motion enters is found.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "boundary.hpp"
#include "cast.hpp"
#include "convex_cast.hpp"
#include "convex_distance.hpp"
#include "generators.hpp"
#include "polygon_pair.hpp"
#include "predicates.hpp"
#include "relation.hpp"

namespace gcv {
namespace {

using Kind = NearestOfConvex::Kind;

PointVector on_circle(test::Random& random, int vertices, double radius) {
  PointVector ring;
  for (int k = 0; k < vertices; ++k) {
    const double angle =
        2 * std::numbers::pi * (k + test::uniform(random, 0, 900) / 1000.0) / vertices;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return ring;
}
PointVector rectangle(test::Random& random, double angle) {
  const double width = test::uniform(random, 1, 8);
  const double height = test::uniform(random, 1, 8);
  PointVector ring{{0, 0}, {width, 0}, {width, height}, {0, height}};
  for (Point& p : ring) {
    p = {std::cos(angle) * p.x - std::sin(angle) * p.y,
         std::sin(angle) * p.x + std::cos(angle) * p.y};
  }
  return ring;
}
PointVector any_convex(test::Random& random) {
  switch (test::uniform(random, 0, 4)) {
    case 0:
      return rectangle(random, 0);
    case 1:
      return rectangle(random, 0.3);
    case 2:  // so thin that one side is as near as the other, in doubles
      return {{0, 0}, {7, 0}, {7, 1e-15}, {0, 1e-15}};
    case 3:
      return {{0, 0}, {4, 0}, {6, 2}, {6, 4}, {4, 6}, {2, 6}, {0, 4}};
    default:
      return on_circle(random, test::uniform(random, 3, 20), test::uniform(random, 1, 9));
  }
}

// Then a motion may pass through it in no time.
bool is_thin(const Boundary& boundary) { return boundary.bounds.y1 - boundary.bounds.y0 < 1e-9; }

struct Candidate {
  ContactName name;
  Gap gap;
};

std::vector<Candidate> all_candidates(const PlacedPair& placed, Tally& tally) {
  std::vector<Candidate> result;
  for (Index i = 0; i < placed.a.boundary.size(); ++i) {
    for (Index j = 0; j < placed.b.boundary.size(); ++j) {
      for (const ContactKind kind : {ContactKind::edge_vertex, ContactKind::vertex_edge}) {
        const EdgeAndVertex pair = edge_and_vertex(placed, {kind, i, j});
        const Nearest nearest = nearest_on(pair, tally);
        result.push_back({features(placed, {kind, i, j}, nearest), gap_between(pair, nearest)});
      }
    }
  }
  return result;
}

bool are_parallel(const PlacedPair& placed, Index i, Index j, Tally& tally) {
  const SumEdge p = placed.a.edge(i);
  const SumEdge q = placed.b.edge(j);
  return turn(p.from, p.to, q.from, q.to, tally) == 0;
}

// Is a feature an edge or an end of it?
bool is_of(const ContactName& name, const NearestOfConvex& nearest, const PlacedPair& placed) {
  const auto is_at = [](bool is_edge, Index feature, Index edge, Index end) {
    return feature == edge || (!is_edge && feature == end);
  };
  return is_at(name.kind == ContactKind::edge_vertex, name.i, nearest.edge_of_a,
               placed.a.next(nearest.edge_of_a)) &&
         is_at(name.kind == ContactKind::vertex_edge, name.j, nearest.edge_of_b,
               placed.b.next(nearest.edge_of_b));
}

void expect_nearest(const PlacedPair& placed, const NearestOfConvex& nearest, Tally& tally) {
  const Gap gap = gap_of(placed, nearest.name, tally);
  int named = 0;
  for (const Candidate& candidate : all_candidates(placed, tally)) {
    const int order = compare_gaps(gap, candidate.gap, tally);
    ASSERT_LE(order, 0);
    named += candidate.name == nearest.name ? 1 : 0;
    if (order == 0 && nearest.kind == Kind::alone) {
      ASSERT_EQ(candidate.name, nearest.name);
    } else if (order == 0) {
      ASSERT_TRUE(is_of(candidate.name, nearest, placed));
    }
  }
  EXPECT_GT(named, 0);
  if (nearest.kind == Kind::facing) {
    EXPECT_TRUE(are_parallel(placed, nearest.edge_of_a, nearest.edge_of_b, tally));
  }
}

TEST(ConvexDistance, NamesWhatIsNearest) {
  test::Random random(3);
  Tally tally;
  int apart = 0;
  int facing = 0;
  int unknown = 0;
  int further = 0;
  for (int k = 0; k < 4000; ++k) {
    SCOPED_TRACE(std::to_string(k));
    const Boundary a = make_ring(any_convex(random), "a");
    const Boundary b = make_ring(any_convex(random), "b");
    ASSERT_TRUE(a.is_convex && b.is_convex);
    const PolygonPair polygons(a, b);
    Point translation{test::uniform(random, -24, 24) / 2.0, test::uniform(random, -24, 24) / 2.0};
    if (k % 4 == 0) {
      translation = {std::nextafter(translation.x, 99), translation.y * (1 + 1e-12)};
    }
    const PlacedPair placed(polygons, translation);
    const ConvexPair pair(placed);
    const ConvexSeparation separation = convex_separation(pair, tally);
    if (separation.relation == Relation::apart) {
      ++apart;
      const NearestOfConvex nearest = nearest_of_convex(placed, pair, separation, infinity, tally);
      unknown += nearest.kind == Kind::unknown ? 1 : 0;
      facing += nearest.kind == Kind::facing ? 1 : 0;
      if (nearest.kind != Kind::unknown) {
        expect_nearest(placed, nearest, tally);
        const double gap = nearest_gap(gap_of(placed, nearest.name, tally), tally);
        const auto kind_within = [&](double distance) {
          return nearest_of_convex(placed, pair, separation, distance, tally).kind;
        };
        EXPECT_EQ(kind_within(gap), nearest.kind);
        further += kind_within(0.9 * gap) == Kind::further ? 1 : 0;
      }
    }
  }
  EXPECT_GT(apart, 2000);
  EXPECT_GT(facing, 200);
  EXPECT_GT(further, apart / 3);
  EXPECT_LT(unknown, apart / 20);  // of thin ones
}

// Infinite products lead a walk anywhere: what it finds is proven.
TEST(ConvexDistance, IsProvenWhereSquaresOverflow) {
  Tally tally;
  const Boundary a = make_ring({{0, 0}, {1e200, 0}, {1e200, 1e200}, {0, 1e200}}, "a");
  const Boundary b = make_ring({{0, 0}, {1e200, 1e200}, {0, 2e200}}, "b");
  const PolygonPair polygons(a, b);
  const PlacedPair placed(polygons, {3e200, -5e199});
  const ConvexPair pair(placed);
  const ConvexSeparation separation = convex_separation(pair, tally);
  ASSERT_EQ(separation.relation, Relation::apart);
  const NearestOfConvex nearest = nearest_of_convex(placed, pair, separation, infinity, tally);
  ASSERT_EQ(nearest.kind, Kind::facing);
  expect_nearest(placed, nearest, tally);
}

// An edge that does not separate them leads to a vertex that nothing of its polygon is beyond.
TEST(ConvexDistance, IsProvenFromAnyEdge) {
  Tally tally;
  const Boundary a = make_ring({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, "a");
  const Boundary b = make_ring({{1, 6}, {3, 6}, {2, 9}}, "b");
  const PolygonPair polygons(a, b);
  const PlacedPair placed(polygons, {0, 0});
  const ConvexPair pair(placed);
  for (const auto& [edge, kind] : {std::pair<Index, Kind>{0, Kind::unknown}, {2, Kind::facing}}) {
    const ConvexSeparation separation{Relation::apart, &pair.a, edge};
    EXPECT_EQ(nearest_of_convex(placed, pair, separation, infinity, tally).kind, kind) << edge;
  }
}

// A motion begins to overlap where it enters the contact that is found.
TEST(ConvexCast, FindsWhatTheMotionEnters) {
  test::Random random(4);
  Tally tally;
  int hits = 0;
  int found = 0;
  for (int k = 0; k < 4000; ++k) {
    SCOPED_TRACE(std::to_string(k));
    const Boundary a = make_ring(any_convex(random), "a");
    const Boundary b = make_ring(any_convex(random), "b");
    const PolygonPair polygons(a, b);
    const Point start{test::uniform(random, -240, 240) / 10.0,
                      test::uniform(random, -240, 240) / 10.0};
    const Point motion{test::uniform(random, -300, 300) / 10.0,
                       test::uniform(random, -300, 300) / 10.0};
    const PlacedPair placed(polygons, start);
    if (relation(placed, tally) == Relation::overlapping) {
      continue;
    }
    const auto overlaps_at = [&](double time) {
      const Point there{start.x + time * motion.x, start.y + time * motion.y};
      return relation(PlacedPair(polygons, there), tally) == Relation::overlapping;
    };
    const Impact impact = cast(placed, motion, tally);
    const auto entered = contact_entered(placed, motion, tally);
    hits += impact.hit ? 1 : 0;
    found += impact.hit && entered ? 1 : 0;
    if (impact.hit && entered) {
      EXPECT_EQ(order_of(placed, *entered),
                std::tuple(impact.contact.kind, impact.contact.a, impact.contact.b));
      EXPECT_FALSE(overlaps_at(impact.time - 1e-9));
      EXPECT_TRUE(is_thin(a) || is_thin(b) || overlaps_at(impact.time + 1e-6)) << impact.time;
    }
    if (!impact.hit) {
      EXPECT_FALSE(overlaps_at(0.5));
    }
  }
  EXPECT_GT(hits, 300);
  EXPECT_GT(found, hits * 9 / 10);
}

}  // namespace
}  // namespace gcv
