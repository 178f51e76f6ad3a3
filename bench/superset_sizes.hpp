// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How many candidate edges the methods have whose sums are faces of an arrangement.
#pragma once

#include <cstdint>

#include "systems/system.hpp"

namespace gcv::bench {

// Each set has edges of one polygon + vertices of the other whose turn holds the direction of the
// edge. A turn goes from the edge that ends in the vertex to the edge that starts there.
struct SupersetSizes {
  // Whatever the turns.
  std::uint64_t all_pairs = 0;
  // All turns go to the left: at reflex vertices, by more than half a turn (Wein, "Exact and
  // efficient construction of planar Minkowski sums using the convolution method", 2006). What
  // CGAL's full convolution traces.
  std::uint64_t full_convolution = 0;
  // Turns at reflex vertices go to the right (Guibas, Ramshaw and Stolfi, "A kinetic framework for
  // computational geometry", 1983).
  std::uint64_t convolution_cycles = 0;
  // Convex vertices alone (Behar and Lien, "Fast and robust 2D Minkowski sum using reduced
  // convolution", 2011).
  std::uint64_t reduced_convolution = 0;
  // The superset of the paper: turns have both ends, and parallel edges are merged.
  std::uint64_t gcv = 0;
};

// Collinear vertices are dropped first. Of edges of equal direction, that of B comes before that of
// A in the convolutions.
SupersetSizes superset_sizes(const Ring& a, const Ring& b);

}  // namespace gcv::bench
