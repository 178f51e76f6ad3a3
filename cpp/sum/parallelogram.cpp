// SPDX-License-Identifier: LGPL-3.0-or-later
#include "parallelogram.hpp"

#include <cassert>

namespace gcv {

std::optional<Parallelogram> Parallelogram::of(const Operands& operands, Index i, Index j) {
  const Directions& directions = operands.directions;
  const Rank angle = directions.angle(directions.rank_a[i], directions.rank_b[j]);
  if (angle == 0 || angle == directions.half_turn) {
    return std::nullopt;
  }
  const int sign = angle < directions.half_turn ? 1 : -1;
  const auto line = [&](const PairEdge& edge) { return Line::of(operands, edge); };
  Parallelogram result;
  result.sides_[0] = {line(operands.translated(i, j)), sign};
  result.sides_[1] = {line(operands.translated(i, operands.b.next(j))), -sign};
  result.sides_[2] = {line(operands.corner(i, j)), -sign};
  result.sides_[3] = {line(operands.corner(operands.a.next(i), j)), sign};
  return result;
}

Place Parallelogram::exit(const PlacesOnLine& places) const {
  std::optional<Place> exit;
  for (const Side& side : sides_) {
    if (places.turn_from(side.line) == -side.sign) {
      const Place place = places.crossing(side.line);
      if (!exit || places.compare(place, *exit) < 0) {
        exit = place;
      }
    }
  }
  assert(exit);
  return *exit;
}

}  // namespace gcv
