// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Polygons of small integers: all there are, and samples.
#pragma once

#include <cstdint>
#include <vector>

#include "plane.hpp"
#include "symmetries.hpp"

namespace worlds {

// All simple polygons with up to so many corners on a square grid of so many points, but one alone
// of those that are translates of one another. Each begins in its smallest corner and lies in the
// corner of the grid.
class Catalogue {
 public:
  Catalogue(int grid, int corners);

  [[nodiscard]] const std::vector<Ring>& rings() const { return rings_; }
  [[nodiscard]] const Images& images() const { return images_; }

 private:
  std::vector<Ring> rings_;
  Images images_;
};

// The same numbers from the same seed everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  // From 0 up to below `end`.
  Int below(Int end);

 private:
  std::uint64_t state_;
};

// A simple ring with three to six corners on a grid.
Ring random_ring(Random& random, int grid, int corners);

struct Sample {
  Polygon polygon;
  // Rings that make no polygon.
  std::vector<Polygon> refused;
};

// A polygon with up to two holes.
Sample random_polygon(Random& random, int grid, int holes);

}  // namespace worlds
