// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A polygon with fewer vertices, near the given one, for scenes that need no more.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "polygon.hpp"

namespace gcv {

// The values are those of gcv_options.rounding.
enum class Rounding : std::int32_t { nearest = 0, outward = 1 };

struct Simplified {
  std::shared_ptr<const Polygon> polygon;
  // No point of either boundary is further than this from the other boundary.
  double error_bound = 0;
};

// A simple polygon whose boundary is within `tolerance` of that of the given one. Nearest:
// its vertices are some of the given ones. Outward: it contains the given polygon, and has
// new vertices where edges are lengthened until they meet. Numbers are those of the caller's
// vertices and edges; what stands for several has the number of the first.
//
// The given polygon itself where more than so many vertices would be left. O(n log n), but for
// shapes most of whose boundary is within the tolerance of other parts of it.
Simplified simplify(const std::shared_ptr<const Polygon>& polygon, double tolerance,
                    Rounding rounding, std::size_t most_vertices);

}  // namespace gcv
