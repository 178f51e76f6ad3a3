// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The exact ring of the outer face. Each vertex is stored as the vertices or edges that it comes
// from.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "boundary.hpp"
#include "contributing_vertices.hpp"

namespace gcv {

// An operand of a sum: a ring, and the name of its polygon in messages, such as "a" or "fixed".
// `error_bound` is the distance of the ring from the ring that it replaces, at most.
struct Operand {
  std::shared_ptr<const Boundary> ring;
  const char* name;
  double error_bound = 0;
};

// A vertex of the outer face. It is the sum of two vertices, or else the crossing of the edge that
// arrives with the edge that leaves. Takes 24 bytes, because long rings consist of these.
class RingVertex {
 public:
  static RingVertex sum(Index i, Index j, const EdgeName& arriving, const EdgeName& leaving) {
    return {i, j, arriving, leaving};
  }
  static RingVertex crossing(const EdgeName& arriving, const EdgeName& leaving) {
    return {no_sum, 0, arriving, leaving};
  }

  [[nodiscard]] bool is_sum() const { return i_ != no_sum; }
  // The two vertices of a sum.
  [[nodiscard]] Index i() const { return i_; }
  [[nodiscard]] Index j() const { return j_; }
  // The superset edges that arrive at the vertex and leave it. If several collinear ones follow
  // each other, `leaving` is the first and `arriving` is the last. If neither polygon is convex,
  // they may be any of these.
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
    static constexpr Index corner_bit = 0x80000000;  // more than any index
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

struct ExactRing {
  Operand a;
  Operand b;
  Point shift;  // added to every vertex
  std::vector<RingVertex> vertices;
  bool chains_are_repeated = false;  // see Walk
  bool against_edges = false;        // edges have the opposite directions of their superset edges

  [[nodiscard]] std::size_t size() const { return vertices.size(); }
};

}  // namespace gcv
