// SPDX-License-Identifier: LGPL-3.0-or-later
#include <clipper2/clipper.h>

#include "grid.hpp"
#include "whole.hpp"

namespace gcv::bench {

namespace {

using Clipper2Lib::Path64;
using Clipper2Lib::Paths64;
using Grid = IntegerGrid<std::int64_t>;

Path64 to_path(const Grid& grid, const Ring& ring) {
  Path64 path;
  for (const Point& p : ring) {
    path.emplace_back(grid.to_grid(p.x), grid.to_grid(p.y));
  }
  return path;
}

WholeInDoubles to_whole(const Grid& grid, const Paths64& paths) {
  WholeInDoubles whole;
  for (const Path64& path : paths) {
    Ring ring;
    for (const Clipper2Lib::Point64& p : path) {
      ring.push_back({grid.from_grid(p.x), grid.from_grid(p.y)});
    }
    (Clipper2Lib::IsPositive(path) ? whole.outer : whole.holes).push_back(ring);
  }
  return whole;
}

WholeInDoubles sum(const Ring& a, const Ring& b, bool is_filled) {
  const Grid grid(cells_per_unit(a, b, 29), Clipper2Lib::MAX_COORD);
  const Path64 p = to_path(grid, a);
  const Path64 q = to_path(grid, b);
  Paths64 paths = Clipper2Lib::MinkowskiSum(p, q, true);
  if (is_filled) {
    paths.push_back(Clipper2Lib::TranslatePath(p, q[0].x, q[0].y));
    paths.push_back(Clipper2Lib::TranslatePath(q, p[0].x, p[0].y));
    paths = Clipper2Lib::Union(paths, Clipper2Lib::FillRule::NonZero);
  }
  return to_whole(grid, paths);
}

}  // namespace

WholeInDoubles clipper2_outlines_whole(const Ring& a, const Ring& b) { return sum(a, b, false); }
WholeInDoubles clipper2_filled_whole(const Ring& a, const Ring& b) { return sum(a, b, true); }

}  // namespace gcv::bench
