// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The references that the walk is compared with, by CGAL (GPL: in tests only). Rings are
// given as the library gives them: counter-clockwise, from the lexicographically
// smallest vertex, without collinear vertices, each vertex as "p/q r/s".
#pragma once

#include <span>
#include <string>
#include <vector>

#include "point.hpp"
#include "superset.hpp"

namespace gcv::reference {

using FractionRing = std::vector<std::string>;

// The paper's way 2: the boundary of the unbounded face of the arrangement of all
// superset edges. Throws std::runtime_error where that is not one ring.
FractionRing arrangement_outer_face(std::span<const SupersetEdge> superset);

// The outer boundary of CGAL's own Minkowski sum, by its reduced convolution. It shares
// no code with the library.
FractionRing reduced_convolution(std::span<const Point> a, std::span<const Point> b);

// The holes of CGAL's own Minkowski sum, by its reduced convolution, which may miss some that touch
// others. Likewise counter-clockwise.
// Polygons are given by their rings, the outer one first, each either way round.
std::vector<FractionRing> holes(std::span<const PointVector> a, std::span<const PointVector> b);

// CGAL's simplicity test.
bool is_simple(std::span<const Point> ring);

}  // namespace gcv::reference
