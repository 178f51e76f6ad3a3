// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The superset edges that witnesses do not cover, from the nearest to a point on, or from the
// furthest in a direction on.
#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

#include "edges_below.hpp"
#include "witness_search.hpp"

namespace gcv {

// What is sought: the places nearest to a point, in relative coordinates, or those furthest in a
// direction.
struct Goal {
  enum class Kind : std::uint8_t { point, direction };
  Kind kind;
  Point vector;

  static Goal near(const Point& point) { return {Kind::point, point}; }
  static Goal far(const Point& direction) { return {Kind::direction, direction}; }
  [[nodiscard]] bool is_point() const { return kind == Kind::point; }
};

class NearestEdges {
 public:
  // The first search takes O(n + m) more.
  NearestEdges(const Operands& operands, WitnessSearch& search);

  // How far a place is from the goal: its distance from the point, or how much less far it is than
  // anything of the sum. Rounded: within four times the slack of the search.
  void set_goal(const Goal& goal);
  // Leaves out what is nearer to a goal that is a direction, as far as that is certain. Until the
  // next goal.
  void leave_out_before(double distance);
  [[nodiscard]] double distance(const Point& p) const;

  // Calls visit(edge) for superset edges in focus, before merging, whose distance from the goal may
  // be at most `reach`, which may fall on the way: as far as no witnesses cover them, by that
  // distance, the nearest one first. Leaves out those that is_wanted(edge) does not want, which is
  // asked before an edge is looked at. Calls pass() after each step, and ends if it gives false.
  template <class IsWanted, class Visit, class Pass>
  void for_each(const double& reach, IsWanted is_wanted, Visit visit, Pass pass) {
    find_edges_below();
    heap_.clear();
    push({0, Entry::nodes, ChordTree::root, ChordTree::root});
    while (!heap_.empty()) {
      std::pop_heap(heap_.begin(), heap_.end(), is_further);
      const Entry entry = heap_.back();
      heap_.pop_back();
      const double limit = limit_of_costs(reach);
      if (entry.cost > limit) {
        return;
      }
      if (entry.is_nodes()) {
        look_below(entry.a, entry.b, limit);
      } else if (!entry.is_looked_at) {
        if (is_wanted(operands_.named(entry.edge()))) {
          look_at(entry, limit);
        }
      } else {
        visit(operands_.named(entry.edge()));
      }
      if (!pass()) {
        return;
      }
    }
  }

 private:
  // Two nodes, or an edge.
  struct Entry {
    static constexpr std::uint32_t nodes = 0;
    double cost;         // of what witnesses leave of an edge, if that was looked at
    std::uint32_t kind;  // of the edge, if it is one
    std::uint32_t a;
    std::uint32_t b;
    bool is_looked_at = false;

    [[nodiscard]] bool is_nodes() const { return kind == nodes; }
    [[nodiscard]] auto order_at_cost() const { return std::tuple(!is_looked_at, kind, a, b); }
    [[nodiscard]] EdgeName edge() const { return {static_cast<EdgeName::Kind>(kind), a, b}; }
  };
  // Of two at one distance, that which was looked at comes first. A total order, so that every
  // standard library has the same.
  static bool is_further(const Entry& p, const Entry& q) {
    if (p.cost != q.cost) {
      return p.cost > q.cost;
    }
    return p.order_at_cost() > q.order_at_cost();
  }

  void find_edges_below();
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
    double cost;
  };
  [[nodiscard]] Nearest nearest_on(const PairEdge& edge) const;
  // The cost of what witnesses leave of the line from the parameter on, infinite if that is nothing
  // within the limit.
  double cost_of_uncovered(const RelativeLine& line, double from, double limit);

  // The cost of a place is the square of its scaled distance from a point, or its distance itself.
  [[nodiscard]] double cost(const Point& p) const {
    if (!goal_.is_point()) {
      return furthest_ - (goal_.vector.x * p.x + goal_.vector.y * p.y);
    }
    const double x = scale_ * (p.x - goal_.vector.x);
    const double y = scale_ * (p.y - goal_.vector.y);
    return x * x + y * y;
  }
  // That of the nearest place in a box.
  [[nodiscard]] double cost(const Box& box) const;
  // Is all of a box left out?
  [[nodiscard]] bool is_left_out(const Box& box) const {
    const auto& [x, y] = goal_.vector;
    return cost(Point{x < 0 ? box.x1 : box.x0, y < 0 ? box.y1 : box.y0}) < least_;
  }
  // What the cost of places no further than that may be in doubles.
  [[nodiscard]] double limit_of_costs(double reach) const;

  const Operands& operands_;
  WitnessSearch& search_;
  const ChordTree& a_;
  const ChordTree& b_;
  std::vector<EdgesBelow> below_a_;
  std::vector<EdgesBelow> below_b_;
  double scale_;                    // of distances, so that their squares are in range
  Goal goal_ = Goal::near({0, 0});  // a direction is a unit vector
  double furthest_ = 0;             // that anything is, in a direction
  double least_ = -infinity;        // what costs less is left out
  std::vector<Entry> heap_;
};

}  // namespace gcv
