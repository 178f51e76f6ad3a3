// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Bounding volume hierarchy over the edges of a boundary chain, with chords: from the first vertex
// of the chain below a node to the last one. A chain is split where it is furthest from its chord,
// so that chains come close to their chords. The sum of two chains is then close to the
// parallelogram of the chords. That tells what it covers (search/witness.hpp). Where chains repeat,
// as the teeth of combs, they are split at round numbers, so that equal ones have equal nodes.
#pragma once

#include <cstdint>
#include <vector>

#include "box.hpp"
#include "point.hpp"
#include "ring_layout.hpp"
#include "simd.hpp"

namespace gcv {

class EdgeChain;

struct ChordTree {
  static constexpr std::uint32_t width = SimdDouble::width;

  // A node: its block, and its lane there.
  using Node = std::uint32_t;
  static constexpr Node root = 0;  // of all edges

  // Up to four nodes: the children of another one. No point of the chain below a node is further
  // than the radius from the chord. Rounding adds up to 24 u times the extents of the boundary. An
  // edge is its own chord, with the radius 0. A node that holds several rings has an infinite
  // radius.
  struct Block {
    BoxBlock<SimdDouble, Box> boxes;
    double x0[width];  // the chords
    double y0[width];
    double x1[width];
    double y1[width];
    double radius[width];
    double length[width];        // of the chord
    double extent[width];        // of the box: width and height; -1 for an edge
    std::uint32_t below[width];  // the block of the children; for an edge its number
    unsigned lanes;              // those that have a node, as bits
  };

  std::vector<Block> blocks;  // each before those of its children
  bool chains_repeat = false;

  [[nodiscard]] const Block& block_of(Node node) const { return blocks[node / width]; }
  static std::uint32_t lane_of(Node node) { return node % width; }
  [[nodiscard]] double extent(Node node) const { return block_of(node).extent[lane_of(node)]; }
  [[nodiscard]] Box box(Node node) const { return block_of(node).boxes.box(lane_of(node)); }
  [[nodiscard]] bool is_edge(Node node) const { return extent(node) < 0; }
  // The number of an edge, or the block that holds the children.
  [[nodiscard]] std::uint32_t below(Node node) const { return block_of(node).below[lane_of(node)]; }
  static Node node(std::uint32_t block, std::uint32_t lane) { return width * block + lane; }
};

// Builds the tree over those edges. O(n log n): no part is less than a quarter of its chain, or
// chains are split at round numbers.
ChordTree build_chord_tree(const EdgeChain& chain, const RingLayout& layout);

}  // namespace gcv
