// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Ways from two arrays of doubles to the whole sum of two polygons, holes and all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "exact_geometry.hpp"
#include "point.hpp"

namespace gcv::bench {

using Ring = PointVector;

// The rings of a sum: of a point inside, the number of outer rings round it is one more than that
// of the holes round it.
template <class AnyRing>
struct Whole {
  std::vector<AnyRing> outer;
  std::vector<AnyRing> holes;
};
using WholeInDoubles = Whole<Ring>;
using ExactWhole = Whole<invariants::Ring>;

struct WholeSystem {
  std::string name;
  // What is timed: from doubles to doubles.
  std::function<WholeInDoubles(const Ring& a, const Ring& b)> sum;
  // Untimed, with the exact coordinates where the system has them.
  std::function<ExactWhole(const Ring& a, const Ring& b)> exact_sum;
};

// All systems of this build but libgcv.
std::vector<WholeSystem> whole_systems();

// CGAL with its exact kernel.
WholeInDoubles cgal_reduced_whole(const Ring& a, const Ring& b);
ExactWhole cgal_reduced_exact_whole(const Ring& a, const Ring& b);
WholeInDoubles cgal_decomposition_whole(const Ring& a, const Ring& b);
ExactWhole cgal_decomposition_exact_whole(const Ring& a, const Ring& b);
// Do the interiors of a and of x - b meet? By CGAL's do_intersect, which knows nothing of sums.
bool overlap_at(const Ring& a, const Ring& b, const invariants::Exact& x);

// SFCGAL through its C interface.
WholeInDoubles sfcgal_whole(const Ring& a, const Ring& b);
ExactWhole sfcgal_exact_whole(const Ring& a, const Ring& b);

// Clipper2 on a grid of 29 bits: MinkowskiSum as it is, which sums outlines; and united with a
// translate of each polygon, so that what the outlines enclose is filled.
WholeInDoubles clipper2_outlines_whole(const Ring& a, const Ring& b);
WholeInDoubles clipper2_filled_whole(const Ring& a, const Ring& b);

// GEOS in doubles: the union of the parallelograms of all pairs of edges and of a translate of
// each polygon.
WholeInDoubles geos_whole(const Ring& a, const Ring& b);

// libgcv through its C interface, from doubles to doubles. Of a region, segments and points are
// copied out too.
void libgcv_outer_face(const Ring& a, const Ring& b);
void libgcv_region(const Ring& a, const Ring& b, std::uint64_t leave_out = 0);

struct RegionSize {
  std::size_t holes = 0;
  std::size_t fits = 0;  // segments and points
  std::size_t vertices = 0;
};
RegionSize libgcv_region_size(const Ring& a, const Ring& b);

// Segments and points: the second end of a point is the first.
struct ExactFit {
  invariants::Exact from;
  invariants::Exact to;
};
struct ExactRegion {
  ExactWhole whole;
  std::vector<ExactFit> fits;
};
ExactRegion libgcv_exact_region(const Ring& a, const Ring& b);

}  // namespace gcv::bench
