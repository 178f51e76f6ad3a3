// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A polygon with holes in fractions, or all that is outside of one, for references: no tree, no
// filter, nothing kept.
#pragma once

#include <cstdint>
#include <vector>

#include "exact_geometry.hpp"

namespace gcv::reference {

using invariants::Exact;
using invariants::Rational;

// The rings of a polygon as a caller passes them, the outer one first.
using Rings = std::vector<invariants::Polygon>;

// An edge has the solid on its left.
struct Edge {
  Exact from;
  Exact to;
  std::uint32_t number;  // the caller's
};

struct Corner {
  Exact before;
  Exact place;
  Exact after;
  std::uint32_t number;  // the caller's

  // Is the solid of this ring less than a half-plane here?
  [[nodiscard]] bool is_convex() const { return invariants::orientation(before, place, after) > 0; }
};

struct Solid {
  std::vector<invariants::Ring> rings;
  // Of all rings, without repeated and collinear vertices. Edge k starts at corner k.
  std::vector<Edge> edges;
  std::vector<Corner> corners;
  // Points strictly inside: some in each component of the interior.
  std::vector<Exact> inner_points;
  bool is_complement = false;  // all outside of the rings, and their holes
};

// The rings must be those of a valid polygon. Numbers are as in gcv_edge_source.
Solid make_solid(const Rings& rings);

// The solid of a container: all outside of the polygon, its holes too. What has a number keeps it.
Solid complement(const Solid& polygon);

Solid moved(const Solid& solid, const Exact& t);

// 1 strictly inside, 0 on a ring, -1 outside.
int location(const Solid& solid, const Exact& x);

// Is x on the edge, but not at its ends?
bool is_inside_edge(const Edge& edge, const Exact& x);

}  // namespace gcv::reference
