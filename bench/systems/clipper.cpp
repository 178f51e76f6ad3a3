// SPDX-License-Identifier: LGPL-3.0-or-later
#include <polyclipping/clipper.hpp>
#include <stdexcept>

#include "grid.hpp"

namespace gcv::bench {

namespace {

using Grid = IntegerGrid<ClipperLib::cInt>;

ClipperLib::Path to_path(const Grid& grid, const Ring& ring) {
  ClipperLib::Path path;
  for (const Point& p : ring) {
    path.emplace_back(grid.to_grid(p.x), grid.to_grid(p.y));
  }
  return path;
}

}  // namespace

// The union is part of ClipperLib::MinkowskiSum. Outlines are summed, so that there can be
// false holes; the outer boundary is the largest ring.
Job clipper(const Ring& a, const Ring& b, double cells_per_unit) {
  return {[&a, &b, cells_per_unit] {
    const Grid grid(cells_per_unit, ClipperLib::hiRange);
    ClipperLib::Paths sums;
    ClipperLib::MinkowskiSum(to_path(grid, a), to_path(grid, b), sums, true);
    if (sums.empty()) {
      throw std::runtime_error("empty");
    }
    const auto largest = std::max_element(
        sums.begin(), sums.end(),
        [](const auto& p, const auto& q) { return ClipperLib::Area(p) < ClipperLib::Area(q); });
    Ring ring;
    for (const ClipperLib::IntPoint& p : *largest) {
      ring.push_back({grid.from_grid(p.X), grid.from_grid(p.Y)});
    }
    return ring;
  }};
}

}  // namespace gcv::bench
