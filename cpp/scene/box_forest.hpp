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
