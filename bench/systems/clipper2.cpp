// SPDX-License-Identifier: LGPL-3.0-or-later
#include <clipper2/clipper.h>

#include <stdexcept>

#include "grid.hpp"

namespace gcv::bench {

namespace {

using Grid = IntegerGrid<std::int64_t>;

Clipper2Lib::Path64 to_path(const Grid& grid, const Ring& ring) {
  Clipper2Lib::Path64 path;
  for (const Point& p : ring) {
    path.emplace_back(grid.to_grid(p.x), grid.to_grid(p.y));
  }
  return path;
}

}  // namespace

// As in clipper.cpp.
Job clipper2(const Ring& a, const Ring& b, double cells_per_unit) {
  return {[&a, &b, cells_per_unit] {
    const Grid grid(cells_per_unit, Clipper2Lib::MAX_COORD);
    const Clipper2Lib::Paths64 sums =
        Clipper2Lib::MinkowskiSum(to_path(grid, a), to_path(grid, b), true);
    if (sums.empty()) {
      throw std::runtime_error("empty");
    }
    const auto largest = std::max_element(
        sums.begin(), sums.end(),
        [](const auto& p, const auto& q) { return Clipper2Lib::Area(p) < Clipper2Lib::Area(q); });
    Ring ring;
    for (const Clipper2Lib::Point64& p : *largest) {
      ring.push_back({grid.from_grid(p.x), grid.from_grid(p.y)});
    }
    return ring;
  }};
}

}  // namespace gcv::bench
