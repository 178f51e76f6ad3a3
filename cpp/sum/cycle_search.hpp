// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>

#include "contributing_vertices.hpp"
#include "convolution_cycle.hpp"
#include "predicates.hpp"
#include "stretch.hpp"

namespace gcv {

// Finds superset edges along the convolution cycle, for a walk on them. The directions need not be
// known: the edges have no ranks.
class CycleSearch {
 public:
  CycleSearch(const Operands& operands, const ConvolutionCycle& cycle)
      : operands_(operands), cycle_(cycle) {}

  // The sign of the turn from e to f, 1 to the left; 0 for opposite ones too.
  int turn(const EdgeName& e, const EdgeName& f, Tally& tally) const {
    const auto [e_from, e_to] = operands_.source(e);
    const auto [f_from, f_to] = operands_.source(f);
    return gcv::turn(e_from, e_to, f_from, f_to, tally);
  }

  [[nodiscard]] Way way(const EdgeName& s, const EdgeName& e, Tally& tally) const {
    const int order = turn(s, e, tally);
    return order < 0 ? Way::right : order == 0 && are_opposite(s, e) ? Way::back : Way::onwards;
  }

  // In the cycle it is one that leaves a vertex of the hull.
  std::pair<PairEdge, PairEdge> edges_from(Index i, Index j) {
    number_ = cycle_.first_from(i, j);
    const PairEdge edge = unranked(cycle_.edge(number_));
    return {edge, edge};
  }

  // The walk takes that edge, which find() has told of.
  void follow(const EdgeName& edge) {
    for (const Index number : cycle_.near(number_)) {
      if (is_number_of(edge, number)) {
        number_ = number;
        return;
      }
    }
    number_ = *cycle_.next(number_);
  }

  struct Successor {
    const EdgeName& edge;
    bool is_straight;
  };

  std::optional<Successor> only_way_on() {
    const std::optional<Index> next = cycle_.only_way_on(number_);
    if (!next) {
      return std::nullopt;
    }
    number_ = *next;
    return Successor{cycle_.edge(*next), cycle_.goes_straight_on(*next)};
  }

  // No more than two edges of one direction follow each other.
  struct Continuation {
    VertexSum end;
    double length;
  };
  static std::optional<Continuation> continued(const PairEdge& /*s*/, const VertexSum& /*from*/) {
    return std::nullopt;
  }

  template <class Step>
  void find(Step& step) const {
    for (const Index number : cycle_.near(number_)) {
      step.consider(unranked(cycle_.edge(number)));
    }
    if (const std::optional<Index> number = cycle_.next(number_)) {
      step.consider(unranked(cycle_.edge(*number)));
    }
  }

 private:
  static PairEdge unranked(const EdgeName& edge) { return {edge, 0}; }

  [[nodiscard]] bool is_number_of(const EdgeName& e, Index number) const {
    return e == cycle_.edge(number);
  }

  // Are parallel edges opposite to each other?
  [[nodiscard]] bool are_opposite(const EdgeName& e, const EdgeName& f) const {
    const auto [e_from, e_to] = operands_.source(e);
    const auto [f_from, f_to] = operands_.source(f);
    return points_up(e_from, e_to) != points_up(f_from, f_to);
  }

  const Operands& operands_;
  const ConvolutionCycle& cycle_;
  Index number_ = 0;  // of the edge that the walk is on
};

}  // namespace gcv
