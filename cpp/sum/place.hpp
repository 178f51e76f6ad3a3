// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where a walk is: places on superset edges, exactly.
#pragma once

#include "contributing_vertices.hpp"
#include "predicates.hpp"

namespace gcv {

// A point on a superset edge: a sum of two vertices, or else the crossing with `crossing`. The
// parameter of that on the edge is enclosed by `parameter`.
struct Place {
  bool is_sum;
  VertexSum sum;
  PairEdge crossing;
  Interval parameter;

  static Place of(const VertexSum& sum) { return {true, sum, {}, {}}; }
  void become(const VertexSum& vertex_sum) {
    is_sum = true;
    sum = vertex_sum;
  }
};

// A superset edge with its coordinates.
struct Line {
  PairEdge edge;
  SumEdge at;

  static Line of(const Operands& operands, const PairEdge& edge) {
    return {edge, coordinates(operands.a, operands.b, edge)};
  }
};

// A superset edge that leaves another one to the right, and where.
struct Event {
  Line line;
  Place place;
};

}  // namespace gcv
