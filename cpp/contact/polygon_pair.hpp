// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Two polygons A and B, each moved by a translation. A coordinate is then the sum of two doubles.
// It is never rounded.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "box.hpp"
#include "double_double.hpp"
#include "polygon.hpp"
#include "predicates.hpp"

namespace gcv {

// How two polygons lie. The values are those of gcv.h.
enum class Relation : std::int8_t { apart = 1, touching = 0, overlapping = -1 };

// A polygon, prepared for questions about it. It must live longer. Its solid is connected and
// bounded; or it is a complement, as that of a container.
struct PreparedPolygon {
  explicit PreparedPolygon(const Boundary& of) : boundary(of), touches(touches_of(boundary)) {}

  const Boundary& boundary;
  const Touches& touches;

  // Over vertices relative to the first one. Made when it is first asked for.
  [[nodiscard]] const ChainTree& tree() const { return boundary.index().tree; }

  [[nodiscard]] bool is_complement() const { return boundary.kind == Boundary::Kind::hole; }

 private:
  static const Touches& touches_of(const Boundary& boundary) {
    static const Touches none;
    return boundary.layout.ring_count() == 1 ? none : boundary.cover_index().touches;
  }
};

struct PolygonPair {
  PolygonPair(const Polygon& polygon_a, const Polygon& polygon_b)
      : PolygonPair(polygon_a.boundary(), polygon_b.boundary()) {}
  PolygonPair(const Boundary& of_a, const Boundary& of_b)
      : a(of_a), b(of_b), slack(slack_of(a.boundary.bounds, b.boundary.bounds)) {}

  PreparedPolygon a;
  PreparedPolygon b;
  // What searches allow for roundings of relative coordinates: 2^-46 times the extents of both.
  // They round below 2^-50 of these. Infinite where extents overflow: then nothing is left out.
  double slack;

 private:
  static double slack_of(const Box& p, const Box& q) {
    return 0x1p-46 * (extents_of(p) + extents_of(q)) + std::numeric_limits<double>::min();
  }
};

// A polygon that is moved by a translation.
struct PlacedPolygon : PreparedPolygon {
  PlacedPolygon(const PreparedPolygon& polygon, const Point& moved_by)
      : PreparedPolygon(polygon), translation(moved_by) {}

  Point translation;

  [[nodiscard]] Index next(Index i) const { return boundary.next(i); }
  // Vertices and edges where they are.
  [[nodiscard]] SumPoint vertex(Index i) const { return {boundary.vertices[i], translation}; }
  [[nodiscard]] SumEdge edge(Index i) const {
    const Point& from = boundary.vertices[i];
    const Point& to = boundary.vertices[boundary.next(i)];
    return {{from, translation}, from, to, to.x - from.x, to.y - from.y};
  }
};

// A pair with both moved, or only B.
struct PlacedPair {
  PlacedPair(const PolygonPair& polygons, const Point& translation)
      : PlacedPair(polygons, {0, 0}, translation) {}
  PlacedPair(const PolygonPair& polygons, const Point& translation_a, const Point& translation_b)
      : pair(polygons), a(pair.a, translation_a), b(pair.b, translation_b) {}

  const PolygonPair& pair;
  PlacedPolygon a;
  PlacedPolygon b;

  // The first vertex of B, seen from the first of A. Rounded: within a few u times itself.
  [[nodiscard]] Point offset() const {
    const Point& p = a.boundary.vertices.front();
    const Point& q = b.boundary.vertices.front();
    if (a.translation == Point{0, 0}) {
      return {rounded_sum(q.x, -p.x, b.translation.x), rounded_sum(q.y, -p.y, b.translation.y)};
    }
    return {rounded_sum(q.x, -p.x, b.translation.x, -a.translation.x),
            rounded_sum(q.y, -p.y, b.translation.y, -a.translation.y)};
  }
  // With that offset: what searches allow for roundings of coordinates seen from the first vertex
  // of A, which are off by less than a quarter of it.
  [[nodiscard]] double slack(const Point& offset) const {
    return pair.slack + 0x1p-48 * (std::abs(offset.x) + std::abs(offset.y));
  }
};

}  // namespace gcv
