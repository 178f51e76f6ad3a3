// SPDX-License-Identifier: LGPL-3.0-or-later
#include "places_on_line.hpp"

namespace gcv {

int PlacesOnLine::side_of_sum(const Line& line, const VertexSum& sum) const {
  if (sum == start_of(line.edge) || sum == end_of(operands_, line.edge)) {
    ++tally_.filtered;
    return 0;
  }
  return side(line.at, operands_.point(sum), tally_);
}

int PlacesOnLine::side_of(const Line& other, const Place& place) const {
  if (place.is_sum) {
    return side_of_sum(other, place.sum);
  }
  const int turn = turn_from(other);
  if (turn == 0) {
    return side_of_sum(other, start_of(line_.edge));
  }
  const EdgeName& name = place.crossing;
  const EdgeName& name_of_other = other.edge;
  if (name == name_of_other) {
    ++tally_.filtered;
    return 0;
  }
  const std::optional<Interval> parameter = rough_crossing_parameter(line_.at, other.at);
  if (const int order = parameter ? order_of(place.parameter, *parameter) : 0; order != 0) {
    ++tally_.filtered;
    return turn * order;
  }
  const Line across = Line::of(operands_, place.crossing);
  if (this->turn(across.edge.rank, other.edge.rank) == 0) {
    return side(other.at, across.at.origin, tally_);
  }
  if (!kept_ || !(kept_->name == name)) {
    kept_ = {name, Crossing(line_.at, across.at)};
  }
  return turn * kept_->crossing.compare(other.at, tally_);
}

int PlacesOnLine::compare(const Place& p, const Place& q) const {
  if (p.is_sum && q.is_sum) {
    if (p.sum == q.sum) {
      return 0;
    }
    const SumPoint x = operands_.point(p.sum);
    const SumPoint y = operands_.point(q.sum);
    const SumEdge& s = line_.at;
    if (s.from.x != s.to.x) {
      const int order = compare_x(x, y, tally_);
      return s.from.x < s.to.x ? order : -order;
    }
    const int order = compare_y(x, y, tally_);
    return s.from.y < s.to.y ? order : -order;
  }
  if (p.is_sum) {
    return -compare(q, p);
  }
  if (q.is_sum) {
    const Line r = Line::of(operands_, p.crossing);
    return -turn_from(r) * side_of_sum(r, q.sum);
  }
  const EdgeName& e = p.crossing;
  const EdgeName& f = q.crossing;
  if (e == f) {
    ++tally_.filtered;
    return 0;
  }
  if (const int order = order_of(p.parameter, q.parameter); order != 0) {
    ++tally_.filtered;
    return order;
  }
  return compare_crossings(line_.at, coordinates(operands_.a, operands_.b, e),
                           coordinates(operands_.a, operands_.b, f), tally_);
}

}  // namespace gcv
