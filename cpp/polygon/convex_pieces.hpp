// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Convex polygons inside of a small polygon, which are most of it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "point.hpp"
#include "ring_layout.hpp"

namespace gcv {

struct ConvexPieces {
  std::vector<Index> vertices;    // of one piece after the other, counter-clockwise
  std::vector<std::size_t> ends;  // where each piece ends among them

  [[nodiscard]] std::size_t count() const { return ends.size(); }
  [[nodiscard]] std::span<const Index> piece(std::size_t k) const {
    const std::size_t from = k == 0 ? 0 : ends[k - 1];
    return std::span(vertices).subspan(from, ends[k] - from);
  }
  void add(std::span<const Index> piece);
  // Adds those of another polygon, whose vertices are numbered from `first` on.
  void add(const ConvexPieces& other, Index first);
};

// Of a counter-clockwise ring without straight vertices: the largest pieces, bounded by edges and
// diagonals. None of rings with many vertices. O(n^3) at worst.
ConvexPieces find_convex_pieces(std::span<const Point> ring);

}  // namespace gcv
