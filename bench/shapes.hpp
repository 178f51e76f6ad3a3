// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Polygons that are made up. All randomness is in integers of the generator passed in;
// star-shaped ones are simple whatever their radii.
#pragma once

#include "generators.hpp"

namespace gcv::bench {

using test::Random;
using test::Ring;

// A coast round a point, by halving arcs and displacing their middles in proportion to
// their length: detail at all scales. The number of vertices is a multiple of 4.
Ring coast(Random& random, int vertices);
// The same, displaced in proportion to a power of their length, the Hurst exponent: the smaller,
// the rougher. Between 0 and 1.
Ring rough_coast(Random& random, int vertices, double hurst);

// All vertices on a circle: at equal angles, or at random ones.
Ring regular(int vertices, double radius);
Ring random_convex(Random& random, int vertices);

// From 3 to 8 vertices with small integer coordinates.
Ring tiny(Random& random);

// Teeth that point upwards from a bar.
Ring comb(int teeth);
// The same, with teeth and gaps of that width.
Ring comb(int teeth, double width, double height);
// The same with teeth and gaps of widths that differ by up to 1/64.
Ring uneven_comb(Random& random, int teeth);
Ring quarter_turned(Ring ring);

// Koch's snowflake: 3 * 4^level vertices.
Ring koch(int level);

// A thin strip that goes to and fro.
Ring zigzag(int corners, double height = 40);

// Turned by some 37 degrees and five times as large: the exact numbers stay whole ones.
Ring slanting(Ring ring);

// A square that is turned, and so many points on each side: as near to it as doubles are.
Ring divided_square(int points_a_side);

// A wall that winds inwards: 8 vertices a turn.
Ring spiral(int turns);

// Spikes to the right, a thousand times as long as wide, in nearly the same direction.
Ring needles(int spikes);

// A bar with thin bristles of random lengths, each at a small random angle.
Ring hairbrush(Random& random, int bristles);

// A tree whose branches fork in two, 2^levels leaves in all, at slightly random angles.
Ring forked_tree(Random& random, int levels);

// Arms round a disc, each a thin arc of that many pieces.
Ring sunburst(int arms, int pieces);

// A wire of constant thickness along a random walk, which goes to the right with every step.
Ring wire(Random& random, int steps);

// Teeth round a disc: 4 vertices each.
Ring gear(int teeth);
// Teeth on a bar, upright on one side and slanted on the other: 2 vertices each.
Ring saw(int teeth);

// A square plate with a square grid of square holes. Slits join those of a row, and the
// last one to the outside.
Ring plate(int holes_in_a_row);

// The walls of a random maze, and Hilbert's curve, both on a square grid of cells, half as
// thick as cells are wide. The second has 2^level cells in a row.
Ring maze(Random& random, int cells_in_a_row);
Ring hilbert(int level);

Ring scaled(Ring ring, double factor);
Ring moved(Ring ring, double x, double y);

}  // namespace gcv::bench
