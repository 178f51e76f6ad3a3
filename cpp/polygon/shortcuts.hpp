// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A ring cut into chains, each replaced by one segment or by its outer hull. First step of the
// simplification (see simplification.cpp).
#pragma once

#include <cstddef>
#include <vector>

#include "boundary.hpp"
#include "point.hpp"
#include "rounding_direction.hpp"
#include "scaled_ring.hpp"

namespace gcv {

// A vertex of the new boundary and the edge behind it. Lengths are in the units of ScaledRing.
struct NewVertex {
  Point point;
  // The given vertices that it replaces, from the first to the last.
  Index first;
  Index last;
  double error;    // the distance of vertex and edge from what they replace, at most
  double allowed;  // the tolerance there
};
using NewBoundary = std::vector<NewVertex>;

// Vertex k. The one after the last is the first.
inline const NewVertex& at(const NewBoundary& boundary, std::size_t k) {
  return boundary[k == boundary.size() ? 0 : k];
}

class Shortcuts {
 public:
  // The ring must outlive this.
  Shortcuts(const Boundary& ring, double tolerance, Rounding rounding);

  [[nodiscard]] const Boundary& ring() const { return ring_; }
  [[nodiscard]] const ScaledRing& scaled() const { return scaled_; }
  [[nodiscard]] const Point& vertex(Index i) const {
    return ring_.vertices[i == ring_.size() ? 0 : i];
  }

  // The boundary of shortcuts within the present tolerances. Outward, no chain is to the right of
  // its shortcut.
  [[nodiscard]] NewBoundary boundary() const;

  // Vertex i with the segment to vertex j.
  [[nodiscard]] NewVertex segment(Index i, Index j) const;

  // Vertex a with the segment to vertex `end`. It replaces the edges behind a and b, where b
  // follows a. Both are within e of their chains and b is within d of the new segment: so the
  // new segment is within e + d. Measures the chains again only if e + d is too much.
  [[nodiscard]] NewVertex joined(const NewVertex& a, const NewVertex& b, Index end) const;

  // Cuts the tolerance along the chains that these edges replace to a quarter. It becomes 0 below a
  // hundredth of the first tolerance, or if `at_once`.
  void cut_tolerance(const NewBoundary& boundary, const std::vector<Index>& edges, bool at_once);

 private:
  [[nodiscard]] std::vector<Index> three_corners() const;
  [[nodiscard]] Index end_of_chain(Index i, Index limit) const;
  [[nodiscard]] bool fits(Index i, Index j) const;
  void append_hull(Index i, Index j, NewBoundary& boundary) const;
  void append_hull_edge(Index i, Index j, NewBoundary& boundary) const;

  const Boundary& ring_;
  const ScaledRing scaled_;
  const Rounding rounding_;
  const double allowed_at_first_;
  std::vector<double> allowed_;  // the tolerance along each edge
  const std::vector<Index> corners_;
};

}  // namespace gcv
