// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The explicit superset of the outer face (the paper, section 3): translated edges,
// corner edges, and translated-corner edges by the three cases.
#pragma once

#include <vector>

#include "contributing_vertices.hpp"
#include "point.hpp"

namespace gcv {

// The kinds of superset edges; the values are those of gcv_edge_source.
enum class EdgeKind : std::int32_t { translated = 1, corner = 2, translated_corner = 3 };

// Where an edge comes from: numbers of vertices or edges of the normalised polygons.
struct EdgeSource {
  EdgeKind kind;
  Index a;
  Index b;
};

struct SupersetEdge {
  SumPoint from;
  SumPoint to;
  EdgeSource source;
};

// All superset edges: translated, then corner, then translated-corner edges, each kind
// in the order of a, then b. O((n + m) log(n + m) + edges log edges).
std::vector<SupersetEdge> enumerate_superset(const Operands& operands);

// The superset edge that the translated or corner edge e belongs to.
EdgeSource superset_source(const Operands& operands, const EdgeName& e);

}  // namespace gcv
