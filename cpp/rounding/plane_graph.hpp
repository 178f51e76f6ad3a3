// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The plane graph of segments that meet in their ends only, and the boundary of its unbounded face.
// Snap rounding makes such segments.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "point.hpp"
#include "predicates.hpp"

namespace gcv {

// A segment, from its lexicographically smaller end to the larger one.
struct Segment {
  Point low;
  Point high;

  friend bool operator==(const Segment& s, const Segment& t) {
    return s.low == t.low && s.high == t.high;
  }
  friend bool operator<(const Segment& s, const Segment& t) {
    return s.low == t.low ? lexicographically_less(s.high, t.high)
                          : lexicographically_less(s.low, t.low);
  }
};

inline Segment segment(const Point& p, const Point& q) {
  return lexicographically_less(p, q) ? Segment{p, q} : Segment{q, p};
}

// Vertices are numbered in lexicographic order. O(n log n).
class PlaneGraph {
 public:
  // At least one segment, none twice and none of length 0.
  PlaneGraph(const std::vector<Segment>& segments, Tally& tally);

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] const Point& point(std::size_t p) const { return points_[p]; }

  // Counter-clockwise from the direction that points down.
  [[nodiscard]] std::span<const std::size_t> neighbours(std::size_t p) const {
    return {&neighbours_[first_[p]], first_[p + 1] - first_[p]};
  }

 private:
  [[nodiscard]] std::size_t number(const Point& p) const;
  void sort_round(std::size_t p, Tally& tally);

  PointVector points_;
  std::vector<std::size_t> first_;  // index in neighbours_ of the first neighbour of each vertex
  std::vector<std::size_t> neighbours_;
};

// The walk round the unbounded face of a connected graph, counter-clockwise from the smallest
// vertex. In each vertex it takes the first edge counter-clockwise from the way back.
std::vector<std::size_t> outer_walk(const PlaneGraph& graph);

// The simple cycle with the largest area, of those that a closed walk consists of. Empty if none
// has an area. Areas are measured in pixels of the size `unit`. The numbers of pixels are integers,
// so no area overflows or underflows.
std::vector<std::size_t> largest_cycle(const PlaneGraph& graph,
                                       const std::vector<std::size_t>& walk, const Point& unit);

// At least the distance of any point of the graph from the ring, which is a cycle of it. The graph
// must be connected. O(n).
double distance_left_out(const PlaneGraph& graph, const std::vector<std::size_t>& ring);

}  // namespace gcv
