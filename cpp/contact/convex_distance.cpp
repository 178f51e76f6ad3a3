// SPDX-License-Identifier: LGPL-3.0-or-later
#include "convex_distance.hpp"

#include <cmath>
#include <optional>

#include "predicates.hpp"

namespace gcv {

namespace {

// Two polygons P and Q, one of them with the separating edge.
//
// Let u be a direction, p the vertex of P that is furthest along u, and q the vertex of Q that is
// least far. Then the gap between P and Q along u is u (q - p). Where it is above 0 it has one
// maximum over all u, which is the distance. As u turns, it becomes the normal of an edge of P, or
// the opposite of that of an edge of Q, and then p or q becomes the next vertex.
class NearestWalk {
 public:
  // Features in the terms of P and Q.
  struct Features {
    enum class Kind { edge_of_p, edge_of_q, vertices };
    Kind kind;
    Index i;
    Index j;
  };

  NearestWalk(const SeenPolygon& p, const SeenPolygon& q) : p_(p), q_(q) {}

  // From an edge of P, and the vertex of Q that is nearest to its line.
  [[nodiscard]] std::optional<Features> run(Index edge, Index j) const {
    const Point way = p_.way(edge);
    if (dot(difference(q_.point(j), p_.point(edge)), way) < 0) {
      return turn_on<false>(edge, j);
    }
    if (dot(difference(q_.point(j), p_.point(edge + 1)), way) > 0) {
      return turn_on<true>(p_.next(edge), j);
    }
    return Features{Features::Kind::edge_of_p, edge, j};
  }

 private:
  // u turns from where the two vertices begin to be furthest along it, to the left or to the right.
  template <bool to_left>
  [[nodiscard]] std::optional<Features> turn_on(Index i, Index j) const {
    const auto beside = [](const SeenPolygon& polygon, Index k) {
      return to_left ? polygon.next(k) : polygon.previous(k);
    };
    for (Index steps = p_.size() + q_.size(); steps > 0; --steps) {
      const Index next_i = beside(p_, i);
      const Index next_j = beside(q_, j);
      const Point way_p = difference(p_.point(next_i), p_.point(i));
      const Point way_q = difference(q_.point(next_j), q_.point(j));
      const Point between = difference(q_.point(j), p_.point(i));
      const bool goes_on_p = dot(between, way_p) > 0;
      const bool goes_on_q = dot(between, way_q) < 0;
      if (!goes_on_p && !goes_on_q) {
        return Features{Features::Kind::vertices, i, j};
      }
      const double turn = cross(way_p, way_q);
      const bool is_p_first = to_left ? turn < 0 : turn > 0;
      if (goes_on_p && (is_p_first || !goes_on_q)) {
        if (dot(difference(q_.point(j), p_.point(next_i)), way_p) < 0) {
          return Features{Features::Kind::edge_of_p, to_left ? i : next_i, j};
        }
        i = next_i;
      } else {
        if (dot(difference(p_.point(i), q_.point(next_j)), way_q) < 0) {
          return Features{Features::Kind::edge_of_q, i, to_left ? j : next_j};
        }
        j = next_j;
      }
    }
    return std::nullopt;
  }

  const SeenPolygon& p_;
  const SeenPolygon& q_;
};

// The vertex of Q that is nearest to the line of an edge of P, which separates them, and how far it
// lies on its left, in times of the length of the edge: not above 0.
struct NearestToLine {
  Index vertex;
  double left;
};
NearestToLine nearest_to_line(const SeenPolygon& p, Index edge, const SeenPolygon& q) {
  NearestToLine nearest{0, -infinity};
  for (Index j = 0; j < q.size(); ++j) {
    const double left = cross(p.way(edge), difference(q.point(j), p.point(edge)));
    if (left > nearest.left) {
      nearest = {j, left};
    }
  }
  return nearest;
}

using Kind = NearestOfConvex::Kind;

// Is a vertex the nearest of its polygon to a point? And the edge there, if there is one, that is
// perpendicular to the vector between them.
struct NearestVertex {
  bool is_nearest;
  std::optional<Index> across;
};
NearestVertex nearest_vertex(const SeenPolygon& polygon, Index vertex, const SumPoint& point,
                             Tally& tally) {
  const Index before = polygon.previous(vertex);
  const int ahead = side(perpendicular(polygon.edge(vertex), point), polygon.vertex(vertex), tally);
  const int behind =
      side(perpendicular(polygon.edge(before), point), polygon.vertex(vertex), tally);
  const std::optional<Index> across = ahead == 0    ? std::optional(vertex)
                                      : behind == 0 ? std::optional(before)
                                                    : std::nullopt;
  return {ahead <= 0 && behind >= 0, across};
}

NearestOfConvex proven_vertices(const ConvexPair& pair, const ContactName& name, Tally& tally) {
  const auto [of_a, across_a] = nearest_vertex(pair.a, name.i, pair.b.vertex(name.j), tally);
  if (!of_a) {
    return {Kind::unknown, name};
  }
  const auto [of_b, across_b] = nearest_vertex(pair.b, name.j, pair.a.vertex(name.i), tally);
  if (!of_b) {
    return {Kind::unknown, name};
  }
  return across_a && across_b ? NearestOfConvex{Kind::facing, name, *across_a, *across_b}
                              : NearestOfConvex{Kind::alone, name};
}

// Two points of two convex sets that are apart are nearest just when the vector between them is
// normal to both sets there.
NearestOfConvex proven(const PlacedPair& placed, const ConvexPair& pair, const ContactName& name,
                       Tally& tally) {
  if (name.kind == ContactKind::vertex_vertex) {
    return proven_vertices(pair, name, tally);
  }
  const EdgeAndVertex on = edge_and_vertex(placed, name);
  const Nearest nearest = nearest_on(on, tally);
  if (nearest != Nearest::inside) {
    return proven_vertices(pair, features(placed, name, nearest), tally);
  }
  const bool is_edge_of_a = name.kind == ContactKind::edge_vertex;
  const SeenPolygon& other = is_edge_of_a ? pair.b : pair.a;
  const Index vertex = is_edge_of_a ? name.j : name.i;
  const auto [is_leftmost, parallel] = leftmost(on.edge, other, vertex, tally);
  if (!is_leftmost || side(on.edge, on.vertex, tally) >= 0) {
    return {Kind::unknown, name};
  }
  if (!parallel) {
    return {Kind::alone, name};
  }
  return is_edge_of_a ? NearestOfConvex{Kind::facing, name, name.i, *parallel}
                      : NearestOfConvex{Kind::facing, name, *parallel, name.j};
}

}  // namespace

NearestOfConvex nearest_of_convex(const PlacedPair& placed, const ConvexPair& pair,
                                  const ConvexSeparation& separation, double distance,
                                  Tally& tally) {
  const bool p_is_a = separation.polygon == &pair.a;
  const SeenPolygon& p = *separation.polygon;
  const SeenPolygon& q = p_is_a ? pair.b : pair.a;
  const auto [vertex, left] = nearest_to_line(p, separation.edge, q);
  const Point way = p.way(separation.edge);
  const double length = std::sqrt(dot(way, way)) + pair.slack;
  if (-left - pair.room > (1 + 0x1p-50) * distance * length) {
    return {Kind::further, {}};
  }
  using Features = NearestWalk::Features;
  const std::optional<Features> found = NearestWalk(p, q).run(separation.edge, vertex);
  if (!found) {
    return {Kind::unknown, {}};
  }
  const bool is_edge_of_a = p_is_a == (found->kind == Features::Kind::edge_of_p);
  const ContactKind kind = found->kind == Features::Kind::vertices ? ContactKind::vertex_vertex
                           : is_edge_of_a                          ? ContactKind::edge_vertex
                                                                   : ContactKind::vertex_edge;
  return proven(
      placed, pair,
      p_is_a ? ContactName{kind, found->i, found->j} : ContactName{kind, found->j, found->i},
      tally);
}

}  // namespace gcv
