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
  // the nearest one first. Leaves out those that is_known(edge) knows, which is asked before an
  // edge is looked at. Calls pass() after each step. The point is in relative coordinates.
  template <class IsKnown, class Visit, class Pass>
  void for_each(const Point& from, const double& reach, IsKnown is_known, Visit visit, Pass pass) {
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
      if (entry.is_nodes()) {
        look_below(entry.a, entry.b, limit);
      } else if (!entry.is_looked_at) {
        if (!is_known(operands_.named(entry.edge()))) {
          look_at(entry, limit);
        }
      } else {
        visit(operands_.named(entry.edge()));
      }
      pass();
    }
  }

 private:
  // Two nodes, or an edge.
  struct Entry {
    static constexpr std::uint32_t nodes = 0;
    double square;       // of the distance; of what witnesses leave of an edge that was looked at
    std::uint32_t kind;  // of the edge, if it is one
    std::uint32_t a;
    std::uint32_t b;
    bool is_looked_at = false;

    [[nodiscard]] bool is_nodes() const { return kind == nodes; }
    [[nodiscard]] EdgeName edge() const { return {static_cast<EdgeName::Kind>(kind), a, b}; }
  };
  // Of two at one distance, that which was looked at comes first.
  static bool is_further(const Entry& p, const Entry& q) {
    return p.square > q.square || (p.square == q.square && p.is_looked_at < q.is_looked_at);
  }

  void push(const Entry& entry);
  // Puts the children of the larger node, beside the other one, into the heap; of two edges their
  // superset edges.
  void look_below(ChordTree::Node a, ChordTree::Node b, double limit);
  void add_edge(const PairEdge& edge, double limit);
  // Puts an edge back, by what witnesses leave of it within the limit.
  void look_at(const Entry& entry, double limit);

  // An edge, and the parameter of its point that is nearest.
  struct Nearest {
    RelativeLine line;
    double parameter;
    double square;  // of its distance
  };
  [[nodiscard]] Nearest nearest_on(const PairEdge& edge) const;
  // The square of the distance of what witnesses leave of the line from the parameter on, infinite
  // if that is nothing within the limit.
  double square_of_uncovered(const RelativeLine& line, double from, double limit);

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
