// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where A and x - B touch, for a place x on a superset edge, and what these contacts block. All
// exact.
//
// A contact is a pair of features: a vertex or an edge of A, and a vertex or an edge of B, not two
// edges. Each has a solid cone, an open arc of directions. A small displacement d of x makes the
// interiors meet at the contact just when d lies in the open sum of both cones. If the cone of A and
// the turned cone of B overlap, this is every d, and d = 0 too: x lies in the open sum. Else the sum
// of the cones is the shorter of the arcs that hold both. Two parallel edges that touch have an end
// of one on the other: these contacts say all.
#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>

#include "contributing_vertices.hpp"
#include "place.hpp"
#include "witness.hpp"

namespace gcv {

// An open arc of directions, counter-clockwise from one rank to another: at most a full turn.
struct DirectionArc {
  Rank from;
  Rank length;
};

// Arcs of directions and what two cones do to each other.
class Cones {
 public:
  explicit Cones(const Operands& operands) : operands_(operands) {}

  // The solid cone of a vertex or an edge of A or B.
  [[nodiscard]] DirectionArc vertex_of_a(Index i) const {
    return vertex(operands_.a, operands_.directions.rank_a, i);
  }
  [[nodiscard]] DirectionArc vertex_of_b(Index j) const {
    return vertex(operands_.b, operands_.directions.rank_b, j);
  }
  [[nodiscard]] DirectionArc edge_of_a(Index i) const {
    return {operands_.directions.rank_a[i], half_turn()};
  }
  [[nodiscard]] DirectionArc edge_of_b(Index j) const {
    return {operands_.directions.rank_b[j], half_turn()};
  }

  // Do the cone of A and the turned cone of B overlap?
  [[nodiscard]] bool overlap(const DirectionArc& a, const DirectionArc& b) const {
    const Rank turned = (b.from + half_turn()) % (2 * half_turn());
    return angle(a.from, turned) < a.length || angle(turned, a.from) < b.length;
  }
  // The sum of cones for which this is not so: the shorter arc that holds both.
  [[nodiscard]] DirectionArc sum(const DirectionArc& a, const DirectionArc& b) const {
    const Rank from_a = std::max(a.length, angle(a.from, b.from) + b.length);
    const Rank from_b = std::max(b.length, angle(b.from, a.from) + a.length);
    return from_a <= from_b ? DirectionArc{a.from, from_a} : DirectionArc{b.from, from_b};
  }

 private:
  [[nodiscard]] Rank half_turn() const { return operands_.directions.half_turn; }
  [[nodiscard]] Rank angle(Rank from, Rank to) const {
    return operands_.directions.angle(from, to);
  }
  [[nodiscard]] DirectionArc vertex(const Boundary& polygon, const Ranks& ranks, Index i) const {
    const Rank back = (ranks[polygon.previous(i)] + half_turn()) % (2 * half_turn());
    return {ranks[i], angle(ranks[i], back)};
  }

  const Operands& operands_;
};

// The displacements of a place that contacts block. Of a place that is not in the open sum.
class BlockedDirections {
 public:
  explicit BlockedDirections(const Directions& directions) : directions_(directions) {}

  void add(const DirectionArc& arc) { arcs_.push_back(arc); }

  [[nodiscard]] bool holds(Rank rank) const {
    return any([&](const DirectionArc& arc) {
      const Rank angle = directions_.angle(arc.from, rank);
      return angle > 0 && angle < arc.length;
    });
  }
  // Are the directions next to it, clockwise, blocked?
  [[nodiscard]] bool hold_right_of(Rank rank) const {
    return any([&](const DirectionArc& arc) {
      const Rank angle = directions_.angle(arc.from, rank);
      return (angle == 0 && arc.length == 2 * directions_.half_turn) ||
             (angle > 0 && angle <= arc.length);
    });
  }
  // Is every direction blocked?
  [[nodiscard]] bool hold_all() const {
    if (arcs_.empty()) {
      return false;
    }
    for (const DirectionArc& arc : arcs_) {
      const Rank turn = 2 * directions_.half_turn;
      const Rank end = (arc.from + arc.length) % turn;
      if (!holds(end)) {
        return false;
      }
    }
    return true;
  }

 private:
  template <class Test>
  [[nodiscard]] bool any(Test test) const {
    for (const DirectionArc& arc : arcs_) {
      if (test(arc)) {
        return true;
      }
    }
    return false;
  }

  const Directions& directions_;
  boost::container::small_vector<DirectionArc, 16> arcs_;
};

}  // namespace gcv
