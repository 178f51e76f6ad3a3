// SPDX-License-Identifier: LGPL-3.0-or-later
#include "box_forest.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "curve_order.hpp"

namespace gcv {

namespace {

bool is_empty(const Box& box) { return box.x0 > box.x1; }
double extent_of(const Box& box) {
  return is_empty(box) ? 0 : (box.x1 - box.x0) + (box.y1 - box.y0);
}
bool are_equal(const Box& p, const Box& q) {
  return p.x0 == q.x0 && p.y0 == q.y0 && p.x1 == q.x1 && p.y1 == q.y1;
}

}  // namespace

void BoxForest::Tree::put(std::uint32_t leaf, const Box& box) noexcept {
  Box child = box;
  std::uint32_t index = leaf;
  for (std::uint32_t depth = depths(); depth-- > 0; index /= ChainTree::width) {
    ChainTree::Block& block = boxes.blocks[boxes.first_block[depth] + index / ChainTree::width];
    const Box before = hull_of(block);
    block.put(index % ChainTree::width, child);
    child = hull_of(block);
    if (depth + 1 == depths()) {
      extent += extent_of(child) - extent_of(before);
    }
    if (are_equal(before, child)) {
      return;
    }
  }
  boxes.box = child;
}

BoxForest::Tree BoxForest::build(std::span<const Change> boxes) {
  Tree tree;
  if (boxes.empty()) {
    return tree;
  }
  const auto count = static_cast<std::uint32_t>(boxes.size());
  const std::vector<std::uint32_t> order =
      order_on_curve(count, [&](std::uint32_t k) { return boxes[k].box; });
  tree.boxes = build_tree(count, [&](std::uint32_t leaf) { return boxes[order[leaf]].box; });
  tree.slots.resize(count);
  for (std::uint32_t leaf = 0; leaf < count; ++leaf) {
    tree.slots[leaf] = boxes[order[leaf]].slot;
  }
  tree.live = count;
  for (std::uint32_t leaf = 0; leaf < count; leaf += ChainTree::width) {
    tree.extent += extent_of(hull_of(tree.block_of(leaf)));
  }
  tree.built_extent = tree.extent;
  return tree;
}

void BoxForest::add_boxes(const Tree& tree, std::vector<Change>& boxes) {
  for (std::uint32_t leaf = 0; leaf < tree.slots.size(); ++leaf) {
    if (tree.slots[leaf] != no_slot) {
      boxes.push_back({tree.slots[leaf], tree.box_of(leaf)});
    }
  }
}

bool BoxForest::is_near(const Place& place, const Box& box) {
  return !are_apart(hull_of(trees_[place.tree].block_of(place.leaf)), box);
}

std::size_t BoxForest::trees_beside(std::uint64_t count) const {
  std::size_t kept = trees_.size();
  while (kept > 0 && trees_[kept - 1].live <= 2 * count) {
    count += trees_[--kept].live;
  }
  return kept;
}

void BoxForest::note_places(std::uint32_t tree) noexcept {
  const std::vector<Slot>& slots = trees_[tree].slots;
  for (std::uint32_t leaf = 0; leaf < slots.size(); ++leaf) {
    if (slots[leaf] != no_slot) {
      places_[slots[leaf]] = {tree, leaf};
    }
  }
}

void BoxForest::tidy() {
  const auto first_worn =
      std::find_if(trees_.begin(), trees_.end(), [](const Tree& tree) { return tree.is_worn(); });
  if (first_worn == trees_.end()) {
    return;
  }
  std::vector<Change> boxes;
  for (auto tree = first_worn; tree != trees_.end(); ++tree) {
    add_boxes(*tree, boxes);
  }
  Tree built = build(boxes);
  trees_.erase(first_worn, trees_.end());
  if (built.live != 0) {
    trees_.push_back(std::move(built));  // in the place of one that was erased
    note_places(static_cast<std::uint32_t>(trees_.size() - 1));
  }
}

BoxForest::Prepared BoxForest::prepare(std::span<const Change> changes, Slot slots) {
  Prepared prepared;
  prepared.slots = slots;
  std::vector<Change> boxes;  // of the new tree
  for (const Change& change : changes) {
    const Place place = change.slot < places_.size() ? places_[change.slot] : nowhere;
    if (place.is_somewhere() && !is_empty(change.box) && is_near(place, change.box)) {
      prepared.fits.push_back({place, change});
      continue;
    }
    if (place.is_somewhere()) {
      prepared.cleared.push_back(change.slot);
    }
    if (!is_empty(change.box)) {
      boxes.push_back(change);
    }
  }
  prepared.kept_trees = trees_.size();
  if (!boxes.empty()) {
    prepared.kept_trees = trees_beside(boxes.size());
    add_unchanged(prepared.kept_trees, changes, boxes);
    const auto leaves_its_tree = [&](const Prepared::Fit& fit) {
      return fit.place.tree >= prepared.kept_trees;
    };
    for (const Prepared::Fit& fit : prepared.fits) {
      if (leaves_its_tree(fit)) {
        boxes.push_back(fit.change);
      }
    }
    std::erase_if(prepared.fits, leaves_its_tree);
    prepared.added = build(boxes);
  }
  trees_.reserve(trees_.size() + 1);
  if (places_.capacity() < slots) {
    places_.reserve(std::max<std::size_t>(slots, 2 * places_.size()));
  }
  return prepared;
}

void BoxForest::add_unchanged(std::size_t first_tree, std::span<const Change> changes,
                              std::vector<Change>& boxes) const {
  for (std::size_t k = first_tree; k < trees_.size(); ++k) {
    for (std::uint32_t leaf = 0; leaf < trees_[k].slots.size(); ++leaf) {
      const Slot slot = trees_[k].slots[leaf];
      if (slot == no_slot) {
        continue;
      }
      const auto change = std::lower_bound(changes.begin(), changes.end(), slot,
                                           [](const Change& c, Slot s) { return c.slot < s; });
      if (change == changes.end() || change->slot != slot) {
        boxes.push_back({slot, trees_[k].box_of(leaf)});
      }
    }
  }
}

void BoxForest::apply(Prepared& prepared) noexcept {
  places_.resize(prepared.slots, nowhere);
  for (const auto& [place, change] : prepared.fits) {
    trees_[place.tree].put(place.leaf, change.box);
  }
  for (const Slot slot : prepared.cleared) {
    const Place place = std::exchange(places_[slot], nowhere);
    if (place.tree < prepared.kept_trees) {
      Tree& tree = trees_[place.tree];
      tree.put(place.leaf, empty_box);
      tree.slots[place.leaf] = no_slot;
      --tree.live;
    }
  }
  trees_.erase(trees_.begin() + static_cast<std::ptrdiff_t>(prepared.kept_trees), trees_.end());
  if (prepared.added.live != 0) {
    trees_.push_back(std::move(prepared.added));  // its place is reserved
    note_places(static_cast<std::uint32_t>(trees_.size() - 1));
  }
}

void BoxForest::renumber(std::span<const Slot> to, Slot slots) noexcept {
  assert(slots <= places_.size());
  for (Tree& tree : trees_) {
    for (Slot& slot : tree.slots) {
      slot = slot == no_slot ? no_slot : to[slot];
    }
  }
  places_.resize(slots, nowhere);
  for (std::uint32_t k = 0; k < trees_.size(); ++k) {
    note_places(k);
  }
}

std::vector<BoxForest::Part> BoxForest::parts() const {
  constexpr std::uint32_t levels = 4;  // of a part: up to 256 boxes
  std::vector<Part> parts;
  for (std::uint32_t k = 0; k < trees_.size(); ++k) {
    const Tree& tree = trees_[k];
    const std::uint32_t depth = tree.depths() > levels ? tree.depths() - levels : 0;
    const auto leaves = static_cast<std::uint64_t>(tree.slots.size());
    const std::uint64_t leaves_a_part = std::uint64_t{1} << 2 * (tree.depths() - depth);
    for (std::uint32_t index = 0; index * leaves_a_part < leaves; ++index) {
      parts.push_back({k, {depth, index}});
    }
  }
  return parts;
}

std::size_t BoxForest::bytes() const {
  std::size_t bytes = places_.capacity() * sizeof(Place) + trees_.capacity() * sizeof(Tree);
  for (const Tree& tree : trees_) {
    bytes += tree.boxes.blocks.capacity() * sizeof(ChainTree::Block) +
             tree.slots.capacity() * sizeof(Slot);
  }
  return bytes;
}

}  // namespace gcv
