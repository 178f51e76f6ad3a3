// SPDX-License-Identifier: LGPL-3.0-or-later
#include "walked_lines.hpp"

#include <cmath>

#include "predicates.hpp"
#include "vector.hpp"

namespace gcv {

WalkedLines::WalkedLines(const Operands& operands, double slack, Tally& tally)
    : operands_(operands),
      unit_(8 * slack),
      tally_(tally),
      edges_of_rank_(2 * std::size_t{operands.directions.half_turn}) {
  for (const Ranks* ranks : {&operands.directions.rank_a, &operands.directions.rank_b}) {
    for (const Rank rank : *ranks) {
      ++edges_of_rank_[rank];
    }
  }
}

std::int64_t WalkedLines::place_of(const PairEdge& s) const {
  const auto [from, to] = operands_.source(s);
  const Point unit = unit_vector(direction(from, to));
  const Point p = operands_.relative_start(s);
  const double place = std::floor((unit.x * p.y - unit.y * p.x) / unit_);
  return std::abs(place) < 0x1p62 ? static_cast<std::int64_t>(place) : 0;
}

bool WalkedLines::is_on_line(const PairEdge& s, const PairEdge& line) {
  return s.rank == line.rank &&
         side(coordinates(operands_.a, operands_.b, line), operands_.start(s), tally_) == 0;
}

int WalkedLines::compare_along(const PairEdge& s, const VertexSum& p, const VertexSum& q) {
  if (p == q) {
    return 0;
  }
  const auto [from, to] = operands_.source(s);
  const Boundary& a = operands_.a;
  const Boundary& b = operands_.b;
  if (from.x != to.x) {
    const int order = compare_sums(a.vertices[q.i].x, b.vertices[q.j].x, a.vertices[p.i].x,
                                   b.vertices[p.j].x, tally_);
    return from.x < to.x ? order : -order;
  }
  const int order = compare_sums(a.vertices[q.i].y, b.vertices[q.j].y, a.vertices[p.i].y,
                                 b.vertices[p.j].y, tally_);
  return from.y < to.y ? order : -order;
}

// Extends the first part that overlaps the given one. False if there is none on its line.
bool WalkedLines::extend(std::vector<Part>& parts, const Part& part, bool& is_held) {
  for (Part& other : parts) {
    if (!is_on_line(part.edge, other.edge) || compare_along(part.edge, other.to, part.from) > 0 ||
        compare_along(part.edge, part.to, other.from) > 0) {
      continue;
    }
    const bool begins_before = compare_along(part.edge, part.from, other.from) > 0;
    const bool ends_behind = compare_along(part.edge, other.to, part.to) > 0;
    is_held = !begins_before && !ends_behind;
    if (begins_before) {
      other.from = part.from;
    }
    if (ends_behind) {
      other.to = part.to;
    }
    return true;
  }
  return false;
}

bool WalkedLines::hold(const PairEdge& s) {
  if (edges_of_rank_[s.rank] == 1) {
    return false;
  }
  const Part part{s, start_of(s), end_of(operands_, s)};
  const std::int64_t place = place_of(s);
  const auto key = [&](std::int64_t p) {
    return static_cast<std::uint64_t>(p) * 0x9e3779b97f4a7c15U + s.rank;
  };
  bool is_held = false;
  for (const std::int64_t near : {place, place - 1, place + 1}) {
    const auto parts = parts_.find(key(near));
    if (parts != parts_.end() && extend(parts->second, part, is_held)) {
      return is_held;
    }
  }
  parts_[key(place)].push_back(part);
  return false;
}

}  // namespace gcv
