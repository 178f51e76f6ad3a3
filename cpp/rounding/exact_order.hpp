// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The exact lexicographic order of the vertices of a sum.
#pragma once

#include <optional>
#include <vector>

#include "box.hpp"
#include "double_double_rounding.hpp"
#include "exact_ring.hpp"
#include "tally.hpp"

namespace gcv {

// Compares by the nearest doubles at first: rounding is monotonic.
class ExactOrder {
 public:
  // Of vertices of a + b + shift.
  ExactOrder(const Boundary& a, const Boundary& b, const Point& shift, Tally& tally)
      : a_(a), b_(b), shift_(shift), tally_(tally) {}

  // A vertex and its nearest doubles.
  struct Placed {
    RingVertex vertex;
    RoundedVertex nearest;
  };
  [[nodiscard]] Placed placed(const RingVertex& vertex) const;

  // Negative if p comes first, 0 if they are one point.
  [[nodiscard]] int compare(const Placed& p, const Placed& q) const;
  [[nodiscard]] int compare(const Placed& p, const Point& q) const;
  [[nodiscard]] int compare(const RingVertex& p, const RingVertex& q) const {
    return compare(placed(p), placed(q));
  }

  // A box that holds the edge from p to q.
  [[nodiscard]] static Box box_of_edge(const Placed& p, const Placed& q);

  // Lets each ring begin with its smallest vertex, and sorts the rings by their vertices.
  void sort(std::vector<std::vector<RingVertex>>& rings) const;

 private:
  struct Sum {
    double a;
    double b;
    double c;
  };
  [[nodiscard]] std::optional<Sum> sum_of(const RingVertex& v, double Point::*axis) const;
  [[nodiscard]] int compare_exactly(const Placed& p, const Placed& q, double Point::*axis) const;

  const Boundary& a_;
  const Boundary& b_;
  Point shift_;
  Tally& tally_;
};

}  // namespace gcv
