// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Witnesses: open parallelograms that lie in the open sum int A + int B.
//
// 1. Let e be an edge of A and f an edge of B that are not parallel. The open parallelogram e + f
//    lies in the open sum: where e and x - f cross, the interiors of A and x - B meet.
// 2. Let P be a chain of A with the chord u, within r_a of it, and Q a chain of B with the chord v,
//    within r_b. A point x of the parallelogram u + v that is further than r_b from the lines of its
//    sides along v, and further than r_a from those along u, lies in the open sum. For the boundary
//    of the map (s, t) -> P(s) + Q(t) can be pulled straight to that of the parallelogram without
//    passing x. So it winds round x, and P crosses x - Q, also after a small move of B. If the
//    interiors were apart, B could be moved so that P and x - Q do not meet.
//
// Fact 1 is decided exactly where it has to be (sum/contacts.hpp). Here both are decided in doubles,
// with a bound for all roundings: what is called covered is covered.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "contributing_vertices.hpp"
#include "tree_product.hpp"

namespace gcv {

// A line in relative coordinates, as a superset edge has it. The parameters of its points are
// exact. The points that are computed are off by at most 6 u times the extents of both polygons.
struct RelativeLine {
  Point origin;
  double dx;
  double dy;

  [[nodiscard]] Point at(double t) const { return {origin.x + t * dx, origin.y + t * dy}; }
};

// A chain of a polygon: a node of its tree with its chord.
struct ChordNode {
  ChainTree::Node place;
  Box box;
  Point from;
  Point to;
  double radius;
  double length;  // of the chord
};

// The part of the sum of two chords where the chains cover everything.
class Witness {
 public:
  Witness(const ChordNode& p, const ChordNode& q, double slack);

  // Does the open sum hold the point? A point that is off by as much as RelativeLine::at says
  // counts as the exact one.
  [[nodiscard]] bool holds(const Point& x) const {
    const double wx = x.x - corner_.x;
    const double wy = x.y - corner_.y;
    const double along_u = wx * v_.y - wy * v_.x;
    const double along_v = u_.x * wy - u_.y * wx;
    return along_u > least_u_ && along_u < most_u_ && along_v > least_v_ && along_v < most_v_;
  }

  // How far the open sum holds the line from t on, which it holds: a parameter up to 1. That itself
  // is held. At least t.
  [[nodiscard]] double reach(const RelativeLine& line, double t) const;

 private:
  Point corner_;
  Point u_;  // the cross product u x v is positive
  Point v_;
  double least_u_;  // of w x v, where w leads from the corner to a point
  double most_u_;
  double least_v_;  // of u x w
  double most_v_;
};

// Searches both polygons' trees for witnesses, and for the pairs of edges near a place.
class WitnessSearch {
 public:
  explicit WitnessSearch(const Operands& operands);

  // How far from t on the line lies in the open sum: a parameter up to 1, itself in the open sum.
  // t itself if no witness holds it, or none much more: then the pairs of edges are in pairs().
  double reach(const RelativeLine& line, double t);

  struct Pair {
    Index i;
    Index j;
  };
  // What the last search has found.
  [[nodiscard]] const std::vector<Pair>& pairs() const { return pairs_; }

  // Finds all pairs of edges, one of each polygon, whose sums may hold the point. It is off by at
  // most the distance.
  void find_pairs(const Point& x, double distance);
  // The same for the points of a box.
  void find_pairs(const Box& box);

  [[nodiscard]] double slack() const { return slack_; }

 private:
  struct Nodes {
    ChordNode a;
    ChordNode b;
  };
  [[nodiscard]] static ChordNode root(const Boundary& polygon);
  // The children of the larger node, beside the other one.
  struct Family {
    const ChainTree& tree;
    const ChainTree::Block& boxes;
    const ChordBlock& chords;
    const ChordNode& parent;
    const ChordNode& other;
    bool is_of_a;

    [[nodiscard]] Nodes nodes(std::uint32_t lane) const;
  };
  [[nodiscard]] Family family(const Nodes& nodes) const;
  // The lanes whose sums with the other node may hold a point, and those that cover it.
  struct Lanes {
    unsigned near;
    unsigned covering;
  };
  [[nodiscard]] Lanes lanes_at(const Family& family, const Point& x, double distance) const;
  void add_children(const Family& children, unsigned lanes);
  template <class NearLanes>
  void find_pairs_by(NearLanes near_lanes);
  [[nodiscard]] bool are_edges(const Nodes& nodes) const {
    return trees_[0]->is_edge(nodes.a.place) && trees_[1]->is_edge(nodes.b.place);
  }

  // Witnesses that were found, by the cell of a grid over the sum in which they were used.
  struct Cell {
    static constexpr std::uint32_t capacity = 4;
    std::optional<Witness> witnesses[capacity];
    std::uint32_t next = 0;  // which is replaced next
  };
  [[nodiscard]] Cell& cell_of(const Point& x);
  // How far a remembered witness of the cell reaches from t; t if none reaches `least`.
  double remembered_reach(const Cell& cell, const RelativeLine& line, double t, double least);
  double searched_reach(Cell& cell, const RelativeLine& line, double t, double least);

  const Operands& operands_;
  const ChainTree* trees_[2];
  const std::vector<ChordBlock>* chords_[2];
  double slack_;
  Nodes roots_;
  std::vector<Nodes> queue_;
  std::vector<Pair> pairs_;
  std::optional<Witness> last_;
  Box bounds_;
  double cells_a_unit_x_;
  double cells_a_unit_y_;
  std::uint32_t side_;  // the grid has side x side cells
  std::vector<Cell> cells_;
};

}  // namespace gcv
