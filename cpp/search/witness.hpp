// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Witnesses: open parallelograms that lie in the open sum int A + int B.
//
// 1. Let e be an edge of A and f an edge of B that are not parallel. The open parallelogram e + f
//    lies in the open sum: where e and x - f cross, the interiors of A and x - B meet.
// 2. Let P be a chain of A with the chord u, within r_a of it, and Q a chain of B with the chord v,
//    within r_b. A point x of the parallelogram u + v that is further than r_b from the lines of
//    its sides along v, and further than r_a from those along u, lies in the open sum. For the
//    boundary of the map (s, t) -> P(s) + Q(t) can be pulled straight to that of the parallelogram
//    without passing x. So it winds round x, and P crosses x - Q, also after a small move of B. If
//    the interiors were apart, B could be moved so that P and x - Q do not meet.
//
// Where rings touch in points of both polygons, the sum of two such points is no part of this. It
// may be free by itself (sum/cover.hpp).
//
// Fact 1 is decided exactly where it has to be (sum/contacts.hpp). Here both are decided in
// doubles, with a bound for all roundings: what is called covered is covered.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "chord_tree.hpp"
#include "contributing_vertices.hpp"

namespace gcv {

// A line in relative coordinates, as a superset edge has it. The parameters of its points are
// exact. The points that are computed are off by at most 6 u times the extents of both polygons.
struct RelativeLine {
  Point origin;
  double dx;
  double dy;

  [[nodiscard]] Point at(double t) const { return {origin.x + t * dx, origin.y + t * dy}; }
};

// A chain of a polygon by its chord.
struct Chord {
  Point from;
  Point to;
  double radius;
  double length;

  static Chord of(const ChordTree& tree, ChordTree::Node node) {
    const ChordTree::Block& block = tree.block_of(node);
    const std::uint32_t lane = ChordTree::lane_of(node);
    return {{block.x0[lane], block.y0[lane]},
            {block.x1[lane], block.y1[lane]},
            block.radius[lane],
            block.length[lane]};
  }
};

// The part of the sum of two chords where the chains cover everything.
class Witness {
 public:
  Witness(const Chord& p, const Chord& q, double slack);

  // Does the open sum hold the point? A point that is off by as much as RelativeLine::at says
  // counts as the exact one.
  [[nodiscard]] bool holds(const Point& x) const {
    const double wx = x.x - corner_.x;
    const double wy = x.y - corner_.y;
    const double along_u = wx * v_.y - wy * v_.x;
    const double along_v = u_.x * wy - u_.y * wx;
    return along_u > least_u_ && along_u < most_u_ && along_v > least_v_ && along_v < most_v_;
  }

  // Does it hold the sum of these two chains?
  [[nodiscard]] bool holds(const Chord& p, const Chord& q) const;

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
  double length_u_;
  double length_v_;
};

// Searches both polygons' trees for witnesses of a superset edge, and for the pairs of edges near a
// place on it. Goes along the edge, from its start. What is ahead waits until it is reached: the
// sums of pairs of nodes, and witnesses that were met early.
class WitnessSearch {
 public:
  explicit WitnessSearch(const Operands& operands);

  // Sets out along a line, from its start.
  void begin(const RelativeLine& line);

  // How far from t on the line lies in the open sum: a parameter up to 1, itself in the open sum.
  // t itself if no witness holds it, or none much more. t never goes back.
  double reach(double t);

  struct Pair {
    Index i;
    Index j;
  };
  // All pairs of edges, one of each polygon, whose sums may hold a point of the line with a
  // parameter from `from` to `to`. These never go back.
  const std::vector<Pair>& pairs_near(double from, double to);
  // The last of these.
  [[nodiscard]] const std::vector<Pair>& pairs() const { return pairs_; }

  // Calls visit(edge) for the superset edges, before merging, whose direction is in the half-plane
  // that begins with a rank: from that on counter-clockwise, without the opposite rank. Passes over
  // those that lie in witnesses that were found until then.
  template <class Visit>
  void for_each_uncovered_edge(Rank first, Visit visit);

  [[nodiscard]] double slack() const { return slack_; }

 private:
  struct Nodes {
    ChordTree::Node a;
    ChordTree::Node b;
  };
  static constexpr Nodes roots{ChordTree::root, ChordTree::root};

  // The parameters of a line from one to another.
  struct Range {
    double from;
    double to;
  };

  // The children of the larger node, beside the other one.
  struct Family {
    const ChordTree::Block& children;
    std::uint32_t number;  // of the block
    const ChordTree::Block& of_other;
    ChordTree::Node other;
    bool is_of_a;

    [[nodiscard]] Nodes nodes(std::uint32_t lane) const {
      const ChordTree::Node child = ChordTree::node(number, lane);
      return is_of_a ? Nodes{child, other} : Nodes{other, child};
    }
  };
  [[nodiscard]] Family family(const Nodes& nodes) const;

  // Where the line is near the sums of the children with the other node, and what these cover of
  // it.
  struct Ranges {
    double near_from[ChordTree::width];
    double near_to[ChordTree::width];
    double covered_from[ChordTree::width];
    double covered_to[ChordTree::width];
  };
  [[nodiscard]] Ranges ranges(const Family& family) const;

  // Nodes near a part of the line.
  struct Waiting {
    Range near;
    Nodes nodes;
    [[nodiscard]] double first() const { return near.from; }
  };
  // What a witness covers.
  struct Cover {
    Range covered;
    Nodes nodes;
    [[nodiscard]] double first() const { return covered.from; }
  };
  struct NearPair {
    Range near;
    Pair pair;
  };
  // Puts the children of nodes that come near the line from `from` on where they belong: in the
  // queue, if this is before `to`.
  void expand(const Nodes& nodes, double from, double to);
  // Moves the nodes that come near the line before that to the queue.
  void activate(double to);

  [[nodiscard]] bool are_edges(const Nodes& nodes) const {
    return a_.is_edge(nodes.a) && b_.is_edge(nodes.b);
  }
  [[nodiscard]] Witness witness(const Nodes& nodes) const {
    return {Chord::of(a_, nodes.a), Chord::of(b_, nodes.b), slack_};
  }

  // Witnesses that were found, by the cell of a grid over the sum in which they were used.
  struct Cell {
    static constexpr std::uint32_t capacity = 4;
    std::optional<Witness> witnesses[capacity];
    std::uint32_t next = 0;  // which is replaced next
  };
  [[nodiscard]] Cell& cell_of(const Point& x);
  // How far a remembered witness reaches from t; t if none reaches `least`.
  double remembered_reach(double t, double least);
  // The same for the witnesses that were met.
  double met_reach(double t, double least);
  // Does a remembered witness hold the sum of the nodes?
  [[nodiscard]] bool is_covered(const Nodes& nodes);

  // The directions of edges and cones below a node, as sets of up to 64 sectors of ranks.
  using Sectors = std::uint64_t;
  struct NodeSectors {
    Sectors edges = 0;
    Sectors cones = 0;
  };
  [[nodiscard]] Sectors sectors(Rank first, Rank last) const;
  // Of the nodes of a tree.
  [[nodiscard]] std::vector<NodeSectors> node_sectors(const ChordTree& tree,
                                                      const Boundary& polygon,
                                                      const Ranks& ranks) const;

  const Operands& operands_;
  const ChordTree& a_;
  const ChordTree& b_;
  double slack_;

  RelativeLine line_{};
  std::vector<Waiting> queue_;    // what is near the place on the line that was reached
  std::size_t next_ = 0;          // in the queue
  std::vector<Waiting> waiting_;  // a heap: the one that comes near first is in front
  std::vector<Cover> covers_;     // likewise
  std::vector<NearPair> near_pairs_;
  std::vector<Pair> pairs_;

  std::optional<Witness> last_;
  Box bounds_;
  double cells_a_unit_x_;
  double cells_a_unit_y_;
  std::uint32_t side_;  // the grid has side x side cells
  std::vector<Cell> cells_;
};

template <class Visit>
void WitnessSearch::for_each_uncovered_edge(Rank first, Visit visit) {
  const Directions& directions = operands_.directions;
  const Rank half = directions.half_turn;
  const Sectors wanted = sectors(first, (first + half - 1) % (2 * half));
  const std::vector<NodeSectors> sectors_a = node_sectors(a_, operands_.a, directions.rank_a);
  const std::vector<NodeSectors> sectors_b = node_sectors(b_, operands_.b, directions.rank_b);
  const auto visit_edge = [&](const PairEdge& edge, bool contributes) {
    if (contributes && directions.angle(first, edge.rank) < half) {
      visit(edge);
    }
  };
  std::vector<Nodes> stack{roots};
  while (!stack.empty()) {
    const Nodes nodes = stack.back();
    stack.pop_back();
    if (is_covered(nodes)) {
      continue;
    }
    if (are_edges(nodes)) {
      const Index i = a_.below(nodes.a);
      const Index j = b_.below(nodes.b);
      const PairEdge translated = operands_.translated(i, j);
      const PairEdge corner = operands_.corner(i, j);
      visit_edge(translated, operands_.b_contributes(j, translated.rank));
      visit_edge(corner, operands_.a_contributes(i, corner.rank));
      continue;
    }
    const Family children = family(nodes);
    for (std::uint32_t lane = ChordTree::width; lane-- > 0;) {
      const Nodes child = children.nodes(lane);
      const NodeSectors& a = sectors_a[child.a];
      const NodeSectors& b = sectors_b[child.b];
      if ((((a.edges & b.cones) | (a.cones & b.edges)) & wanted) != 0) {
        stack.push_back(child);
      }
    }
  }
}

}  // namespace gcv
