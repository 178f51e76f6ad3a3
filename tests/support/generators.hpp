// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Polygons for tests. All randomness comes from the generator passed in, and only
// through integers, so that a seed gives the same polygons everywhere.
#pragma once

#include <random>

#include "point.hpp"

namespace gcv::test {

using Ring = PointVector;
using Random = std::mt19937_64;

// Uniform in [low, high].
int uniform(Random& random, int low, int high);

// A simple polygon on random points of the integer grid [0, extent]^2, full of ties.
Ring random_small_integer_polygon(Random& random, int vertices, int extent);

// Columns of integer widths and heights on a common base; now and then with a base that
// is as ragged as the top.
Ring random_histogram(Random& random, int columns, int extent);

// A star-shaped polygon whose radii alternate between long and short.
Ring random_spiky_star(Random& random, int vertices);

// A block, 8 high, with slits from its top to 2 above its base, which lie `slant` further to the
// right at their ends. The slits are 4 1/7 apart.
Ring block_with_slits(int slits, double width, double slant);

// { -p : p in ring }
Ring negated(Ring ring);

}  // namespace gcv::test
