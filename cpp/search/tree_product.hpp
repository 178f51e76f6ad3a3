// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The superset without building it. A pair of nodes, one of each polygon's chain tree,
// stands for all superset edges made from an edge below one and a vertex below the
// other. It is dropped when the edge directions of one node and the cones of the other
// have no sector in common, both ways, or when the sum of its boxes misses the place
// that is searched.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "box.hpp"
#include "contributing_vertices.hpp"
#include "equal_chains.hpp"
#include "sectors.hpp"
#include "vector.hpp"

namespace gcv {

// What searches allow for roundings of relative coordinates: 2^-47 times the extents of both
// polygons.
inline double slack_of(const Operands& operands) {
  const Box& a = operands.a.bounds;
  const Box& b = operands.b.bounds;
  const double extents = ((a.x1 - a.x0) + (a.y1 - a.y0)) + ((b.x1 - b.x0) + (b.y1 - b.y0));
  return 0x1p-47 * extents + std::numeric_limits<double>::min();
}

// How far the computed offset of a point of the sum from a line with direction (dx, dy), in
// relative coordinates, can be from the exact one: infinite where an offset can overflow.
inline double offset_tolerance(double dx, double dy, double slack) {
  const double size = std::abs(dx) + std::abs(dy);
  const double largest = size * (slack * 0x1p48);
  return largest <= std::numeric_limits<double>::max()
             ? size * slack + std::numeric_limits<double>::min()
             : infinity;
}

class TreeProduct {
 public:
  // Searches can pass over what they have met where the repeated chains are given.
  explicit TreeProduct(const Operands& operands, EqualChains chains = {});

  [[nodiscard]] const Operands& operands() const { return operands_; }
  [[nodiscard]] double mean_edge_size() const { return mean_edge_size_; }
  [[nodiscard]] bool has_equal_chains() const { return !a_.chains.empty(); }

  struct NodeSectors {
    Sectors edges;  // the directions of the edges below the node
    Sectors cones;  // the directions that its convex vertices contribute to
  };

  // The direction of an edge, in which a search looks at the polygons: the offset of a point p
  // is direction x p.
  struct Offsets {
    double lowest;
    double highest;
  };

  struct Node {
    ChainTree::Node place;
    NodeSectors sectors;
    Box box;
    Offsets offsets;  // of the points below the node
    Point from;       // the ends of its sphere
    Point to;
    double radius;
    double size;          // by which nodes are compared: its extents, or its spread
    std::uint32_t chain;  // its number where chains are repeated; 0 for the root
  };

  // The children of a node.
  struct Block {
    const ChainTree::Block& boxes;
    const SweptSphereBlock& spheres;
    std::uint32_t number;  // in its tree
    bool is_of_a;
  };

  // What a place says of a block.
  struct Survivors {
    unsigned lanes;                   // those that can matter, as bits
    double lowest[ChainTree::width];  // their offsets
    double highest[ChainTree::width];
  };

  // Goes down from the roots: the larger node is left for its children. A place says what to leave
  // out:
  //   offsets(box): those of a box;
  //   cull(block, other): at the block, the node of the other tree added to its nodes.
  // Calls visit(i, j) for pairs of edges that hold all superset edges in that place; given what the
  // search has met, which needs chains that are repeated, at least one of those that coincide.
  // Returns the number of node visits; above `most`, it has given up.
  template <class Place, class Visit>
  std::int64_t search(Place& place, Visit visit, VisitedPairs* met = nullptr,
                      std::int64_t most = std::numeric_limits<std::int64_t>::max()) const {
    if (met != nullptr) {
      met->clear();
    }
    Search<Place, Visit> search{*this, place, met, visit, most};
    search.descend(root(a_, place), root(b_, place));
    return most - search.visits_left;
  }

  // The offsets of a box in the direction (dx, dy).
  static Offsets offsets(const Box& box, double dx, double dy) {
    return {dx * (dx > 0 ? box.y0 : box.y1) - dy * (dy > 0 ? box.x1 : box.x0),
            dx * (dx > 0 ? box.y1 : box.y0) - dy * (dy > 0 ? box.x0 : box.x1)};
  }

  // Calls visit(edge) for the superset edges of edges i and j.
  template <class Visit>
  void for_each_edge(Index i, Index j, Visit visit) const {
    const PairEdge translated = operands_.translated(i, j);
    if (operands_.b_contributes(j, translated.rank)) {
      visit(translated);
    }
    const PairEdge corner = operands_.corner(i, j);
    if (operands_.a_contributes(i, corner.rank)) {
      visit(corner);
    }
  }

 private:
  // The sectors of the nodes of a block.
  struct SectorBlock {
    Sectors edges[ChainTree::width];
    Sectors cones[ChainTree::width];
  };

  // A polygon's tree with the sectors of its nodes.
  struct Tree {
    const ChainIndex& index;
    const ChainIndex::Spreads* spreads;  // nullptr if nodes are compared by extents
    std::vector<SectorBlock> sectors;
    EqualChains::Numbers chains;
  };

  template <class Place, class Visit>
  struct Search {
    const TreeProduct& superset;
    Place& place;
    VisitedPairs* met;
    Visit& visit;
    std::int64_t visits_left;

    [[nodiscard]] bool meets_again(const Node& a, const Node& b) {
      return met->meet(a.chain, b.chain,
                       superset.operands_.point({superset.a_.index.tree.first_edge(a.place),
                                                 superset.b_.index.tree.first_edge(b.place)}));
    }

    void descend(const Node& a, const Node& b) {
      if (met != nullptr && meets_again(a, b)) {
        return;
      }
      const bool a_is_edge = superset.a_.index.tree.is_edge(a.place);
      const bool b_is_edge = superset.b_.index.tree.is_edge(b.place);
      if (a_is_edge && b_is_edge) {
        visit(superset.a_.index.edge(a.place.index), superset.b_.index.edge(b.place.index));
        return;
      }
      if (--visits_left < 0) {
        return;
      }
      const bool expand_a = b_is_edge || (!a_is_edge && a.size >= b.size);
      const Tree& tree = expand_a ? superset.a_ : superset.b_;
      const Node& node = expand_a ? a : b;
      const Node& other = expand_a ? b : a;
      const std::uint32_t number = tree.index.tree.block_below(node.place);
      const Block block{tree.index.tree.blocks[number], tree.index.spheres[number], number,
                        expand_a};
      const SectorBlock& sectors = tree.sectors[number];
      Survivors survivors;
      place.cull(block, other, survivors);
      for (unsigned k = 0; k < ChainTree::width; ++k) {
        const bool common = ((sectors.edges[k] & other.sectors.cones) |
                             (sectors.cones[k] & other.sectors.edges)) != 0;
        survivors.lanes &= ~(static_cast<unsigned>(!common) << k);
      }
      for_each_lane(survivors.lanes, [&](std::uint32_t k) {
        const SweptSphereBlock& spheres = block.spheres;
        const Box box = block.boxes.box(k);
        const Node child{ChainTree::child(node.place, k),
                         {sectors.edges[k], sectors.cones[k]},
                         box,
                         {survivors.lowest[k], survivors.highest[k]},
                         {spheres.x0[k], spheres.y0[k]},
                         {spheres.x1[k], spheres.y1[k]},
                         spheres.radius[k],
                         tree.spreads != nullptr ? tree.spreads[number].of[k] : extents_of(box),
                         met != nullptr ? tree.chains[number][k] : 0};
        if (expand_a) {
          descend(child, b);
        } else {
          descend(a, child);
        }
      });
    }
  };

  TreeProduct(const Operands& operands, const ChainIndex& a, const ChainIndex& b,
              EqualChains chains);
  template <class Place>
  [[nodiscard]] static Node root(const Tree& tree, const Place& place) {
    const Box& box = tree.index.tree.box;
    const Point corner{box.x0, box.y0};
    return {{0, 0},
            {~Sectors{0}, ~Sectors{0}},
            box,
            place.offsets(box),
            corner,
            corner,
            length_bound(box.x1 - box.x0, box.y1 - box.y0),
            extents_of(box),
            0};
  }
  [[nodiscard]] std::vector<SectorBlock> node_sectors(const Boundary& polygon, const Ranks& ranks,
                                                      const ChainIndex& index) const;

  const Operands& operands_;
  Tree a_;
  Tree b_;
  double mean_edge_size_;  // of both polygons, of the larger coordinate
};

}  // namespace gcv
