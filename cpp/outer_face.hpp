// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The walk along the outer face of the sum (the paper, section 4.3, way 1), over the
// implicit superset. Every decision is exact.
#pragma once

#include <cstdint>
#include <vector>

#include "contributing_vertices.hpp"
#include "predicates.hpp"
#include "task.hpp"

namespace gcv {

// A vertex of the outer face: the sum of two vertices, or else the crossing of the edge that
// arrives with the edge that leaves. In 24 bytes: long rings are made of nothing else.
class RingVertex {
 public:
  static RingVertex sum(Index i, Index j, const EdgeName& arriving, const EdgeName& leaving) {
    return {i, j, arriving, leaving};
  }
  static RingVertex crossing(const EdgeName& arriving, const EdgeName& leaving) {
    return {no_sum, 0, arriving, leaving};
  }

  [[nodiscard]] bool is_sum() const { return i_ != no_sum; }
  // Of a sum, the vertices.
  [[nodiscard]] Index i() const { return i_; }
  [[nodiscard]] Index j() const { return j_; }
  // Of collinear superset edges in a row, the last that arrives and the first that leaves.
  [[nodiscard]] EdgeName arriving() const { return arriving_.name(); }
  [[nodiscard]] EdgeName leaving() const { return leaving_.name(); }

  void arrive_by(const EdgeName& edge) { arriving_ = Packed(edge); }

 private:
  static constexpr Index no_sum = 0xffffffff;

  class Packed {
   public:
    explicit Packed(const EdgeName& e)
        : i_(e.kind == EdgeName::corner ? e.i | corner_bit : e.i), j_(e.j) {}
    [[nodiscard]] EdgeName name() const {
      return {(i_ & corner_bit) != 0 ? EdgeName::corner : EdgeName::translated, i_ & ~corner_bit,
              j_};
    }

   private:
    static constexpr Index corner_bit = 0x80000000;  // beyond all indices
    Index i_;
    Index j_;
  };

  RingVertex(Index i, Index j, const EdgeName& arriving, const EdgeName& leaving)
      : i_(i), j_(j), arriving_(arriving), leaving_(leaving) {}

  Index i_;
  Index j_;
  Packed arriving_;
  Packed leaving_;
};

// The outer face as the walk found it: counter-clockwise, from the lexicographically
// smallest vertex, without collinear vertices. Edge k leaves vertex k.
struct Walk {
  std::vector<RingVertex> vertices;
  std::uint64_t steps = 0;
  std::uint64_t candidates = 0;
  // The edges of the vertices are any of those that coincide with them (repeated_chains.hpp).
  bool chains_are_repeated = false;
};

Walk walk_outer_face(const Polygon& a, const Polygon& b, Task& task, Tally& tally);

}  // namespace gcv
