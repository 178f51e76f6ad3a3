// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Random cases for regions, full of ties: slots and what just fits in them, holes that touch,
// containers that leave no room. A seed gives the same cases everywhere.
#pragma once

#include <span>
#include <vector>

#include "generators.hpp"
#include "point.hpp"

namespace gcv::test {

// The rings of a polygon, the outer one first, each either way round.
using Rings = std::vector<PointVector>;

// All rings, each negated.
Rings negated(const Rings& rings);

// Either the sum a + b + shift; or an inner fit: the positions of the point `shift` of b, with b
// inside a.
struct RegionCase {
  Rings a;
  Rings b;
  bool inner_fit = false;
  Point shift{0, 0};
};

// Polygons on a small grid. Some with their own reflection.
RegionCase small_integers(Random& random);

// Columns of integer sizes.
RegionCase histograms(Random& random);

// Narrow corridors without a loop, and rectangles about as wide as they: corridors as a container,
// cut into a block from outside, or as a hole of a block.
RegionCase mazes(Random& random);

// A comb and another one whose teeth just fit between its own, or nearly so.
RegionCase combs(Random& random);

// A block with a pocket behind a mouth, and a rectangle that just fits in, or nearly so.
RegionCase c_shapes(Random& random);

// A block with a slot in steps, and what just fills the slot, with or without a handle.
RegionCase keys_and_locks(Random& random);

// A rectangle cut in two along a polyline: an exact fit.
RegionCase jigsaws(Random& random);

// Exact fits of the other families, turned. Most turns are rounded to doubles, with the same
// roundings on both sides; what was parallel is then so only nearly.
RegionCase turned_fits(Random& random);

// A container, some with holes, and a small polygon in it, often just as wide as some part of the
// container.
RegionCase containers(Random& random);

// Holes that touch the outer ring or one another in points, in many cases so that the inside falls
// apart. Sums and inner fits.
RegionCase holes_that_touch(Random& random);

// Operands with holes, and what just fits in the holes. Sums and inner fits.
RegionCase with_holes(Random& random);

struct RegionFamily {
  const char* name;
  RegionCase (*next_case)(Random& random);
};

// All of them.
std::span<const RegionFamily> region_families();

}  // namespace gcv::test
