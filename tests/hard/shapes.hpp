// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What the families are made of.
#pragma once

#include <random>
#include <utility>
#include <vector>

#include "invariants.hpp"

namespace gcv::hard {

using invariants::Point;
using invariants::Polygon;
using Random = std::mt19937_64;

// Uniform in [low, high].
int uniform(Random& random, int low, int high);

// A linear map and a shift: (x, y) to (xx x + xy y + x0, yx x + yy y + y0).
struct Map {
  double xx = 1;
  double xy = 0;
  double yx = 0;
  double yy = 1;
  double x0 = 0;
  double y0 = 0;
};

Polygon mapped(Polygon polygon, const Map& map);
Polygon negated(const Polygon& polygon);
Polygon scaled(const Polygon& polygon, double factor);
Polygon moved(const Polygon& polygon, double x, double y);

// The rotation by the angle of the Pythagorean triple (m^2 - n^2, 2 m n, m^2 + n^2), in
// doubles; and the same times m^2 + n^2, which is exact on integers.
Map rotation(int m, int n);
Map exact_rotation(int m, int n);
Map random_rotation(Random& random);

Polygon rectangle(double width, double height);

// A block with a slot from its upper side: a neck, and below it a chamber that may be
// wider.
struct Slot {
  int neck_width;
  int neck_depth;
  int chamber_width;
  int chamber_depth;
};
Polygon block_with(const Slot& slot);
// What fills the slot exactly, upright.
Polygon key_of(const Slot& slot);
Slot random_slot(Random& random);

// A block with a random slot and, negated, a part that fits its neck or all of it exactly,
// turned by the same angle in doubles. Of which kind they are goes by k modulo 3.
std::pair<Polygon, Polygon> rotated_slot(Random& random, int k);

// Teeth that point upwards from a bar.
Polygon comb(int teeth, double width, double gap, double height);
// A wall of thickness 1 that winds inwards, with a corridor of width 1 along it.
Polygon square_spiral(int turns);
// Columns of random integer widths and heights.
Polygon histogram(Random& random, int columns, int extent);
// Spikes around a point, symmetric to both axes and both diagonals.
Polygon symmetric_star(int tip, int diagonal_tip, int valley);
// Points on the circle of radius 1, four times as many as given, which cos and sin are not
// needed for.
Polygon circle(int quarter);
// Points of the circle pulled towards its centre by random amounts.
Polygon random_star(Random& random, int quarter);
// The same with every other point further out than all others: spikes, close together.
Polygon spiky_star(Random& random, int quarter);
// A random simple polygon on points of the grid [0, extent]^2.
Polygon random_on_grid(Random& random, int vertices, int extent);

// One of each kind, of small integers.
std::vector<Polygon> small_shapes();

}  // namespace gcv::hard
