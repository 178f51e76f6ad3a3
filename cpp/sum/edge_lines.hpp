// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "contributing_vertices.hpp"
#include "key_numbers.hpp"
#include "predicates.hpp"
#include "tally.hpp"
#include "vector.hpp"

namespace gcv {

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
    lines_.clear();
  }

  // Null if it is not there.
  Value* find(const PairEdge& s) {
    const std::int64_t place = place_of(s);
    for (const std::int64_t near : {place, place - 1, place + 1}) {
      const std::uint32_t number = keys_.find(key(s, near));
      for (std::uint32_t k = number == none ? none : first_[number]; k != none;
           k = lines_[k].next) {
        if (holds(lines_[k], s)) {
          return &lines_[k].value;
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
    const auto [number, is_new] = keys_.add(key(s, place_of(s)));
    if (is_new) {
      first_.push_back(none);
    }
    lines_.push_back({s, first_[number], {}});
    first_[number] = static_cast<std::uint32_t>(lines_.size() - 1);
    return lines_.back().value;
  }

 private:
  struct Line {
    PairEdge edge;       // that lies on it
    std::uint32_t next;  // of the same key
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
  bool holds(const Line& line, const PairEdge& s) {
    const EdgeName& name = line.edge;
    return name == s ||
           (line.edge.rank == s.rank && side(coordinates(operands_.a, operands_.b, line.edge),
                                             operands_.start(s), tally_) == 0);
  }

  const Operands& operands_;
  double unit_;
  Tally& tally_;
  std::vector<Line> lines_;
  Keys keys_{{}, {}};
  std::vector<std::uint32_t> first_;  // line of each key
};

}  // namespace gcv
