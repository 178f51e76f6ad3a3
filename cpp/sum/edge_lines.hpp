// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "contributing_vertices.hpp"
#include "key_numbers.hpp"
#include "predicates.hpp"
#include "tally.hpp"
#include "vector.hpp"

namespace gcv {

// The sign of the way along an edge from p to q, both on its line.
inline int compare_along(const Operands& operands, const EdgeName& s, const SumPoint& p,
                         const SumPoint& q, Tally& tally) {
  const auto [from, to] = operands.source(s);
  if (from.x != to.x) {
    const int order = compare_x(q, p, tally);
    return from.x < to.x ? order : -order;
  }
  const int order = compare_y(q, p, tally);
  return from.y < to.y ? order : -order;
}

// The directed lines that superset edges lie on, each with a value. Edges that overlap have several
// names and one line. Lines are found by their places in doubles, and compared exactly.
template <class Value>
class EdgeLines {
 public:
  // `slack`: how far coordinates of points in relative coordinates may be off.
  EdgeLines(const Operands& operands, double slack, Tally& tally)
      : operands_(operands), unit_(8 * slack), tally_(tally) {}

  void clear() {
    keys_.clear();
    first_.clear();
    crowds_.clear();
    lines_.clear();
  }

  // Null if it is not there.
  Value* find(const PairEdge& s) {
    const std::int64_t place = place_of(s);
    for (const std::int64_t near : {place, place - 1, place + 1}) {
      const std::uint32_t number = keys_.find(key(s, near));
      if (number != none) {
        const std::span<const std::uint32_t> lines = lines_of(number);
        const Place among = place_among(lines, s);
        if (among.is_there) {
          return &lines_[lines[among.k]].value;
        }
      }
    }
    return nullptr;
  }

  // Adds it, if it is not there. It may be moved when others are added.
  Value& at(const PairEdge& s) {
    if (Value* const value = find(s)) {
      return *value;
    }
    const auto line = static_cast<std::uint32_t>(lines_.size());
    const auto [number, is_new] = keys_.add(key(s, place_of(s)));
    if (is_new) {
      first_.push_back(line);
    } else {
      add_to_crowd(number, line, s);
    }
    lines_.push_back({s, none, {}});
    return lines_.back().value;
  }

 private:
  struct Line {
    PairEdge edge;        // that lies on it
    std::uint32_t crowd;  // of the first line of a key that has several
    Value value;
  };

  struct Same {
    std::uint64_t operator()(std::uint64_t key) const { return key; }
  };
  using Keys = KeyNumbers<std::uint64_t, Same, std::equal_to<>>;
  static constexpr std::uint32_t none = Keys::none;

  // In units of several times the slack: the same for all edges on a line, or next to that.
  [[nodiscard]] std::int64_t place_of(const PairEdge& s) const {
    const auto [from, to] = operands_.source(s);
    const Point unit = unit_vector(direction(from, to));
    const Point p = operands_.relative_start(s);
    const double place = std::floor((unit.x * p.y - unit.y * p.x) / unit_);
    return std::abs(place) < 0x1p62 ? static_cast<std::int64_t>(place) : 0;
  }
  static std::uint64_t key(const PairEdge& s, std::int64_t place) {
    return static_cast<std::uint64_t>(place) * 0x9e3779b97f4a7c15U + s.rank;
  }
  // The sign of the order of a line and that of an edge: 1 if the line comes first.
  int compare(std::uint32_t line, const PairEdge& s) {
    const PairEdge& edge = lines_[line].edge;
    const EdgeName& name = edge;
    if (name == s) {
      return 0;
    }
    return edge.rank != s.rank
               ? (edge.rank < s.rank ? 1 : -1)
               : side(coordinates(operands_.a, operands_.b, edge), operands_.start(s), tally_);
  }
  // Those of a key, in order: of one direction, from right to left.
  std::span<const std::uint32_t> lines_of(std::uint32_t number) {
    const std::uint32_t crowd = lines_[first_[number]].crowd;
    return crowd == none ? std::span<const std::uint32_t>(&first_[number], 1)
                         : std::span<const std::uint32_t>(crowds_[crowd]);
  }
  void add_to_crowd(std::uint32_t number, std::uint32_t line, const PairEdge& s) {
    Line& first = lines_[first_[number]];
    if (first.crowd == none) {
      first.crowd = static_cast<std::uint32_t>(crowds_.size());
      crowds_.push_back({first_[number]});
    }
    std::vector<std::uint32_t>& crowd = crowds_[first.crowd];
    crowd.insert(crowd.begin() + static_cast<std::ptrdiff_t>(place_among(crowd, s).k), line);
  }

  // Where the line of an edge is among lines in order, or would be.
  struct Place {
    std::size_t k;
    bool is_there;
  };
  Place place_among(std::span<const std::uint32_t> lines, const PairEdge& s) {
    std::size_t first = 0;
    for (std::size_t last = lines.size(); first < last;) {
      const std::size_t middle = first + (last - first) / 2;
      const int order = compare(lines[middle], s);
      if (order == 0) {
        return {middle, true};
      }
      (order > 0 ? first : last) = order > 0 ? middle + 1 : middle;
    }
    return {first, false};
  }

  const Operands& operands_;
  double unit_;
  Tally& tally_;
  std::vector<Line> lines_;
  Keys keys_{{}, {}};
  std::vector<std::uint32_t> first_;  // line of each key
  // In a row of members whose positions are rounded, thousands of lines have one place in doubles.
  std::vector<std::vector<std::uint32_t>> crowds_;
};

}  // namespace gcv
