// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The points in which rings of one polygon touch each other. The solid has several cones there.
#pragma once

#include <cstddef>
#include <vector>

#include "point.hpp"
#include "ring_layout.hpp"

namespace gcv {

// A point in which rings touch. It is a vertex of one of them, at least.
struct Touch {
  std::vector<Index> vertices;  // in that point
  std::vector<Index> leaving;   // edges that leave the point: from a vertex, or through the point
  std::vector<Index> arriving;  // edges that arrive there
};

class Touches {
 public:
  Touches() = default;
  // O(n log n) where the boxes of few edges overlap.
  Touches(const PointVector& points, const RingLayout& layout);

  [[nodiscard]] bool empty() const { return all_.empty(); }
  [[nodiscard]] const std::vector<Touch>& all() const { return all_; }
  // The touch in a vertex, or nullptr.
  [[nodiscard]] const Touch* at(Index vertex) const {
    return empty() || at_[vertex] == none ? nullptr : &all_[at_[vertex]];
  }
  // One vertex for each point on the inside of an edge in which others touch it, in their order
  // along the edge.
  [[nodiscard]] const std::vector<Index>& on(Index edge) const {
    return empty() ? nowhere_ : on_[edge];
  }

 private:
  static constexpr Index none = 0xffffffff;

  std::vector<Touch> all_;
  std::vector<Index> at_;               // of each vertex; empty if there are none
  std::vector<std::vector<Index>> on_;  // of each edge; likewise
  std::vector<Index> nowhere_;
};

}  // namespace gcv
