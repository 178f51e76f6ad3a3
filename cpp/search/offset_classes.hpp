// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "contributing_vertices.hpp"
#include "gap_tree.hpp"

namespace gcv {

// A polygon as seen along a direction. Vertices on one line of that direction are one class;
// classes are numbered from the right to the left.
class OffsetClasses {
 public:
  struct Direction {
    Point from;
    Point to;
    Rank rank;
  };

  // The ranks are those of the polygon's edges. O(n log n).
  OffsetClasses(const Boundary& polygon, const Ranks& ranks, const Directions& directions,
                const Direction& direction);

  // False where differences of coordinates overflow: then it is of no use.
  [[nodiscard]] bool is_valid() const { return is_valid_; }

  // How many classes there are, and a vertex of each.
  [[nodiscard]] Index size() const { return static_cast<Index>(representatives_.size()); }
  [[nodiscard]] Index representative(Index number) const { return representatives_[number]; }

  // The classes of the ends of the edges below a node of the polygon's tree.
  struct Range {
    Index lowest;
    Index highest;
  };
  [[nodiscard]] Range range(std::uint32_t block, std::uint32_t child) const {
    return ranges_[block][child];
  }
  [[nodiscard]] Range range(const ChainTree::Node& node) const;

  // A coordinate that grows along the direction, for points on one line.
  [[nodiscard]] double along(Index vertex) const {
    const Point& p = polygon_.vertices[vertex];
    return sign_ * (by_x_ ? p.x : p.y);
  }

  // The edges of that direction in a class.
  [[nodiscard]] std::span<const Index> edges(Index number) const {
    return part(edges_, first_edge_, number);
  }
  // The vertices in a class that contribute to edges of that direction, in the order of along().
  [[nodiscard]] std::span<const Index> contributing(Index number) const {
    return part(contributing_, first_contributing_, number);
  }
  // From the k-th of these, the last one that is reached by gaps no larger than the given one.
  [[nodiscard]] std::size_t last_within(Index number, std::size_t k, const Gap& gap) const {
    const std::size_t first = first_contributing_[number];
    return gaps_.first_above(first + k, gap) - first;
  }

 private:
  static std::span<const Index> part(const std::vector<Index>& all,
                                     const std::vector<std::size_t>& first, Index number) {
    return std::span(all).subspan(first[number], first[number + 1] - first[number]);
  }
  void number_classes(const Direction& direction);
  void take_ranges();
  void take_members(const Ranks& ranks, const Directions& directions, Rank rank);

  const Boundary& polygon_;
  bool by_x_;
  double sign_;
  bool is_valid_ = true;
  std::vector<Index> class_of_;  // of each vertex
  std::vector<Index> representatives_;
  std::vector<std::array<Range, ChainTree::width>> ranges_;  // of the nodes of each block
  std::vector<Index> edges_;                                 // class by class
  std::vector<std::size_t> first_edge_;
  std::vector<Index> contributing_;  // likewise
  std::vector<std::size_t> first_contributing_;
  GapTree gaps_;  // between contributing vertices; infinite behind the last of a class
};

}  // namespace gcv
