// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A simple polygon, validated, normalised and prepared: everything that sums need and
// that depends on one polygon alone. Immutable once made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "buffer.hpp"
#include "capsules.hpp"
#include "chain_tree.hpp"
#include "lazy.hpp"
#include "line_directions.hpp"
#include "point.hpp"

namespace gcv {

using Index = std::uint32_t;

// What finds the edges of a polygon that are near a place.
struct ChainIndex {
  ChainTree tree;
  std::vector<CapsuleBlock> capsules;
};

struct Polygon {
  // The ring: counter-clockwise, from the lexicographically smallest vertex, without
  // repeated and without collinear vertices. Edge i goes from vertex i to vertex i+1.
  PointVector vertices;

  // Of vertex i and the edge that starts there.
  struct Corner {
    Index vertex_number;  // the caller's
    Index edge_number;    // likewise; of merged edges, the first along the ring
    bool convex;          // strictly, or else the vertex is strictly reflex
  };
  Buffer<Corner> corners;
  bool is_convex = false;  // all vertices are

  Box bounds{};
  Index lexicographic_min = 0;
  Index lexicographic_max = 0;

  [[nodiscard]] Index size() const { return static_cast<Index>(vertices.size()); }
  [[nodiscard]] Index next(Index i) const { return i + 1 == size() ? 0 : i + 1; }
  [[nodiscard]] Index previous(Index i) const { return (i == 0 ? size() : i) - 1; }

  // Vertex i relative to vertex 0, rounded: what searches prune with, far from the origin as
  // well as near it. Each coordinate is off by at most u times its size.
  [[nodiscard]] Point relative(Index i) const {
    const Point& p = vertices[i];
    const Point& origin = vertices.front();
    return {p.x - origin.x, p.y - origin.y};
  }

  // The line direction of edge i, as that from one point to another.
  struct LineDirection {
    const Point& from;
    const Point& to;
  };
  [[nodiscard]] LineDirection line_direction(Index i) const {
    const Point& p = vertices[i];
    const Point& q = vertices[next(i)];
    return points_up(p, q) ? LineDirection{p, q} : LineDirection{q, p};
  }

  // What follows is made when it is first asked for. Sums of two convex polygons, and most of a
  // convex one and another, do without both.
  [[nodiscard]] const LineDirections& line_directions() const {
    return line_directions_.get([this] { return sort_line_directions(*this); });
  }
  // Over relative vertices. Sums with few superset edges do without.
  [[nodiscard]] const ChainIndex& index() const;

 private:
  Lazy<LineDirections> line_directions_;
  Lazy<ChainIndex> index_;
};

// The polygon with the given boundary: either orientation, closed or not, repeated and
// collinear vertices allowed. `name` is its name in messages, such as "polygon".
// Throws Error: invalid_argument, not_finite, degenerate, not_simple.
Polygon make_polygon(PointVector boundary, const char* name);

// -P = { -p : p in P }, with the same numbers. Every line direction stays, every edge
// points the other way. O(n).
Polygon reflected(const Polygon& polygon);

}  // namespace gcv
