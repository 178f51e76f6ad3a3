// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <vector>

#include "chord_tree.hpp"
#include "contributing_vertices.hpp"
#include "sectors.hpp"

namespace gcv {

// What is below a node of a tree: the directions of edges and of the cones of convex vertices, and
// how many edges.
struct EdgesBelow {
  Sectors edges = 0;
  Sectors cones = 0;
  Index size = 0;
};

// May there be superset edges of these directions below two nodes?
inline bool have_superset_edges(const EdgesBelow& a, const EdgesBelow& b, Sectors wanted) {
  return (((a.edges & b.cones) | (a.cones & b.edges)) & wanted) != 0;
}

// Of all nodes of a tree. O(n).
std::vector<EdgesBelow> all_edges_below(const ChordTree& tree, const Boundary& polygon,
                                        const Ranks& ranks, const Directions& directions);

}  // namespace gcv
