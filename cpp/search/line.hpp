// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Superset edges on a line. Made for combs: thousands of edges overlap on one line there, and a
// walk along it would meet all of them in each step. The vertices of both polygons are sorted by
// their offsets from the line. How far the edges on it reach is then a merge of sorted sums. Which
// edges can leave it to the right is a comparison of numbers.
#pragma once

#include <vector>

#include "contributing_vertices.hpp"
#include "offset_classes.hpp"
#include "piece.hpp"
#include "tree_product.hpp"

namespace gcv {

class LineSearch {
 public:
  // About lines of the direction of that superset edge. O((n + m) log (n + m)).
  LineSearch(const Operands& operands, const PairEdge& edge);

  // Is it about that direction?
  [[nodiscard]] bool is_about(const PairEdge& edge) const { return edge.rank == direction_.rank; }

  // Moves on to the line of a superset edge. O(n + m) comparisons.
  void go_to(const PairEdge& edge);

  // Where the superset edges end that lead on from that place along the line, one after the other.
  // O((n + m) log (n + m)) for each time that edges of different classes have to follow each other.
  [[nodiscard]] VertexSum reach(VertexSum place) const;

  // A piece of the line as a place to search, for the superset edges alone that end right of the
  // line and start on it or left of it. Exactly so: of the thousands on the line none is visited.
  class Place;

 private:
  // The class of A and that of B whose sums lie on the line.
  struct Match {
    Index a;
    Index b;
  };

  // Is the sum of two vertices of these classes right of the line?
  [[nodiscard]] bool is_right(Index class_of_a, Index class_of_b) const {
    return class_of_b < right_of_b_[class_of_a];
  }

  template <bool a_has_edges>
  bool extend(const OffsetClasses& of_edges, Index edge_class, const OffsetClasses& of_vertices,
              Index vertex_class, VertexSum& place) const;

  const Operands& operands_;
  OffsetClasses::Direction direction_;
  OffsetClasses a_;
  OffsetClasses b_;
  bool is_valid_;
  std::vector<Index>
      right_of_b_;  // for each class of A, how many of B's have sums right of the line
  std::vector<Match> matches_;
};

class LineSearch::Place {
 public:
  Place(const LineSearch& line, const Piece& piece) : line_(line), piece_(piece) {}

  void shorten(const Point& to) { piece_.shorten(to); }

  [[nodiscard]] TreeProduct::Offsets offsets(const Box& box) const { return piece_.offsets(box); }

  void cull(const TreeProduct::Block& block, const TreeProduct::Node& other,
            TreeProduct::Survivors& survivors) const {
    piece_.cull(block, other, survivors);
    const OffsetClasses::Range there = (block.is_of_a ? line_.b_ : line_.a_).range(other.place);
    for_each_lane(survivors.lanes, [&](std::uint32_t k) {
      const OffsetClasses::Range here =
          (block.is_of_a ? line_.a_ : line_.b_).range(block.number, k);
      const auto& a = block.is_of_a ? here : there;
      const auto& b = block.is_of_a ? there : here;
      const bool is_missing = here.lowest > here.highest;  // seen where numbers have overflowed
      if (is_missing || !line_.is_right(a.lowest, b.lowest) ||
          line_.is_right(a.highest, b.highest)) {
        survivors.lanes &= ~(1U << k);
      }
    });
  }

 private:
  const LineSearch& line_;
  Piece piece_;
};

}  // namespace gcv
