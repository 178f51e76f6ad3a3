// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Generalized contributing vertices (the paper, section 3, Definition 1 and Eq. 5) and
// the superset edges that two edges of equal direction merge into.
//
// Vertex v_k of B is a generalized contributing vertex for edge e of A with outer
// normal n when <v_k, n> >= <v_{k-1}, n>, <v_k, n> >= <v_{k+1}, n>, and v_k is not
// reflex. For a strictly convex v_k this says that the direction of e lies in the
// closed cone that turns counter-clockwise from the edge that ends in v_k to the edge
// that starts there: by less than half a turn.
#pragma once

#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>

#include "boundary.hpp"
#include "box.hpp"
#include "directions.hpp"
#include "double_double.hpp"

namespace gcv {

// The sum of vertex i of A and vertex j of B.
struct VertexSum {
  Index i;
  Index j;

  friend bool operator==(const VertexSum&, const VertexSum&) = default;
};

inline SumPoint point_of(const Boundary& a, const Boundary& b, const VertexSum& sum) {
  return {a.vertices[sum.i], b.vertices[sum.j], a.position(sum.i)};
}

// What a superset edge before merging is made of: edge i of A + vertex j of B, or vertex i of A +
// edge j of B. It starts at the sum of the vertices i and j.
struct EdgeName {
  enum Kind : std::uint32_t { translated = 1, corner = 2 };
  Kind kind;
  Index i;
  Index j;

  friend bool operator==(const EdgeName&, const EdgeName&) = default;
  // For an order of all names.
  [[nodiscard]] auto key() const { return std::tuple(kind, i, j); }
};

// Such an edge.
struct PairEdge : EdgeName {
  Rank rank;  // of its direction
};

// How a translated and a corner edge of equal direction, from edge i of A and edge j of
// B, merge into translated-corner edges. v: vertices of A, w: vertices of B.
enum class Merge : std::uint8_t {
  none,   // they stay apart: only vertices of one polygon contribute, or only one vertex
  whole,  // case 1: from v_i + w_j to v_{i+1} + w_{j+1}
  start,  // case 2: from v_i + w_j, as long as the longer edge
  end,    // case 3: to v_{i+1} + w_{j+1}, as long as the longer edge
};

// Two polygons with their directions: what Definition 1 is about. Edges can be named, and points
// found, before the directions are known.
struct Operands {
  const Boundary& a;
  const Boundary& b;
  Directions directions;
  // The part of the sum that is looked at, in relative coordinates, if it is not all of it.
  std::optional<Box> focus = std::nullopt;

  // Has a box in relative coordinates nothing in focus?
  [[nodiscard]] bool is_out_of_focus(const Box& box) const {
    return focus && are_apart(box, *focus);
  }

  [[nodiscard]] PairEdge translated(Index i, Index j) const {
    return {{PairEdge::translated, i, j}, directions.rank_a[i]};
  }
  [[nodiscard]] PairEdge corner(Index i, Index j) const {
    return {{PairEdge::corner, i, j}, directions.rank_b[j]};
  }

  [[nodiscard]] PairEdge named(const EdgeName& e) const {
    return e.kind == EdgeName::translated ? translated(e.i, e.j) : corner(e.i, e.j);
  }

  // The ends of the edge of A or B that it is made of.
  [[nodiscard]] std::pair<const Point&, const Point&> source(const EdgeName& e) const {
    return e.kind == EdgeName::translated
               ? std::pair<const Point&, const Point&>{a.vertices[e.i], a.vertices[a.next(e.i)]}
               : std::pair<const Point&, const Point&>{b.vertices[e.j], b.vertices[b.next(e.j)]};
  }

  [[nodiscard]] SumPoint point(const VertexSum& sum) const { return point_of(a, b, sum); }
  [[nodiscard]] SumPoint start(const EdgeName& e) const { return point({e.i, e.j}); }
  [[nodiscard]] SumPoint end(const EdgeName& e) const {
    return e.kind == EdgeName::translated ? point({a.next(e.i), e.j}) : point({e.i, b.next(e.j)});
  }

  // The sum of the vertices i and j in relative coordinates.
  [[nodiscard]] Point relative(Index i, Index j) const {
    const Point p = a.relative(i);
    const Point q = b.relative(j);
    return {p.x + q.x, p.y + q.y};
  }
  // A point of the sum in relative coordinates.
  [[nodiscard]] Point relative_place(const Point& p) const {
    const Point& v = a.vertices.front();
    const Point& w = b.vertices.front();
    const Point c = a.position(0);
    return {rounded_sum(p.x, -v.x, -w.x, -c.x), rounded_sum(p.y, -v.y, -w.y, -c.y)};
  }
  [[nodiscard]] Box relative_box(const Box& box) const {
    const Point low = relative_place({box.x0, box.y0});
    const Point high = relative_place({box.x1, box.y1});
    return {low.x, low.y, high.x, high.y};
  }
  [[nodiscard]] Box relative_bounds() const {
    return sum_of(a.relative_bounds(), b.relative_bounds());
  }
  [[nodiscard]] Point relative_start(const EdgeName& e) const { return relative(e.i, e.j); }
  [[nodiscard]] Point relative_end(const EdgeName& e) const {
    return e.kind == EdgeName::translated ? relative(a.next(e.i), e.j) : relative(e.i, b.next(e.j));
  }

  // Does vertex j of B contribute to edges of A of that rank, or vertex i of A to B's?
  [[nodiscard]] bool b_contributes(Index j, Rank rank) const {
    return contributes(b, directions.rank_b, j, rank);
  }
  [[nodiscard]] bool a_contributes(Index i, Rank rank) const {
    return contributes(a, directions.rank_a, i, rank);
  }

  // Edge i of A and edge j of B must have the same direction. A vertex contributes to an
  // edge with the direction of one of its own edges just when it is convex.
  [[nodiscard]] Merge merge(Index i, Index j) const {
    const bool v0 = a.corners[i].convex;
    const bool v1 = a.corners[a.next(i)].convex;
    const bool w0 = b.corners[j].convex;
    const bool w1 = b.corners[b.next(j)].convex;
    if ((v0 && w1) || (v1 && w0)) {
      return Merge::whole;
    }
    if (v0 && w0) {
      return Merge::start;
    }
    return v1 && w1 ? Merge::end : Merge::none;
  }

 private:
  [[nodiscard]] bool contributes(const Boundary& polygon, const Ranks& ranks, Index vertex,
                                 Rank rank) const {
    const Rank in = ranks[polygon.previous(vertex)];
    return polygon.corners[vertex].convex &&
           directions.angle(in, rank) <= directions.angle(in, ranks[vertex]);
  }
};

inline VertexSum start_of(const EdgeName& e) { return {e.i, e.j}; }
inline VertexSum end_of(const Operands& operands, const EdgeName& e) {
  return e.kind == EdgeName::translated ? VertexSum{operands.a.next(e.i), e.j}
                                        : VertexSum{e.i, operands.b.next(e.j)};
}

// The edge with its start and its direction in coordinates.
inline SumEdge coordinates(const Boundary& a, const Boundary& b, const EdgeName& e) {
  const bool translated = e.kind == EdgeName::translated;
  const Point& from = translated ? a.vertices[e.i] : b.vertices[e.j];
  const Point& to = translated ? a.vertices[a.next(e.i)] : b.vertices[b.next(e.j)];
  return {point_of(a, b, {e.i, e.j}), from, to, to.x - from.x, to.y - from.y};
}

}  // namespace gcv
