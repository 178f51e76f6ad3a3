// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A sweep over rings that may touch one another in points, but do not cross. A line goes over the
// vertices in lexicographic order, as in simplicity.cpp. It keeps the edges that it meets in order,
// from bottom to top.
#pragma once

#include <span>

#include "point.hpp"
#include "ring_layout.hpp"
#include "tally.hpp"

namespace gcv {

class RingVisitor {
 public:
  static constexpr Index none = 0xffffffff;

  struct Place {
    std::span<const Index> vertices;  // in the point, at least one
    Index through;                    // the edge that goes through it, if there is one, or none
    bool is_first;                    // does no edge arrive in the point or go through it?
    Index below;                      // the edge right below the point, or none
  };

  RingVisitor() = default;
  RingVisitor(const RingVisitor&) = delete;
  RingVisitor& operator=(const RingVisitor&) = delete;
  virtual ~RingVisitor() = default;

  // The line comes to a point.
  virtual void pass(const Place& place) = 0;
  // Edges become neighbours, the first one below, that do not both have the point. If two edges
  // cross, two that do are met before the line comes to their crossing: the sweep must end there.
  virtual void meet(Index below, Index above) = 0;
};

// Each ring is simple. O(n log n).
void sweep_over(std::span<const Point> points, const RingLayout& layout, RingVisitor& visitor,
                Tally& tally);

}  // namespace gcv
