// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <optional>

#include "contributing_vertices.hpp"
#include "exact_ring.hpp"
#include "place.hpp"
#include "predicates.hpp"

namespace gcv {

// Places on the line of a superset edge s, compared. All exact.
class PlacesOnLine {
 public:
  PlacesOnLine(const Operands& operands, const PairEdge& s, Tally& tally)
      : operands_(operands), line_(Line::of(operands, s)), tally_(tally) {}

  [[nodiscard]] const Line& line() const { return line_; }
  [[nodiscard]] Place start() const { return Place::of(start_of(line_.edge)); }
  [[nodiscard]] Place end() const { return Place::of(end_of(operands_, line_.edge)); }

  // The crossing with another line, which is not parallel.
  [[nodiscard]] Place crossing(const Line& other) const {
    return {false, {}, other.edge, crossing_parameter(line_.at, other.at)};
  }

  // A vertex on the line, as its crossing with that edge if it is no sum of two vertices.
  [[nodiscard]] Place place(const RingVertex& v, const EdgeName& edge) const {
    return v.is_sum() ? Place::of({v.i(), v.j()})
                      : crossing(Line::of(operands_, operands_.named(edge)));
  }

  // The sign of the turn from e to f: 1 to the left, 0 for opposite directions too.
  [[nodiscard]] int turn(Rank e, Rank f) const {
    const Directions& directions = operands_.directions;
    const Rank angle = directions.angle(e, f);
    return angle == 0 || angle == directions.half_turn ? 0 : angle < directions.half_turn ? 1 : -1;
  }
  // From another line to s.
  [[nodiscard]] int turn_from(const Line& other) const {
    return turn(other.edge.rank, line_.edge.rank);
  }

  // Is the edge parallel to s, the other way round too?
  [[nodiscard]] bool is_parallel(const EdgeName& edge) const {
    return turn(operands_.named(edge).rank, line_.edge.rank) == 0;
  }

  // The side of another line on which the place lies: 1 left, -1 right, 0 on it.
  [[nodiscard]] int side_of(const Line& other, const Place& place) const;
  // The order of two places along s.
  [[nodiscard]] int compare(const Place& p, const Place& q) const;

 private:
  [[nodiscard]] int side_of_sum(const Line& line, const VertexSum& sum) const;

  const Operands& operands_;
  Line line_;
  Tally& tally_;
  struct Kept {
    EdgeName name;
    Crossing crossing;
  };
  mutable std::optional<Kept> kept_;  // the last one that others were compared with
};

}  // namespace gcv
