// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The superset edges near a place that witnesses do not cover, from the nearest on.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "edges_below.hpp"
#include "witness_search.hpp"

namespace gcv {

class NearestEdges {
 public:
  // O(n + m).
  NearestEdges(const Operands& operands, WitnessSearch& search);

  // Calls visit(edge) for superset edges, before merging, whose distance from the point may be at
  // most `reach`, which may fall on the way: as far as no witnesses cover them, by that distance,
  // the nearest one first. Calls pass() after each step. The point is in relative coordinates.
  template <class Visit, class Pass>
  void for_each(const Point& from, const double& reach, Visit visit, Pass pass) {
    from_ = from;
    heap_.clear();
    push({0, Entry::nodes, ChordTree::root, ChordTree::root});
    while (!heap_.empty()) {
      std::pop_heap(heap_.begin(), heap_.end(), is_further);
      const Entry entry = heap_.back();
      heap_.pop_back();
      const double limit = limit_of_squares(reach);
      if (entry.square > limit) {
        return;
      }
      if (entry.kind == Entry::nodes) {
        look_below(entry.a, entry.b, limit);
      } else {
        visit(operands_.named({static_cast<EdgeName::Kind>(entry.kind), entry.a, entry.b}));
      }
      pass();
    }
  }

 private:
  // Two nodes, or an edge. The square of the distance of what is not covered of it, in doubles.
  struct Entry {
    static constexpr std::uint32_t nodes = 0;
    double square;
    std::uint32_t kind;  // of the edge, if it is one
    std::uint32_t a;
    std::uint32_t b;
  };
  static bool is_further(const Entry& p, const Entry& q) { return p.square > q.square; }

  void push(const Entry& entry);
  // Puts the children of the larger node, beside the other one, into the heap; of two edges their
  // superset edges.
  void look_below(ChordTree::Node a, ChordTree::Node b, double limit);
  void add_edge(const PairEdge& edge, double limit);
  // Of what witnesses leave of the edge; infinite if they leave nothing within the limit.
  double square_of_uncovered(const PairEdge& edge, double limit);

  [[nodiscard]] double square_of_distance(const Point& p) const {
    const double x = scale_ * (p.x - from_.x);
    const double y = scale_ * (p.y - from_.y);
    return x * x + y * y;
  }
  [[nodiscard]] double square_of_distance(const Box& box) const;
  // What the square of a distance up to `reach` may be in doubles.
  [[nodiscard]] double limit_of_squares(double reach) const;

  const Operands& operands_;
  WitnessSearch& search_;
  const ChordTree& a_;
  const ChordTree& b_;
  std::vector<EdgesBelow> below_a_;
  std::vector<EdgesBelow> below_b_;
  double scale_;  // of distances, so that their squares are in range
  Point from_{0, 0};
  std::vector<Entry> heap_;
};

}  // namespace gcv
