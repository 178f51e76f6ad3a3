// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The superset edges of a convex polygon and another one, in the order of their convolution cycle
// (Guibas, Ramshaw and Stolfi, "A kinetic framework for computational geometry", 1983): along the
// boundary of the other polygon, while the convex one turns with it. Most of them lie on the outer
// face, and most come near no others but their neighbours: one look for pairs that are near each
// other serves the whole walk.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contributing_vertices.hpp"
#include "point.hpp"

namespace gcv {

class ConvolutionCycle {
 public:
  // None where not just one polygon is convex, or too many edges come near each other. O(n + m).
  static std::optional<ConvolutionCycle> find(const Operands& operands);

  [[nodiscard]] const PairEdge& edge(Index number) const { return links_[number].edge; }

  // The number of the edge that starts in a vertex of the hull of the sum. O(n + m).
  [[nodiscard]] Index first_from(Index i, Index j) const;

  // The numbers of edges, among them all that have a point in common with an edge but itself and
  // its neighbours in the cycle: the one before it ends in its start, next() starts in its end.
  [[nodiscard]] std::span<const Index> near(Index number) const {
    const Link& link = links_[number];
    return std::span(near_).subspan(link.first_near, link.near_count);
  }

  // The edge that follows in the cycle; none where that has a gap, at a reflex vertex.
  [[nodiscard]] std::optional<Index> next(Index number) const {
    const Index next = number + 1 == links_.size() ? 0 : number + 1;
    return links_[next].is_gap ? std::nullopt : std::optional(next);
  }

  // The same where no other edge comes near: then it is the only way on.
  [[nodiscard]] std::optional<Index> only_way_on(Index number) const {
    return links_[number].near_count == 0 ? next(number) : std::nullopt;
  }

 private:
  class Tracing;

  // An edge, or else the way from the end of the edge before it to the start of the next one.
  struct Link {
    PairEdge edge;
    bool is_gap;
    std::uint8_t near_count = 0;
    Index first_near = 0;  // where near() begins in near_
  };

  ConvolutionCycle() = default;
  bool find_near(std::span<const Point> starts);

  std::vector<Link> links_;
  std::vector<Index> near_;
};

}  // namespace gcv
