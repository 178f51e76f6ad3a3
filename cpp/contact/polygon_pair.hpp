// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Two polygons A and B, of which B is moved by a translation. A coordinate of B is then the sum of
// two doubles. It is never rounded.
#pragma once

#include <limits>

#include "box.hpp"
#include "double_double.hpp"
#include "polygon.hpp"
#include "predicates.hpp"

namespace gcv {

// Two polygons, prepared for questions about them. They must live longer.
class PolygonPair {
 public:
  PolygonPair(const Polygon& polygon_a, const Polygon& polygon_b)
      : a(polygon_a.boundary()),
        b(polygon_b.boundary()),
        tree_a(a.index()),
        tree_b(b.index()),
        touches_a(touches_of(a)),
        touches_b(touches_of(b)),
        slack(slack_of(a.bounds, b.bounds)) {}

  const Boundary& a;
  const Boundary& b;
  const ChainIndex& tree_a;  // over vertices relative to the first of A
  const ChainIndex& tree_b;  // likewise, of B
  const Touches& touches_a;
  const Touches& touches_b;
  // What searches allow for roundings of relative coordinates: 2^-46 times the extents of both.
  // They round below 2^-50 of these. Infinite where extents overflow: then nothing is left out.
  double slack;

 private:
  static const Touches& touches_of(const Boundary& boundary) {
    static const Touches none;
    return boundary.layout.ring_count() == 1 ? none : boundary.cover_index().touches;
  }
  static double slack_of(const Box& p, const Box& q) {
    const double extents = ((p.x1 - p.x0) + (p.y1 - p.y0)) + ((q.x1 - q.x0) + (q.y1 - q.y0));
    return 0x1p-46 * extents + std::numeric_limits<double>::min();
  }
};

// The pair with B moved.
class PlacedPair {
 public:
  PlacedPair(const PolygonPair& polygons, const Point& translation_of_b)
      : pair(polygons), a(pair.a), b(pair.b), translation(translation_of_b) {}

  const PolygonPair& pair;
  const Boundary& a;
  const Boundary& b;
  Point translation;

  // Vertices and edges where they are.
  [[nodiscard]] SumPoint vertex_of_a(Index i) const { return {a.vertices[i], {0, 0}}; }
  [[nodiscard]] SumPoint vertex_of_b(Index j) const { return {b.vertices[j], translation}; }
  [[nodiscard]] SumEdge edge_of_a(Index i) const { return edge(a, i, {0, 0}); }
  [[nodiscard]] SumEdge edge_of_b(Index j) const { return edge(b, j, translation); }

  // The first vertex of B, seen from the first of A. Rounded: within a few u times itself.
  [[nodiscard]] Point offset() const {
    const Point& p = a.vertices.front();
    const Point& q = b.vertices.front();
    return {sum_of(q.x, -p.x, translation.x), sum_of(q.y, -p.y, translation.y)};
  }

 private:
  static SumEdge edge(const Boundary& polygon, Index i, const Point& moved_by) {
    const Point& from = polygon.vertices[i];
    const Point& to = polygon.vertices[polygon.next(i)];
    return {{from, moved_by}, from, to, to.x - from.x, to.y - from.y};
  }
  static double sum_of(double x, double y, double z) {
    const double first = x + y;
    const double sum = first + z;
    return sum + (rounding_error(x, y, first) + rounding_error(first, z, sum));
  }
};

// Are two points the same?
inline bool are_equal(const SumPoint& p, const SumPoint& q, Tally& tally) {
  return compare_sums(p.a.x, p.b.x, q.a.x, q.b.x, tally) == 0 &&
         compare_sums(p.a.y, p.b.y, q.a.y, q.b.y, tally) == 0;
}

}  // namespace gcv
