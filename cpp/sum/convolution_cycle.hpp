// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The superset edges of a convex polygon and another one, in the order of their convolution cycle
// (Guibas, Ramshaw and Stolfi, "A kinetic framework for computational geometry", 1983): along the
// boundary of the other polygon, while a tangent turns round the convex one. Where the convex one
// is small beside the reflex parts of the other, most of them lie on the outer face and come near
// no others but their neighbours: one search for pairs that are near serves the whole walk.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "box.hpp"
#include "contributing_vertices.hpp"
#include "point.hpp"

namespace gcv {

class ConvolutionCycle {
 public:
  // None where not just one polygon is convex, or where searches for each step would take less. Of
  // superset edges that lie on others of the same direction, some are left out. The directions need
  // not be known. O(n + m).
  static std::optional<ConvolutionCycle> find(const Operands& operands, Tally& tally);

  // Edges and gaps are numbered together, from 0.
  [[nodiscard]] Index size() const { return static_cast<Index>(links_.size()); }
  [[nodiscard]] bool is_gap(Index number) const { return links_[number].is_gap; }
  [[nodiscard]] const EdgeName& edge(Index number) const { return links_[number].edge; }

  // Has the edge the direction of the one before it in the cycle?
  [[nodiscard]] bool goes_straight_on(Index number) const { return links_[number].is_straight; }

  // The number of the edge that starts in a vertex of the hull of the sum. O(n + m).
  [[nodiscard]] Index first_from(Index i, Index j) const;

  // The numbers of edges, among them all that have a point in common with an edge but itself and
  // its neighbours in the cycle: the one before it ends in its start, next() starts in its end.
  [[nodiscard]] std::span<const Index> near(Index number) const {
    const Link& link = links_[number];
    return std::span(near_).subspan(link.first_near, link.near_count);
  }

  // The edge that follows in the cycle; none where that has a gap.
  [[nodiscard]] std::optional<Index> next(Index number) const {
    const Index next = number + 1 == size() ? 0 : number + 1;
    return is_gap(next) ? std::nullopt : std::optional(next);
  }

  // The same where no other edge comes near: then it is the only way on.
  [[nodiscard]] std::optional<Index> only_way_on(Index number) const {
    return links_[number].near_count == 0 ? next(number) : std::nullopt;
  }

 private:
  class Tracing;

  // An edge, or else a gap: the way from the end of one edge to the start of the next.
  struct Link {
    EdgeName edge;
    bool is_gap;
    bool is_straight;  // it goes straight on from the edge before
    std::uint8_t near_count = 0;
    Index first_near = 0;  // where near() begins in near_
  };

  ConvolutionCycle() = default;
  bool find_near(std::span<const Point> starts, const Box& bounds);

  std::vector<Link> links_;
  Buffer<Index> near_;
};

}  // namespace gcv
