// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Bottom-left nesting of parts in a strip, by several systems.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "point.hpp"

namespace gcv::bench {

using Ring = PointVector;

struct NestingJob {
  std::string name;
  double length;  // of the strip from (0, 0) to (length, height)
  double height;
  std::vector<Ring> shapes;        // counter-clockwise
  std::vector<std::size_t> order;  // indices of shapes, in the order of placing
};

// Places one part after another, each at the lexicographically smallest of its free positions.
class Nester {
 public:
  Nester() = default;
  Nester(const Nester&) = delete;
  Nester& operator=(const Nester&) = delete;
  virtual ~Nester() = default;
  // Nothing where the system finds no position.
  virtual std::optional<Point> place(std::size_t shape) = 0;
};

// By gcv_scene_best, and by the smallest vertex of gcv_scene_free_region.
std::unique_ptr<Nester> libgcv_best_nester(const NestingJob& job);
std::unique_ptr<Nester> libgcv_region_nester(const NestingJob& job);
// The inner-fit rectangle less the union of no-fit polygons: with the exact kernel; and on the grid
// of Clipper2. No-fit polygons are kept for each pair of shapes, or made anew each time.
enum class NoFits { kept, anew };
std::unique_ptr<Nester> cgal_nester(const NestingJob& job, NoFits no_fits);
std::unique_ptr<Nester> clipper2_nester(const NestingJob& job, NoFits no_fits);

// How many of the parts overlap those before them, or the outside of the strip: exactly. Deep ones
// would have to move by more than 10^-6 of the height of the strip.
struct Overlaps {
  std::size_t all = 0;
  std::size_t deep = 0;
};
Overlaps count_overlaps(const NestingJob& job, const std::vector<std::optional<Point>>& positions);

}  // namespace gcv::bench
