// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Two convex polygons of a few vertices, in doubles, seen from the first vertex of A.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "contact.hpp"
#include "polygon_pair.hpp"
#include "predicates.hpp"
#include "simd.hpp"

namespace gcv {

// Four points in a row around a polygon.
struct FourPoints {
  SimdDouble x;
  SimdDouble y;
};

// A polygon, and its vertices in doubles.
class SeenPolygon {
 public:
  static constexpr std::uint64_t most_vertices = 44;  // of two; above, a descent of trees is faster

  SeenPolygon(const PlacedPolygon& polygon, const Point& offset)
      : polygon_(polygon), size_(polygon.boundary.size()) {
    const PointVector& vertices = polygon.boundary.vertices;
    const Point& first = vertices[0];
    for (Index i = 0; i < size_; ++i) {
      x_[i] = (vertices[i].x - first.x) + offset.x;
      y_[i] = (vertices[i].y - first.y) + offset.y;
    }
    for (Index i = 0; i <= SimdDouble::width; ++i) {
      x_[size_ + i] = x_[i];
      y_[size_ + i] = y_[i];
    }
  }

  [[nodiscard]] Index size() const { return size_; }
  [[nodiscard]] SumPoint vertex(Index i) const { return polygon_.vertex(i); }
  [[nodiscard]] SumEdge edge(Index i) const { return polygon_.edge(i); }

  // Of a number that is less than twice the size.
  [[nodiscard]] Index around(Index i) const { return i < size_ ? i : i - size_; }
  [[nodiscard]] Index next(Index i) const { return around(i + 1); }
  [[nodiscard]] Index previous(Index i) const { return i > 0 ? i - 1 : size_ - 1; }

  [[nodiscard]] Point point(Index i) const { return {x_[i], y_[i]}; }
  // Along the edge from that vertex.
  [[nodiscard]] Point way(Index i) const { return difference(point(i + 1), point(i)); }
  [[nodiscard]] FourPoints four_times(Index i) const {
    return {SimdDouble::of(x_[i]), SimdDouble::of(y_[i])};
  }
  // From a vertex on, or from the one behind the last.
  [[nodiscard]] FourPoints four_from(Index i) const {
    return {SimdDouble::load(x_ + i), SimdDouble::load(y_ + i)};
  }

 private:
  const PlacedPolygon& polygon_;
  const Index size_;
  double x_[most_vertices + SimdDouble::width + 1];  // begin anew behind the last one
  double y_[most_vertices + SimdDouble::width + 1];
};

struct ConvexPair {
  explicit ConvexPair(const PlacedPair& placed)
      : offset(placed.offset()),
        slack(placed.slack(offset)),
        room(room_of(placed, offset, slack)),
        a(placed.a, {0, 0}),
        b(placed.b, offset) {}

  const Point offset;
  const double slack;  // twice what differences of coordinates are off by, or more
  const double room;   // more than cross products are off by; infinite where squares may be
  const SeenPolygon a;
  const SeenPolygon b;

 private:
  // Differences of coordinates are off by less than 0.52 slack. The sizes of both coordinates of a
  // vector are together below reach + slack. So the cross product of an edge and a vector between
  // vertices is off by less than 1.1 slack (reach + slack), as long as nothing overflows.
  static double room_of(const PlacedPair& placed, const Point& offset, double slack) {
    const double reach = extents_of(placed.a.boundary.bounds) +
                         extents_of(placed.b.boundary.bounds) +
                         (std::abs(offset.x) + std::abs(offset.y));
    return reach < 0x1p500 ? 2 * slack * (reach + slack) + std::numeric_limits<double>::min()
                           : infinity;
  }
};

// Does nothing of a polygon lie further left of the line of an edge than this vertex? And the edge
// of the polygon there that is parallel to the line, if there is one.
struct LeftmostVertex {
  bool is_leftmost;
  std::optional<Index> parallel;
};
inline LeftmostVertex leftmost(const SumEdge& edge, const SeenPolygon& polygon, Index vertex,
                               Tally& tally) {
  const auto turn_to = [&](Index neighbour) {
    return turn(edge.from, edge.to, polygon.vertex(vertex).a, polygon.vertex(neighbour).a, tally);
  };
  const Index before = polygon.previous(vertex);
  const int ahead = turn_to(polygon.next(vertex));
  const int behind = turn_to(before);
  return {ahead <= 0 && behind <= 0, ahead == 0    ? std::optional(vertex)
                                     : behind == 0 ? std::optional(before)
                                                   : std::nullopt};
}

// Of the contacts of an edge and a vertex of two edges that face each other, the first one for
// which is(name) is true.
template <class Is>
std::optional<ContactName> first_of_facing(const PlacedPair& placed, Index edge_of_a,
                                           Index edge_of_b, Is is) {
  using Names = std::array<ContactName, 2>;
  for (Names names : {Names{{{ContactKind::edge_vertex, edge_of_a, edge_of_b},
                             {ContactKind::edge_vertex, edge_of_a, placed.b.next(edge_of_b)}}},
                      Names{{{ContactKind::vertex_edge, edge_of_a, edge_of_b},
                             {ContactKind::vertex_edge, placed.a.next(edge_of_a), edge_of_b}}}}) {
    if (order_of(placed, names[1]) < order_of(placed, names[0])) {
      std::swap(names[0], names[1]);
    }
    for (const ContactName& name : names) {
      if (is(name)) {
        return name;
      }
    }
  }
  return std::nullopt;
}

// Are both convex, with so few vertices that all of them may be looked at?
[[nodiscard]] inline bool are_small_and_convex(const PlacedPair& placed) {
  const Boundary& a = placed.a.boundary;
  const Boundary& b = placed.b.boundary;
  return a.is_convex && b.is_convex &&
         std::uint64_t{a.size()} + b.size() <= SeenPolygon::most_vertices;
}

}  // namespace gcv
