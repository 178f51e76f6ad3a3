// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A polygon: an outer ring and the rings of its holes. Immutable once made.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "affine.hpp"
#include "boundary.hpp"
#include "lazy.hpp"
#include "point.hpp"

namespace gcv {

struct Polygon {
  explicit Polygon(Boundary outer_ring) : outer(std::move(outer_ring)) {}
  // Of one ring. Throws Error: as make_ring().
  Polygon(PointVector vertices, const char* name) : outer(make_ring(std::move(vertices), name)) {}

  Boundary outer;
  std::vector<Boundary> holes;  // in the caller's order

  [[nodiscard]] std::size_t ring_count() const { return 1 + holes.size(); }
  // Boundary 0 is the outer one.
  [[nodiscard]] const Boundary& ring(std::size_t k) const { return k == 0 ? outer : holes[k - 1]; }
  // All rings as one, made when it is first asked for.
  [[nodiscard]] const Boundary& boundary() const {
    return holes.empty() ? outer : boundary_.get([this] { return all_rings(); });
  }

  // The reflection { -p : p in the polygon }, ring by ring, with the same numbers. Keeps the
  // polygon alive.
  static Polygon reflected(std::shared_ptr<const Polygon> polygon);

 private:
  std::shared_ptr<const Polygon> mirror_;  // the polygon that this one reflects
  Lazy<Boundary> boundary_;

  [[nodiscard]] Boundary all_rings() const;
};

// All of its rings, the outer one first.
std::vector<const Boundary*> rings_of(const Polygon& polygon);

// The polygon of the given boundaries, the outer one first, at least one. The caller's numbers of
// vertices run through all of them. Rings may touch one another in points, but not cross or
// overlap; holes lie in the outer ring and outside one another.
// O(n log n).
// Throws Error: as make_ring(), with the number of the ring; not_simple for rings that cross,
// overlap, or lie where they may not.
Polygon make_polygon(std::vector<PointVector> boundaries, const char* name);

// The polygon with all vertices mapped, each coordinate correctly rounded. The numbers of vertices
// and edges stay. Throws Error: range where a coordinate is beyond the largest double; degenerate
// and not_simple where the result is no polygon.
Polygon mapped(const Polygon& polygon, const AffineMap& map, const char* name);

// The area without the holes, correctly rounded to nearest; infinite where it is beyond the largest
// double.
double area_of(const Polygon& polygon);

// The outer ring, which keeps the polygon alive. Holes never change an outer face.
inline std::shared_ptr<const Boundary> outer_ring(const std::shared_ptr<const Polygon>& polygon) {
  return {polygon, &polygon->outer};
}

}  // namespace gcv
