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

// Does the path of a vertex of B along the motion cross an edge of A from the right to the left,
// between its ends; or does an edge of B so cross a vertex of A?
bool is_entered(const PlacedPair& placed, const ContactName& name, const Point& motion,
                Tally& tally) {
  const EdgeAndVertex pair = edge_and_vertex(placed, name);
  const Point way = name.kind == ContactKind::edge_vertex ? motion : negated(motion);
  const SumEdge path{pair.vertex, {0, 0}, way, way.x, way.y};
  return side(path, pair.edge.origin, tally) > 0 && side(path, pair.end(), tally) < 0 &&
         side(pair.edge, pair.vertex, tally) <= 0;
}

}  // namespace

// If no part of either polygon lies beyond the contact, the line of the motion enters the sum
// there, for that is convex.
std::optional<ContactName> contact_entered(const PlacedPair& placed, const Point& motion,
                                           Tally& tally) {
  const ConvexPair pair(placed);
  const CrossedLine of_a = last_crossing(pair.a, pair.b, motion);
  const CrossedLine of_b = last_crossing(pair.b, pair.a, negated(motion));
  const bool is_of_a = of_a.time > of_b.time;
  const auto& [time, edge, vertex] = is_of_a ? of_a : of_b;
  const auto [is_leftmost, parallel] =
      leftmost((is_of_a ? pair.a : pair.b).edge(edge), is_of_a ? pair.b : pair.a, vertex, tally);
  if (!is_leftmost) {
    return std::nullopt;
  }
  const auto enters = [&](const ContactName& name) {
    return is_entered(placed, name, motion, tally);
  };
  if (parallel) {
    return first_of_facing(placed, is_of_a ? edge : *parallel, is_of_a ? *parallel : edge, enters);
  }
  const ContactName name = is_of_a ? ContactName{ContactKind::edge_vertex, edge, vertex}
                                   : ContactName{ContactKind::vertex_edge, vertex, edge};
  return enters(name) ? std::optional(name) : std::nullopt;
}

}  // namespace gcv
