// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Descends the trees of two placed polygons at once, from pairs of nodes to pairs of edges.
#pragma once

#include "chain_index.hpp"
#include "polygon_pair.hpp"

namespace gcv {

inline Box moved(const Box& box, const Point& offset) {
  return {box.x0 + offset.x, box.y0 + offset.y, box.x1 + offset.x, box.y1 + offset.y};
}

// Visits these children, the one of the smallest key first, as long as keys are not above the
// limit, which may fall on the way. Ends when a visit returns true. Returns what the last one
// returned.
template <class Visit>
bool any_in_order(unsigned lanes, const double* keys, const double& limit, Visit visit) {
  std::uint32_t order[ChainTree::width];
  std::uint32_t count = 0;
  const unsigned above = (SimdDouble::load(keys) > limit).bits();
  for_each_lane(lanes & ~above, [&](std::uint32_t lane) {
    std::uint32_t place = count++;
    for (; place > 0 && keys[order[place - 1]] > keys[lane]; --place) {
      order[place] = order[place - 1];
    }
    order[place] = lane;
  });
  for (std::uint32_t k = 0; k < count && !(keys[order[k]] > limit); ++k) {
    if (visit(order[k])) {
      return true;
    }
  }
  return false;
}

// A search says where to go:
//   any_child(block, box, is_of_a, visit): calls visit(lane) for children of a node that it wants,
//     beside a node of the other polygon with that box, seen from the first vertex of the polygon
//     of the block. Returns true as soon as a visit does.
//   meet(i, j): a pair of edges. Ends the search by returning true.
// In place of meet() it may have this, for an edge and all edges of a block of the other tree:
//   meet_edges(block, box, edges): the block and the box of the edge as above.

// And it may have this, which takes longer than boxes, and so is asked only after many visits:
//   are_beyond_reach(a, b): is all below two nodes too far apart to matter?

// All edges of a block of A or B, and an edge of the other one.
template <bool is_of_a>
struct EdgesOfBlock {
  const ChainIndex& index;  // that the block is of
  Index number;             // of the block among those of edges
  Index other;              // the edge

  // The pair in a lane.
  [[nodiscard]] Index i(std::uint32_t lane) const { return is_of_a ? in_block(lane) : other; }
  [[nodiscard]] Index j(std::uint32_t lane) const { return is_of_a ? other : in_block(lane); }

 private:
  [[nodiscard]] Index in_block(std::uint32_t lane) const {
    return index.edge(ChainTree::width * number + lane);
  }
};

template <class Search>
concept MeetsBlocks = requires(Search search, const ChainTree::Block& block, const Box& box,
                               const EdgesOfBlock<true>& edges) {
  search.meet_edges(block, box, edges);
};

template <class Search>
concept TellsReach = requires(const Search search, const ChainTree::Node& node) {
  search.are_beyond_reach(node, node);
};

template <class Search>
class PairDescent {
 public:
  // Of the trees of a pair with that offset. By spreads: after many visits, nodes are compared by
  // them, as sums beside a small polygon do (tree_product.hpp).
  PairDescent(const ChainIndex& a, const ChainIndex& b, const Point& offset, bool by_spreads,
              Search& search)
      : a_(a), b_(b), offset_(offset), by_spreads_(by_spreads), search_(search) {}

  // Did the search end?
  bool run() {
    const Box& a = a_.tree.box;
    const Box& b = b_.tree.box;
    return descend({{0, 0}, a}, {{0, 0}, moved(b, offset_)});
  }

 private:
  // Most pairs of polygons take fewer, but for those with many long edges side by side in no
  // direction of the axes: of these, boxes leave out little.
  static constexpr std::uint64_t visits_by_boxes = 512;

  // Where one of so many is beyond reach, at least, in a trial that begins each time that the
  // visits have doubled: what is near a distance is told once a short one is found.
  static constexpr std::uint64_t one_of = 8;
  static constexpr std::uint64_t trials = 256;
  bool is_reach_asked() {
    if (visits_ >= 2 * trial_begin_) {
      trial_begin_ = visits_;
      asked_ = beyond_reach_ = 0;
    }
    const bool is_asked = asked_ < trials || beyond_reach_ * one_of >= asked_;
    asked_ += is_asked ? 1 : 0;
    return is_asked;
  }

  // With its box, seen from the first vertex of A.
  struct Node {
    ChainTree::Node place;
    Box box;
  };

  // The larger node is left for its children.
  [[nodiscard]] bool is_larger(const Node& a, const Node& b) const {
    return by_spreads_ && visits_ > visits_by_boxes ? a_.spread(a.place) >= b_.spread(b.place)
                                                    : extents_of(a.box) >= extents_of(b.box);
  }
  bool descend(const Node& a, const Node& b) {
    if constexpr (TellsReach<Search>) {
      if (++visits_ > visits_by_boxes && is_reach_asked() &&
          search_.are_beyond_reach(a.place, b.place)) {
        ++beyond_reach_;
        return false;
      }
    }
    const bool a_is_edge = a_.tree.is_edge(a.place);
    const bool b_is_edge = b_.tree.is_edge(b.place);
    if constexpr (!MeetsBlocks<Search>) {
      if (a_is_edge && b_is_edge) {
        return search_.meet(a_.edge(a.place.index), b_.edge(b.place.index));
      }
    }
    if (b_is_edge || (!a_is_edge && is_larger(a, b))) {
      const Index number = a_.tree.block_below(a.place);
      const ChainTree::Block& block = a_.tree.blocks[number];
      if constexpr (MeetsBlocks<Search>) {
        if (b_is_edge && a_.tree.is_edge(ChainTree::child(a.place, 0))) {
          return search_.meet_edges(block, b.box,
                                    EdgesOfBlock<true>{a_, a.place.index, b_.edge(b.place.index)});
        }
      }
      return search_.any_child(block, b.box, true, [&](std::uint32_t lane) {
        return descend({ChainTree::child(a.place, lane), block.box(lane)}, b);
      });
    }
    const Index number = b_.tree.block_below(b.place);
    const ChainTree::Block& block = b_.tree.blocks[number];
    const Box box = moved(a.box, {-offset_.x, -offset_.y});
    if constexpr (MeetsBlocks<Search>) {
      if (a_is_edge && b_.tree.is_edge(ChainTree::child(b.place, 0))) {
        return search_.meet_edges(block, box,
                                  EdgesOfBlock<false>{b_, b.place.index, a_.edge(a.place.index)});
      }
    }
    return search_.any_child(block, box, false, [&](std::uint32_t lane) {
      return descend(a, {ChainTree::child(b.place, lane), moved(block.box(lane), offset_)});
    });
  }

  const ChainIndex& a_;
  const ChainIndex& b_;
  const Point offset_;
  const bool by_spreads_;
  Search& search_;
  std::uint64_t visits_ = 0;  // of pairs of nodes
  std::uint64_t trial_begin_ = visits_by_boxes;
  std::uint64_t asked_ = 0;         // of these, in this trial
  std::uint64_t beyond_reach_ = 0;  // of these
};

}  // namespace gcv
