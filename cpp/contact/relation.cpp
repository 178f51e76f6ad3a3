// SPDX-License-Identifier: LGPL-3.0-or-later
#include "relation.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "convex_relation.hpp"
#include "point_in_polygon.hpp"
#include "relative_pair.hpp"
#include "solid_cones.hpp"

namespace gcv {

namespace {

using Rings = boost::container::small_vector<Index, 4>;

// The side of a vertex that was asked for last. Edges that follow one another ask for the same.
class LastSide {
 public:
  int side_of(Index edge, Index vertex, const SumEdge& line, const SumPoint& point, Tally& tally) {
    if (edge != edge_ || vertex != vertex_) {
      edge_ = edge;
      vertex_ = vertex;
      side_ = side(line, point, tally);
    }
    return side_;
  }

 private:
  static constexpr Index none = std::numeric_limits<Index>::max();
  Index edge_ = none;
  Index vertex_ = none;
  int side_ = 0;
};

// Searches for a place where the boundaries meet and the cones there overlap.
class OverlapSearch {
 public:
  OverlapSearch(const PlacedPair& placed, Tally& tally)
      : placed_(placed),
        relative_(placed),
        is_far_from_overflow_(relative_.reach() < 0x1p400),
        tally_(tally) {}

  // The rings of A that the boundary of B has met so far.
  [[nodiscard]] const Rings& touched_rings() const { return touched_rings_; }
  [[nodiscard]] const Point& offset() const { return relative_.offset(); }
  // The edges that have ended the search.
  [[nodiscard]] const std::optional<EdgePair>& found() const { return found_; }

  bool run() { return relative_.descend(*this); }

  template <class Visit>
  bool any_child(const ChainTree::Block& block, const Box& box, bool /*is_of_a*/, Visit visit) {
    return any_lane(near_children(block, box), visit);
  }
  template <bool is_of_a>
  bool meet_edges(const ChainTree::Block& block, const Box& box,
                  const EdgesOfBlock<is_of_a>& edges) {
    const unsigned near = near_children(block, box);
    return near != 0 &&
           any_lane(
               near & relative_.may_cross(relative_.edges_of_a(edges), relative_.edges_of_b(edges)),
               [&](std::uint32_t lane) { return meet(edges.i(lane), edges.j(lane)); });
  }

  [[nodiscard]] bool are_beyond_reach(const ChainTree::Node& a, const ChainTree::Node& b) const {
    return relative_.gap_between(a, b) > 0;
  }

  bool meet(Index i, Index j) {
    if (overlap_at(i, j)) {
      found_ = {i, j};
    }
    return found_.has_value();
  }

 private:
  [[nodiscard]] unsigned near_children(const ChainTree::Block& block, const Box& box) const {
    const unsigned near = block.overlapping(widened(box, placed_.pair.slack));
    return is_far_from_overflow_ ? near : near & children_of(block);
  }

  // Do the interiors meet beside a point of both edges? At the ends of the edges, their starts are
  // looked at: the edges that begin where they end have the others.
  bool overlap_at(Index i, Index j) {
    const SumEdge p = placed_.a.edge(i);
    const SumEdge q = placed_.b.edge(j);
    const Index p_next = placed_.a.next(i);
    const Index q_next = placed_.b.next(j);
    // Edges with one end in common have another point in common only if they lie on one line.
    switch (common_end(i, j)) {
      case CommonEnd::starts:
        add_touch(i);
        return overlap_in_vertices(i, j);
      case CommonEnd::end_of_a:
        return of_a_.side_of(j, i, q, placed_.a.vertex(i), tally_) == 0 && overlaps_on_line(i, j);
      case CommonEnd::end_of_b:
        return of_b_.side_of(i, j, p, placed_.b.vertex(j), tally_) == 0 && overlaps_on_line(i, j);
      case CommonEnd::none:
        break;
    }
    const int q_start = of_b_.side_of(i, j, p, placed_.b.vertex(j), tally_);
    const int q_end = of_b_.side_of(i, q_next, p, placed_.b.vertex(q_next), tally_);
    if (!may_meet(q_start, q_end)) {
      return false;
    }
    const int p_start = of_a_.side_of(j, i, q, placed_.a.vertex(i), tally_);
    const int p_end = of_a_.side_of(j, p_next, q, placed_.a.vertex(p_next), tally_);
    if (!may_meet(p_start, p_end)) {
      return false;
    }
    if (q_start == 0 && q_end == 0) {
      return overlaps_on_line(i, j);
    }
    if (q_start * q_end < 0 && p_start * p_end < 0) {
      return !is_sum_of_touches(i, j);
    }
    add_touch(i);
    if (q_start == 0 && p_start == 0) {
      return overlap_in_vertices(i, j);
    }
    return q_start == 0 ? overlap_on_edge(placed_.a, i, placed_.b, j)
                        : overlap_on_edge(placed_.b, j, placed_.a, i);
  }

  // Which ends of two edges are one point? The end of A's and the start of B's, or the end of B's
  // and any of A's, but for both starts.
  enum class CommonEnd : std::uint8_t { none, starts, end_of_a, end_of_b };
  CommonEnd common_end(Index i, Index j) {
    const RelativePair::Ends p = relative_.edge_of_a(i);
    const RelativePair::Ends q = relative_.edge_of_b(j);
    const Index p_next = placed_.a.next(i);
    const Index q_next = placed_.b.next(j);
    const auto are_one = [&](Index vertex, Index other, double x, double y) {
      return std::max(std::abs(x), std::abs(y)) <= relative_.slack() &&
             are_equal(placed_.a.vertex(vertex), placed_.b.vertex(other), tally_);
    };
    if (are_one(i, j, p.from_x - q.from_x, p.from_y - q.from_y)) {
      return CommonEnd::starts;
    }
    if (are_one(p_next, j, p.to_x - q.from_x, p.to_y - q.from_y)) {
      return CommonEnd::end_of_a;
    }
    return are_one(i, q_next, p.from_x - q.to_x, p.from_y - q.to_y) ||
                   are_one(p_next, q_next, p.to_x - q.to_x, p.to_y - q.to_y)
               ? CommonEnd::end_of_b
               : CommonEnd::none;
  }

  // The sides of a line on which an edge starts and ends. May it meet the line, but for its end?
  static bool may_meet(int start, int end) { return start * end < 0 || start == 0; }

  // An edge of A.
  void add_touch(Index edge) {
    const Index ring = placed_.a.boundary.layout.ring_of(edge);
    if (std::find(touched_rings_.begin(), touched_rings_.end(), ring) == touched_rings_.end()) {
      touched_rings_.push_back(ring);
    }
  }

  // Both edges lie on one line.
  bool overlaps_on_line(Index i, Index j) {
    const SumPoint p = placed_.a.vertex(i);
    const SumPoint p_end = placed_.a.vertex(placed_.a.next(i));
    const SumPoint q = placed_.b.vertex(j);
    const SumPoint q_end = placed_.b.vertex(placed_.b.next(j));
    // The order of points along the edge of A.
    const bool by_x = p.a.x != p_end.a.x;
    const bool forwards = by_x ? p.a.x < p_end.a.x : p.a.y < p_end.a.y;
    const auto compare = [&](const SumPoint& u, const SumPoint& v) {
      const int order = by_x ? compare_x(u, v, tally_) : compare_y(u, v, tally_);
      return forwards ? order : -order;
    };
    const int start_to_start = compare(q, p);
    const int start_to_end = compare(q, p_end);
    const int end_to_start = compare(q_end, p);
    const int end_to_end = compare(q_end, p_end);
    if ((start_to_start < 0 && end_to_start < 0) || (start_to_end > 0 && end_to_end > 0)) {
      return false;
    }
    add_touch(i);
    if (start_to_start == 0) {
      return overlap_in_vertices(i, j);
    }
    return (start_to_start > 0 && start_to_end < 0 &&
            overlap_on_edge(placed_.a, i, placed_.b, j)) ||
           (start_to_start * end_to_start < 0 && overlap_on_edge(placed_.b, j, placed_.a, i));
  }

  bool overlap_in_vertices(Index i, Index j) {
    return overlap(cones_of_vertex(placed_.a, i, tally_), cones_of_vertex(placed_.b, j, tally_),
                   tally_);
  }
  // A vertex of the other polygon lies on the inside of an edge. Where a ring touches that edge
  // there, its vertex has all cones.
  bool overlap_on_edge(const PlacedPolygon& polygon, Index edge, const PlacedPolygon& other,
                       Index vertex) {
    const std::vector<Index>& touching = polygon.touches.on(edge);
    const SumPoint point = other.vertex(vertex);
    return std::none_of(touching.begin(), touching.end(),
                        [&](Index k) { return are_equal(polygon.vertex(k), point, tally_); }) &&
           overlap(cones_of_edge(polygon, edge), cones_of_vertex(other, vertex, tally_), tally_);
  }
  // The edges cross. Do they where rings touch both? Then the vertices there have all cones.
  bool is_sum_of_touches(Index i, Index j) {
    const std::vector<Index>& on_a = placed_.a.touches.on(i);
    const std::vector<Index>& on_b = placed_.b.touches.on(j);
    const bool is_sum = std::any_of(on_a.begin(), on_a.end(), [&](Index k) {
      return std::any_of(on_b.begin(), on_b.end(), [&](Index l) {
        return are_equal(placed_.a.vertex(k), placed_.b.vertex(l), tally_);
      });
    });
    if (is_sum) {
      add_touch(i);
    }
    return is_sum;
  }

  const PlacedPair& placed_;
  const RelativePair relative_;
  const bool is_far_from_overflow_;  // then boxes of missing children are apart from all others
  Tally& tally_;
  LastSide of_a_;  // vertices, and lines of B
  LastSide of_b_;
  Rings touched_rings_;
  std::optional<EdgePair> found_;
};

// Calls visit(k) for the edges below a node whose boxes meet that box, until it returns true. Did
// it?
template <class Visit>
bool any_edge_near(const ChainTree& tree, const ChainTree::Node& node, const Box& box,
                   Visit visit) {
  const ChainTree::Block& block = tree.blocks[tree.block_below(node)];
  return any_lane(block.overlapping(box) & children_of(block), [&](std::uint32_t lane) {
    const ChainTree::Node child = ChainTree::child(node, lane);
    return tree.is_edge(child) ? visit(child.index) : any_edge_near(tree, child, box, visit);
  });
}

// The boundary of B meets that of A in these rings at most, and no solid cones overlap there. Does
// one solid hold points of the other?
bool is_inside(const PlacedPair& placed, const Point& offset, const Rings& touched_rings,
               Tally& tally) {
  assert(!placed.b.is_complement());
  const double slack = placed.pair.slack;
  if (touched_rings.empty() && holds(placed.a, placed.b.vertex(0), offset, slack, tally)) {
    return true;
  }
  const RingLayout& rings = placed.a.boundary.layout;
  const auto is_in_b = [&](Index ring) {
    const Index first = rings.begin(ring);
    const Point relative = placed.a.boundary.relative(first);
    return holds(placed.b, placed.a.vertex(first), {relative.x - offset.x, relative.y - offset.y},
                 slack, tally);
  };
  if (!placed.a.is_complement()) {
    return touched_rings.empty() && is_in_b(0);
  }
  const Box box_of_b = widened(moved(placed.b.tree().box, offset), placed.slack(offset));
  return any_edge_near(placed.a.tree(), {0, 0}, box_of_b, [&](Index edge) {
    const Index ring = rings.ring_of(edge);
    return edge == rings.begin(ring) &&
           std::find(touched_rings.begin(), touched_rings.end(), ring) == touched_rings.end() &&
           is_in_b(ring);
  });
}

// Asks the edges first, if there are some, and puts those there that have shown an overlap.
Relation relation(const PlacedPair& placed, std::optional<EdgePair>& edges, Tally& tally) {
  if (are_small_and_convex(placed)) {
    return convex_separation(ConvexPair(placed), tally).relation;
  }
  OverlapSearch search(placed, tally);
  if ((edges && search.meet(edges->i, edges->j)) || search.run()) {
    edges = search.found();
    return Relation::overlapping;
  }
  const Rings& touched_rings = search.touched_rings();
  if (is_inside(placed, search.offset(), touched_rings, tally)) {
    return Relation::overlapping;
  }
  return touched_rings.empty() ? Relation::apart : Relation::touching;
}

}  // namespace

Relation relation(const PlacedPair& placed, Tally& tally) {
  std::optional<EdgePair> edges;
  return relation(placed, edges, tally);
}

Relation NearbyRelations::at(const Point& translation) {
  return relation(PlacedPair(pair_, translation_a_, translation), edges_, tally_);
}

// Edges that cross where rings touch in both polygons show no overlap.
bool NearbyRelations::overlaps_around(const Point& translation, double moved_by) const {
  if (!edges_ || !pair_.a.touches.on(edges_->i).empty() || !pair_.b.touches.on(edges_->j).empty()) {
    return false;
  }
  const PlacedPair placed(pair_, translation_a_, translation);
  const RelativePair relative(placed);
  return relative.cross_nearby(relative.edge_of_a(edges_->i), relative.edge_of_b(edges_->j),
                               moved_by);
}

}  // namespace gcv
