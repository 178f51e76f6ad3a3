// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Boxes that change: a few packed trees, each less than half as large as the one before it.
//
// New boxes get a tree of their own, into which smaller ones and those of about its size are merged
// (Bentley and Saxe, Decomposable searching problems I: the logarithmic method). A box that moves a
// little stays where it is, and the boxes above it are fitted anew. One that moves far is taken out
// and added again. A tree that has lost half of its boxes, or whose nodes have grown to twice their
// extent, is built anew. All costs are O(log n) a change, on average, but for the sorting of new
// trees: O(log n) again.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "box.hpp"
#include "chain_tree.hpp"
#include "placed_box.hpp"
#include "simd.hpp"

namespace gcv {

class BoxForest {
 public:
  // A number that the user of the forest gives to a box.
  using Slot = std::uint32_t;
  static constexpr Slot no_slot = UINT32_MAX;

  // The box that a slot gets; empty_box takes it out.
  struct Change {
    Slot slot;
    Box box;
  };

  // Changes that are prepared: all memory that they need is there.
  struct Prepared;

  // Builds trees anew that have become bad. The boxes stay the same. If it throws, nothing changes.
  void tidy();
  // `changes` must be in the order of slots, each slot once, all of them below `slots`. Nothing
  // else may change before they are applied.
  [[nodiscard]] Prepared prepare(std::span<const Change> changes, Slot slots);
  void apply(Prepared& prepared) noexcept;
  // Slot k becomes slot to[k]. Slots without a box can have any.
  void renumber(std::span<const Slot> to, Slot slots) noexcept;

  // A search says where to go:
  //   any_child(block, visit): calls visit(lane) for children of a node that it wants. Returns true
  //     as soon as a visit does.
  //   meet(slot): a box. Ends the search by returning true.
  // Did the search end?
  template <class Search>
  bool search(Search& search) const {
    for (const Tree& tree : trees_) {
      if (tree.search({0, 0}, search)) {
        return true;
      }
    }
    return false;
  }

  // The pairs of boxes are looked for in parts, which may run side by side. A part has a node of a
  // tree, for pairs of which one box is below it and the other below it, too, or in a later node or
  // tree.
  struct Part {
    std::uint32_t tree;
    ChainTree::Node node;
  };
  [[nodiscard]] std::vector<Part> parts() const;
  // Calls visit(slot, slot) for the pairs of a part whose boxes are no further than a distance from
  // each other in x and y.
  template <class Visit>
  void visit_pairs(const Part& part, double distance, Visit visit) const;

  // The bytes that it has taken.
  [[nodiscard]] std::size_t bytes() const;

 private:
  // Where the box of a slot is: in a leaf of a tree.
  struct Place {
    std::uint32_t tree;
    std::uint32_t leaf;

    [[nodiscard]] bool is_somewhere() const { return tree != no_slot; }
  };
  static constexpr Place nowhere{no_slot, 0};

  struct Tree {
    ChainTree boxes;
    std::vector<Slot> slots;  // of the leaves, or no_slot
    std::uint32_t live = 0;   // leaves with a slot
    // The extents of the nodes above the leaves, added up: as they were built, and now.
    double built_extent = 0;
    double extent = 0;

    [[nodiscard]] std::uint32_t depths() const {
      return static_cast<std::uint32_t>(boxes.first_block.size());
    }
    [[nodiscard]] ChainTree::Block& block_of(std::uint32_t leaf) {
      return boxes.blocks[boxes.first_block.back() + leaf / ChainTree::width];
    }
    [[nodiscard]] Box box_of(std::uint32_t leaf) const {
      return boxes.blocks[boxes.first_block.back() + leaf / ChainTree::width].box(leaf %
                                                                                  ChainTree::width);
    }
    [[nodiscard]] Box box_of(const ChainTree::Node& node) const {
      if (node.depth == 0) {
        return boxes.box;
      }
      const std::uint32_t block = boxes.first_block[node.depth - 1] + node.index / ChainTree::width;
      return boxes.blocks[block].box(node.index % ChainTree::width);
    }
    [[nodiscard]] bool is_worn() const {
      return 2 * std::uint64_t{live} < slots.size() || extent > 2 * built_extent;
    }
    // Gives a leaf a box and fits those above it.
    void put(std::uint32_t leaf, const Box& box) noexcept;

    template <class Search>
    bool search(const ChainTree::Node& node, Search& search) const {
      if (boxes.is_edge(node)) {
        return slots[node.index] != no_slot && search.meet(slots[node.index]);
      }
      return search.any_child(boxes.blocks[boxes.block_below(node)], [&](std::uint32_t lane) {
        return this->search(ChainTree::child(node, lane), search);
      });
    }
  };

  template <class Visit>
  class PairVisitor;

  static Tree build(std::span<const Change> boxes);
  // Adds the boxes of a tree.
  static void add_boxes(const Tree& tree, std::vector<Change>& boxes);
  // Adds those of the last trees that are not changed.
  void add_unchanged(std::size_t first_tree, std::span<const Change> changes,
                     std::vector<Change>& boxes) const;
  // Can the box stay at its place?
  [[nodiscard]] bool is_near(const Place& place, const Box& box);
  // How many trees stay if a tree of so many boxes is added.
  [[nodiscard]] std::size_t trees_beside(std::uint64_t count) const;
  void note_places(std::uint32_t tree) noexcept;

  std::vector<Tree> trees_;
  std::vector<Place> places_;  // of each slot
};

// Goes down from pairs of nodes to pairs of boxes.
template <class Visit>
class BoxForest::PairVisitor {
 public:
  PairVisitor(double distance, Visit& visit) : distance_(distance), visit_(visit) {}

  // A node of a tree, and its box.
  struct Place {
    const Tree& tree;
    ChainTree::Node node;
    Box box;

    [[nodiscard]] bool is_leaf() const { return tree.boxes.is_edge(node); }
    [[nodiscard]] const ChainTree::Block& block() const {
      return tree.boxes.blocks[tree.boxes.block_below(node)];
    }
    [[nodiscard]] Place child(std::uint32_t lane) const {
      return {tree, ChainTree::child(node, lane), block().box(lane)};
    }
    [[nodiscard]] Slot slot() const { return tree.slots[node.index]; }
    [[nodiscard]] std::uint32_t levels() const { return tree.depths() - node.depth; }
  };

  // Pairs below one node.
  void within(const Place& place) {
    if (place.is_leaf()) {
      return;
    }
    const unsigned children = children_of(place.block());
    for_each_lane(children, [&](std::uint32_t lane) {
      const Place child = place.child(lane);
      within(child);
      const unsigned later = children & near(place, child.box) & ~((2U << lane) - 1);
      for_each_lane(later, [&](std::uint32_t other) { between(child, place.child(other)); });
    });
  }
  // Pairs of a box below each of two nodes, which are apart.
  void between(const Place& p, const Place& q) {
    if (p.is_leaf() && q.is_leaf()) {
      if (p.slot() != no_slot && q.slot() != no_slot) {
        visit_(p.slot(), q.slot());
      }
    } else if (p.levels() >= q.levels()) {
      for_each_lane(children_of(p.block()) & near(p, q.box),
                    [&](std::uint32_t lane) { between(p.child(lane), q); });
    } else {
      for_each_lane(children_of(q.block()) & near(q, p.box),
                    [&](std::uint32_t lane) { between(p, q.child(lane)); });
    }
  }
  // Pairs of a box below a node and one behind that node in its tree.
  void with_later(const Place& place, const Place& other) {
    const std::uint32_t shift = 2 * (place.node.depth - other.node.depth);
    const std::uint64_t end = (std::uint64_t{other.node.index} + 1) << shift;
    if (end <= std::uint64_t{place.node.index} + 1) {
      return;
    }
    if (shift == 0) {
      between(place, other);
      return;
    }
    for_each_lane(children_of(other.block()) & near(other, place.box),
                  [&](std::uint32_t lane) { with_later(place, other.child(lane)); });
  }

 private:
  // The children of a node that are near a box.
  [[nodiscard]] unsigned near(const Place& place, const Box& box) const {
    return place.block().overlapping(distance_ > 0 ? widened_outwards(box, distance_) : box);
  }

  const double distance_;
  Visit& visit_;
};

template <class Visit>
void BoxForest::visit_pairs(const Part& part, double distance, Visit visit) const {
  PairVisitor visitor(distance, visit);
  using Node = typename PairVisitor<Visit>::Place;
  const Tree& tree = trees_[part.tree];
  const Node root{tree, {0, 0}, tree.boxes.box};
  const Node node{tree, part.node, tree.box_of(part.node)};
  visitor.within(node);
  visitor.with_later(node, root);
  for (std::size_t k = part.tree + 1; k < trees_.size(); ++k) {
    visitor.between(node, {trees_[k], {0, 0}, trees_[k].boxes.box});
  }
}

struct BoxForest::Prepared {
  struct Fit {
    Place place;
    Change change;
  };
  std::vector<Fit> fits;      // boxes that stay where they are
  std::vector<Slot> cleared;  // slots whose leaves are given up
  std::size_t kept_trees = 0;
  Tree added;  // behind these, if it has leaves
  Slot slots = 0;
};

}  // namespace gcv
