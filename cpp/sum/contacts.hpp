// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where A and x - B touch, for a place x on a superset edge, and what these contacts block. All
// exact.
//
// A contact is a pair of features: a vertex or an edge of A, and a vertex or an edge of B, not two
// edges. Each has a solid cone, an open arc of directions. A small displacement d of x makes the
// interiors meet at the contact just when d lies in the open sum of both cones. If the cone of A
// and the turned cone of B overlap, this is every d, and d = 0 too: x lies in the open sum. Else
// the sum of the cones is the shorter of the arcs that hold both. Two parallel edges that touch
// have an end of one on the other: these contacts say all. Where rings of a polygon touch, the
// solid has several cones in one point.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "contributing_vertices.hpp"
#include "place.hpp"

namespace gcv {

// An open arc of directions, counter-clockwise from one rank to another: at most a full turn.
struct DirectionArc {
  Rank from;
  Rank length;
};

using ConesOfPoint = ConesInPoint<DirectionArc>;

// Arcs of directions and what two cones do to each other.
class Cones {
 public:
  // Where rings touch in the points given, the cones are those of all of them.
  Cones(const Operands& operands, const Touches& touches_a, const Touches& touches_b)
      : operands_(operands), touches_a_(touches_a), touches_b_(touches_b) {}

  // The solid cones of a vertex of A or B, and that of an edge.
  [[nodiscard]] ConesOfPoint vertex_of_a(Index i) const {
    return vertex(operands_.a, operands_.directions.rank_a, touches_a_, i);
  }
  [[nodiscard]] ConesOfPoint vertex_of_b(Index j) const {
    return vertex(operands_.b, operands_.directions.rank_b, touches_b_, j);
  }
  [[nodiscard]] ConesOfPoint edge_of_a(Index i) const {
    return {{operands_.directions.rank_a[i], half_turn()}, {}};
  }
  [[nodiscard]] ConesOfPoint edge_of_b(Index j) const {
    return {{operands_.directions.rank_b[j], half_turn()}, {}};
  }

  // Do the cone of A and the turned cone of B overlap?
  [[nodiscard]] bool overlap(const DirectionArc& a, const DirectionArc& b) const {
    const Rank turned = (b.from + half_turn()) % (2 * half_turn());
    return angle(a.from, turned) < a.length || angle(turned, a.from) < b.length;
  }
  [[nodiscard]] bool overlap(const ConesOfPoint& a, const ConesOfPoint& b) const {
    return a.any([&](const DirectionArc& p) {
      return b.any([&](const DirectionArc& q) { return overlap(p, q); });
    });
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
  // The angle to the way back along an edge.
  [[nodiscard]] Rank angle_to_back(Rank from, Rank arriving) const {
    return angle(from, (arriving + half_turn()) % (2 * half_turn()));
  }
  [[nodiscard]] ConesOfPoint vertex(const Boundary& polygon, const Ranks& ranks,
                                    const Touches& touches, Index i) const {
    const Touch* const touch = touches.at(i);
    if (touch == nullptr) {
      return {{ranks[i], angle_to_back(ranks[i], ranks[polygon.previous(i)])}, {}};
    }
    const auto cone_from = [&](Rank from) {
      Rank length = 2 * half_turn();
      for (const Index arriving : touch->arriving) {
        length = std::min(length, angle_to_back(from, ranks[arriving]));
      }
      return DirectionArc{from, length};
    };
    ConesOfPoint cones{cone_from(ranks[touch->leaving.front()]), {}};
    for (std::size_t k = 1; k < touch->leaving.size(); ++k) {
      cones.others.push_back(cone_from(ranks[touch->leaving[k]]));
    }
    return cones;
  }

  const Operands& operands_;
  const Touches& touches_a_;
  const Touches& touches_b_;
};

// The displacements of a place that contacts block. Of a place that is not in the open sum.
class BlockedDirections {
 public:
  explicit BlockedDirections(const Directions& directions) : directions_(directions) {}

  void add(const DirectionArc& arc) { arcs_.push_back(arc); }

  // Leaves out arcs that others hold together. What is blocked stays the same.
  void leave_few() {
    std::vector<std::uint64_t> keys;  // of two that begin in one direction, the longer first
    for (const DirectionArc& arc : arcs_) {
      keys.push_back(std::uint64_t{arc.from} << 32 | static_cast<Rank>(~arc.length));
    }
    std::sort(keys.begin(), keys.end());
    const auto end = [](const DirectionArc& arc) { return arc.from + arc.length; };
    std::vector<DirectionArc> few;
    for (const std::uint64_t key : keys) {
      const DirectionArc arc{static_cast<Rank>(key >> 32), ~static_cast<Rank>(key)};
      if (!few.empty() && end(arc) <= end(few.back())) {
        continue;
      }
      if (few.size() > 1 && arc.from < end(few[few.size() - 2])) {
        few.pop_back();
      }
      few.push_back(arc);
    }
    arcs_ = std::move(few);
  }

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
  // Are the directions next to it, counter-clockwise, blocked?
  [[nodiscard]] bool hold_left_of(Rank rank) const {
    return any(
        [&](const DirectionArc& arc) { return directions_.angle(arc.from, rank) < arc.length; });
  }
  // Is the direction, or the opposite one, free, while those next to it are blocked, and do `more`
  // of them hold it?
  [[nodiscard]] bool leave_a_way_along(Rank rank, const BlockedDirections& more) const {
    const Rank half = directions_.half_turn;
    const auto is_way = [&](Rank r) {
      return more.holds(r) && !holds(r) && hold_right_of(r) && hold_left_of(r);
    };
    return is_way(rank) || is_way((rank + half) % (2 * half));
  }
  // The arcs between those that are blocked.
  [[nodiscard]] std::vector<DirectionArc> free_arcs() const {
    const Rank turn = 2 * directions_.half_turn;
    std::vector<DirectionArc> free;
    for (const DirectionArc& arc : arcs_) {
      const Rank from = (arc.from + arc.length) % turn;
      if (!hold_left_of(from)) {
        Rank length = turn;
        for (const DirectionArc& next : arcs_) {
          const Rank angle = directions_.angle(from, next.from);
          length = std::min(length, angle == 0 ? turn : angle);
        }
        free.push_back({from, length});
      }
    }
    return free;
  }
  // Is every direction blocked but single ones?
  [[nodiscard]] bool hold_almost_all() const {
    return !arcs_.empty() && std::all_of(arcs_.begin(), arcs_.end(), [&](const DirectionArc& arc) {
      return hold_left_of((arc.from + arc.length) % (2 * directions_.half_turn));
    });
  }
  // Is every direction blocked?
  [[nodiscard]] bool hold_all() const {
    return !arcs_.empty() && std::all_of(arcs_.begin(), arcs_.end(), [&](const DirectionArc& arc) {
      return holds((arc.from + arc.length) % (2 * directions_.half_turn));
    });
  }

 private:
  template <class Test>
  [[nodiscard]] bool any(Test test) const {
    return std::any_of(arcs_.begin(), arcs_.end(), test);
  }

  const Directions& directions_;
  std::vector<DirectionArc> arcs_;
};

}  // namespace gcv
