// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Ways from a place into what is free around it.
#include <algorithm>

#include "cover.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

// A unit vector of the direction of that rank, which an edge has, or an opposite one.
Point vector_of(const Operands& operands, Rank rank) {
  const Rank half = operands.directions.half_turn;
  const auto find = [&](const Boundary& polygon, const Ranks& ranks) -> Point {
    for (Index i = 0; i < polygon.size(); ++i) {
      if (ranks[i] % half == rank % half) {
        const Point& p = polygon.vertices[i];
        const Point& q = polygon.vertices[polygon.next(i)];
        return unit_vector(ranks[i] == rank ? direction(p, q) : direction(q, p));
      }
    }
    return {0, 0};
  };
  const Point of_a = find(operands.a, operands.directions.rank_a);
  return of_a == Point{0, 0} ? find(operands.b, operands.directions.rank_b) : of_a;
}

}  // namespace

std::vector<Point> EdgeCover::ways_off(const PairEdge& s, const Place& place) {
  const PlacesOnLine places(operands_, s, tally_);
  const RelativeLine line{operands_.relative_start(s), places.line().at.dx, places.line().at.dy};
  search_.begin(line);
  const Rank half = operands_.directions.half_turn;
  std::vector<Point> ways;
  for (const DirectionArc& arc : look(places, line, place).blocked.free_arcs()) {
    const Point from = vector_of(operands_, arc.from);
    const Point to = vector_of(operands_, (arc.from + arc.length) % (2 * half));
    // From half a turn on, a quarter turn from its start lies in it.
    ways.push_back(arc.length < half ? Point{from.x + to.x, from.y + to.y}
                                     : Point{-from.y, from.x});
  }
  return ways;
}

}  // namespace gcv
