// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where points lie in an exact region. Exact.
//
// A sweep passes over the corners of all rings in lexicographic order, so that no edge is upright.
// It keeps the edges that the sweep line crosses in a search tree, from below. The tree is
// persistent: it copies the path to what changes, and the trees of all places of the sweep line
// stay (Driscoll, Sarnak, Sleator, Tarjan 1989; Sarnak, Tarjan 1986). A point is located in the
// tree of the last corner before it: the edge right below it has its solid above, or not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "exact_order.hpp"
#include "region.hpp"

namespace gcv {

class RegionLocator {
 public:
  // Keeps a reference to the region. O(n log n) time and space, as long as segments overlap few
  // others by x.
  explicit RegionLocator(const ExactRegion& region);

  // 1 inside, 0 on a ring, a segment, or a point, -1 outside. O(log n), and the number of segments
  // that lie above or below the point.
  [[nodiscard]] int locate(const Point& p) const;

 private:
  using Node = std::uint32_t;
  static constexpr Node nothing = 0xffffffff;

  // An edge of a ring, from its lexicographically smaller end to the other one.
  struct Edge {
    std::uint32_t low;  // indices of vertices
    std::uint32_t high;
    EdgeName line;
    bool line_goes_up;  // does the superset edge go from low to high?
    bool solid_is_above;
  };
  // Of a treap. Priorities follow from the numbers of edges.
  struct TreeNode {
    std::uint32_t edge;
    Node below;
    Node above;
  };
  struct Version {
    std::uint32_t corner;  // from this corner on
    Node root;
  };
  // A segment of the region, by x.
  struct Span {
    std::uint32_t low;
    double x_low;     // at most its smallest x
    double x_high;    // at least its largest x
    double furthest;  // the largest x_high of this span and those before it
    EdgeName line;
  };
  struct Split {
    Node below;
    Node above;
  };

  void sweep();
  void add_segment(const RegionPart& part);

  [[nodiscard]] int side_of(const Edge& edge, const RingVertex& v) const;
  // Is the edge f above the edge e? Both have a point in common with the sweep line at a corner:
  // that is the low end of f if it `begins` there, or its high end.
  [[nodiscard]] bool is_above(std::uint32_t e, std::uint32_t f, bool begins) const;

  Node copy(std::uint32_t edge, Node below, Node above);
  Split split(Node tree, std::uint32_t edge);
  Node merge(Node below, Node above);
  Node insert(Node tree, std::uint32_t edge);
  Node erase(Node tree, std::uint32_t edge);

  [[nodiscard]] int side_of(const EdgeName& line, const Point& p) const;
  [[nodiscard]] bool is_on_fit(const Point& p) const;

  const ExactRegion& region_;
  std::vector<ExactOrder::Placed> vertices_;
  std::vector<Edge> edges_;
  std::vector<TreeNode> nodes_;
  std::vector<Version> versions_;
  std::vector<Span> spans_;
  std::vector<std::uint32_t> points_;  // vertices of points, in lexicographic order
};

}  // namespace gcv
