// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The exact lexicographic order of the vertices of a region.
#pragma once

#include <vector>

#include "box.hpp"
#include "contributing_vertices.hpp"
#include "exact_ring.hpp"
#include "tally.hpp"

namespace gcv {

class ExactOrder {
 public:
  ExactOrder(const Operands& operands, Tally& tally) : operands_(operands), tally_(tally) {}

  // Negative if p comes first, 0 if they are one point. By the nearest doubles at first: rounding is
  // monotonic.
  [[nodiscard]] int compare(const RingVertex& p, const RingVertex& q) const;

  // A box that holds the edge from p to q.
  [[nodiscard]] Box box_of_edge(const RingVertex& p, const RingVertex& q) const;

  // Do the vertices of the first ring come before those of the second?
  [[nodiscard]] bool is_before(const std::vector<RingVertex>& p,
                               const std::vector<RingVertex>& q) const;

  // Rotates the ring.
  void begin_with_smallest(std::vector<RingVertex>& ring) const;

 private:
  const Operands& operands_;
  Tally& tally_;
};

}  // namespace gcv
