// SPDX-License-Identifier: LGPL-3.0-or-later
#include "convex_cast.hpp"

#include "predicates.hpp"

namespace gcv {

namespace {

// An edge of one polygon, the vertex of the other one that lies nearest to its line, and when a
// motion takes that there.
struct CrossedLine {
  double time = -infinity;
  Index edge = 0;
  Index vertex = 0;
};

// Of the edges of P whose lines the motion of Q crosses from the right to the left, the last one:
// the motion enters the sum where it has crossed all these. Along the edges of P, the nearest
// vertex goes round Q once.
CrossedLine last_crossing(const SeenPolygon& p, const SeenPolygon& q, const Point& motion) {
  CrossedLine last;
  Index vertex = 0;
  for (Index edge = 0; edge < p.size(); ++edge) {
    const Point along = p.way(edge);
    const double speed = cross(along, motion);
    if (!(speed > 0)) {
      continue;
    }
    for (Index steps = q.size(); steps > 0 && cross(along, q.way(vertex)) > 0; --steps) {
      vertex = q.next(vertex);
    }
    for (Index steps = q.size(); steps > 0 && cross(along, q.way(q.previous(vertex))) < 0;
         --steps) {
      vertex = q.previous(vertex);
    }
    const double left = cross(along, difference(q.point(vertex), p.point(edge)));
    if (-left > last.time * speed) {
      last = {-left / speed, edge, vertex};
    }
  }
  return last;
}

// Does the path of the vertex cross the edge from the right to the left, between its ends, and does
// all else of the polygon of the vertex lie further right? Then the line of the motion enters the
// sum there, which is convex.
bool is_entered(const SeenPolygon& polygon, const SeenPolygon& other, const CrossedLine& crossing,
                const Point& motion, Tally& tally) {
  const auto [time, edge, vertex] = crossing;
  const SumPoint point = other.vertex(vertex);
  const SumEdge path{point, {0, 0}, motion, motion.x, motion.y};
  const SumEdge entered = polygon.edge(edge);
  const auto is_further_right = [&](Index neighbour) {
    return turn(entered.from, entered.to, point.a, other.vertex(neighbour).a, tally) < 0;
  };
  return side(path, polygon.vertex(edge), tally) > 0 &&
         side(path, polygon.vertex(polygon.next(edge)), tally) < 0 &&
         side(entered, point, tally) <= 0 && is_further_right(other.next(vertex)) &&
         is_further_right(other.previous(vertex));
}

}  // namespace

std::optional<ContactName> contact_entered(const PlacedPair& placed, const Point& motion,
                                           Tally& tally) {
  const ConvexPair pair(placed);
  const Point motion_of_a = negated(motion);
  const CrossedLine of_a = last_crossing(pair.a, pair.b, motion);
  const CrossedLine of_b = last_crossing(pair.b, pair.a, motion_of_a);
  if (of_a.time > of_b.time) {
    return is_entered(pair.a, pair.b, of_a, motion, tally)
               ? std::optional(ContactName{ContactKind::edge_vertex, of_a.edge, of_a.vertex})
               : std::nullopt;
  }
  return is_entered(pair.b, pair.a, of_b, motion_of_a, tally)
             ? std::optional(ContactName{ContactKind::vertex_edge, of_b.vertex, of_b.edge})
             : std::nullopt;
}

}  // namespace gcv
