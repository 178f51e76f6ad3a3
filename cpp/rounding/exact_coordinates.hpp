// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The exact coordinates of a vertex of the exact ring, as integers over a common denominator. Heavy
// headers: include this in source files only.
#pragma once

#include "exact_numbers.hpp"
#include "exact_ring.hpp"

namespace gcv {

// A vertex of the exact ring. Holds the numbers that its coordinates are computed from, and their
// grid.
class ExactVertex {
 public:
  ExactVertex(const Boundary& a, const Boundary& b, const RingVertex& vertex, const Point& shift)
      : vertex_(vertex), shift_(shift) {
    if (vertex_.is_sum()) {
      sum_ = point_of(a, b, {vertex_.i(), vertex_.j()});
      grid_ = Grid{shift_};
      grid_.include(sum_);
    } else {
      s_ = coordinates(a, b, vertex_.arriving());
      t_ = coordinates(a, b, vertex_.leaving());
      grid_ = Grid{shift_};
      grid_.include(s_);
      grid_.include(t_);
    }
  }

  [[nodiscard]] const Grid& grid() const { return grid_; }

  // The bits of x, y and w in homogeneous().
  [[nodiscard]] int bits() const {
    return vertex_.is_sum() ? grid_.bits() + 2 : crossing_bits(grid_.bits());
  }

  // The vertex is (x / w, y / w) * 2^grid().exponent(), with w > 0.
  template <class Integer>
  [[nodiscard]] HomogeneousPoint<Integer> homogeneous() const {
    if (!vertex_.is_sum()) {
      return crossing<Integer>(grid_, s_, t_, shift_);
    }
    const Vector<Integer> sum = sum_of<Integer>(grid_, sum_, shift_);
    return {sum.x, sum.y, Integer(1)};
  }

 private:
  RingVertex vertex_;
  Point shift_;
  SumPoint sum_{};
  SumEdge s_{};
  SumEdge t_{};
  Grid grid_;
};

}  // namespace gcv
