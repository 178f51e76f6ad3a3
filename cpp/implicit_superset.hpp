// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The superset without building it. A pair of nodes, one of each polygon's chain tree,
// stands for all superset edges made from an edge below one and a vertex below the
// other. It is dropped when the edge directions of one node and the cones of the other
// have no sector in common, both ways, or when the sum of its boxes misses the place
// that is searched.
#pragma once

#include <cstdint>
#include <vector>

#include "contributing_vertices.hpp"

namespace gcv {

// A set of directions, as up to 64 sectors of consecutive ranks: one rank each where
// there are no more.
using Sectors = std::uint64_t;

// A closed range of ranks, counter-clockwise from first to last; never a full turn.
struct RankRange {
  Rank first;
  Rank last;
};

class ImplicitSuperset {
 public:
  explicit ImplicitSuperset(const Operands& operands);

  [[nodiscard]] const Operands& operands() const { return operands_; }

  // Visits superset edges (translated and corner edges, not merged) with ranks in
  // `range`: all of those for which `reaches` holds of every box that they lie in, and
  // maybe others.
  //   reaches(const Box& a, const Box& b): can an edge in the sum of the boxes matter?
  //   nearness(const Box& a, const Box& b): smaller comes first.
  //   visit(const PairEdge&): one superset edge.
  // The answers of `reaches` may become stricter during the visit.
  template <class Reaches, class Nearness, class Visit>
  void search(const RankRange& range, Reaches reaches, Nearness nearness, Visit visit) const {
    Search<Reaches, Nearness, Visit> search{*this, range, sectors(range), reaches, nearness, visit};
    search.descend(operands_.a.tree.root(), operands_.b.tree.root());
  }

 private:
  struct NodeSectors {
    Sectors edges;  // the directions of the edges below the node
    Sectors cones;  // the directions that its convex vertices contribute to
  };

  template <class Reaches, class Nearness, class Visit>
  struct Search {
    const ImplicitSuperset& superset;
    const RankRange& range;
    Sectors wanted;
    Reaches& reaches;
    Nearness& nearness;
    Visit& visit;

    [[nodiscard]] const Operands& operands() const { return superset.operands_; }
    [[nodiscard]] const Box& box_a(ChainTree::Node node) const {
      return operands().a.tree.boxes[operands().a.tree.index(node)];
    }
    [[nodiscard]] const Box& box_b(ChainTree::Node node) const {
      return operands().b.tree.boxes[operands().b.tree.index(node)];
    }
    [[nodiscard]] bool in_range(Rank rank) const {
      const Directions& directions = operands().directions;
      return directions.angle(range.first, rank) <= directions.angle(range.first, range.last);
    }

    void descend(ChainTree::Node na, ChainTree::Node nb) {
      const NodeSectors& sa = superset.sectors_a_[operands().a.tree.index(na)];
      const NodeSectors& sb = superset.sectors_b_[operands().b.tree.index(nb)];
      if ((((sa.edges & sb.cones) | (sa.cones & sb.edges)) & wanted) == 0 ||
          !reaches(box_a(na), box_b(nb))) {
        return;
      }
      if (na.level == 0 && nb.level == 0) {
        visit_leaves(na, nb);
      } else if (nb.level == 0 || (na.level != 0 && extent(box_a(na)) >= extent(box_b(nb)))) {
        const ChainTree::Node left{na.level - 1, 2 * na.k};
        if (!operands().a.tree.has_right_child(na)) {
          descend(left, nb);
          return;
        }
        const ChainTree::Node right{na.level - 1, 2 * na.k + 1};
        const bool right_first =
            nearness(box_a(right), box_b(nb)) < nearness(box_a(left), box_b(nb));
        descend(right_first ? right : left, nb);
        descend(right_first ? left : right, nb);
      } else {
        const ChainTree::Node left{nb.level - 1, 2 * nb.k};
        if (!operands().b.tree.has_right_child(nb)) {
          descend(na, left);
          return;
        }
        const ChainTree::Node right{nb.level - 1, 2 * nb.k + 1};
        const bool right_first =
            nearness(box_a(na), box_b(right)) < nearness(box_a(na), box_b(left));
        descend(na, right_first ? right : left);
        descend(na, right_first ? left : right);
      }
    }

    static double extent(const Box& box) { return (box.x1 - box.x0) + (box.y1 - box.y0); }

    void visit_leaves(ChainTree::Node na, ChainTree::Node nb) {
      const ChainTree& ta = operands().a.tree;
      const ChainTree& tb = operands().b.tree;
      const Directions& directions = operands().directions;
      for (Index i = ChainTree::first_edge(na.k); i < ta.last_edge(na.k); ++i) {
        for (Index j = ChainTree::first_edge(nb.k); j < tb.last_edge(nb.k); ++j) {
          if (in_range(directions.rank_a[i]) && operands().b_contributes(j, directions.rank_a[i])) {
            visit(PairEdge{PairEdge::translated, i, j});
          }
          if (in_range(directions.rank_b[j]) && operands().a_contributes(i, directions.rank_b[j])) {
            visit(PairEdge{PairEdge::corner, i, j});
          }
        }
      }
    }
  };

  [[nodiscard]] Sectors sectors(const RankRange& range) const;
  [[nodiscard]] std::vector<NodeSectors> node_sectors(const Polygon& polygon,
                                                      const std::vector<Rank>& ranks) const;

  const Operands& operands_;
  std::vector<NodeSectors> sectors_a_;
  std::vector<NodeSectors> sectors_b_;
};

}  // namespace gcv
