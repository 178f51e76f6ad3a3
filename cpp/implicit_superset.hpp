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
    Search<Reaches, Nearness, Visit> search{
        operands_,      sectors_a_.data(), sectors_b_.data(), range,
        sectors(range), reaches,           nearness,          visit};
    search.descend(0, 0);
  }

 private:
  struct NodeSectors {
    Sectors edges;  // the directions of the edges below the node
    Sectors cones;  // the directions that its convex vertices contribute to
  };

  template <class Reaches, class Nearness, class Visit>
  struct Search {
    const Operands& operands;
    const NodeSectors* sectors_a;
    const NodeSectors* sectors_b;
    const RankRange& range;
    Sectors wanted;
    Reaches& reaches;
    Nearness& nearness;
    Visit& visit;

    [[nodiscard]] bool matters(Index ka, Index kb) const {
      const NodeSectors& sa = sectors_a[ka];
      const NodeSectors& sb = sectors_b[kb];
      return (((sa.edges & sb.cones) | (sa.cones & sb.edges)) & wanted) != 0 &&
             reaches(operands.a.tree.nodes[ka].box, operands.b.tree.nodes[kb].box);
    }

    static double extent(const Box& box) { return (box.x1 - box.x0) + (box.y1 - box.y0); }

    void descend(Index ka, Index kb) {
      if (!matters(ka, kb)) {
        return;
      }
      const ChainTree::Node& na = operands.a.tree.nodes[ka];
      const ChainTree::Node& nb = operands.b.tree.nodes[kb];
      if (na.right == 0 && nb.right == 0) {
        visit_pair(na.first, nb.first);
      } else if (nb.right == 0 || (na.right != 0 && extent(na.box) >= extent(nb.box))) {
        const bool right_first = nearness(operands.a.tree.nodes[na.right].box, nb.box) <
                                 nearness(operands.a.tree.nodes[ka + 1].box, nb.box);
        descend(right_first ? na.right : ka + 1, kb);
        descend(right_first ? ka + 1 : na.right, kb);
      } else {
        const bool right_first = nearness(na.box, operands.b.tree.nodes[nb.right].box) <
                                 nearness(na.box, operands.b.tree.nodes[kb + 1].box);
        descend(ka, right_first ? nb.right : kb + 1);
        descend(ka, right_first ? kb + 1 : nb.right);
      }
    }

    [[nodiscard]] bool in_range(Rank rank) const {
      const Directions& directions = operands.directions;
      return directions.angle(range.first, rank) <= directions.angle(range.first, range.last);
    }

    void visit_pair(Index i, Index j) {
      const Directions& directions = operands.directions;
      if (in_range(directions.rank_a[i]) && operands.b_contributes(j, directions.rank_a[i])) {
        visit(PairEdge{PairEdge::translated, i, j});
      }
      if (in_range(directions.rank_b[j]) && operands.a_contributes(i, directions.rank_b[j])) {
        visit(PairEdge{PairEdge::corner, i, j});
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
