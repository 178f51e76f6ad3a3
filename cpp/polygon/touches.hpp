// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The points in which rings of one polygon touch each other. The solid has several cones there.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "point.hpp"
#include "ring_layout.hpp"

namespace gcv {

// The solid cones in a point of a polygon: one, but where rings touch.
template <class Cone>
struct ConesInPoint {
  Cone first;
  std::vector<Cone> others;

  // Does the test hold for one of them?
  template <class Test>
  [[nodiscard]] bool any(Test test) const {
    return test(first) || std::any_of(others.begin(), others.end(), test);
  }
  template <class Visit>
  void for_each(Visit visit) const {
    visit(first);
    std::for_each(others.begin(), others.end(), visit);
  }
};

// A point in which rings touch. It is a vertex of one of them, at least.
struct Touch {
  std::vector<Index> vertices;  // in that point
  std::vector<Index> leaving;   // edges that leave the point: from a vertex, or through the point
  std::vector<Index> arriving;  // edges that arrive there
};

class Touches {
 public:
  Touches() = default;
  // None yet, of so many vertices.
  explicit Touches(Index size) : size_(size) {}
  // O(n log n).
  Touches(const PointVector& points, const RingLayout& layout);

  // Those of the vertices from `first` on.
  void add(const Touches& others, Index first);

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

  Index size_ = 0;
  std::vector<Touch> all_;
  std::vector<Index> at_;               // of each vertex; empty if there are none
  std::vector<std::vector<Index>> on_;  // of each edge; likewise
  std::vector<Index> nowhere_;
};

}  // namespace gcv
