// SPDX-License-Identifier: LGPL-3.0-or-later
#include "relation.hpp"

#include <algorithm>
#include <cmath>

#include "pair_descent.hpp"
#include "point_in_polygon.hpp"
#include "solid_cones.hpp"

namespace gcv {

namespace {

// Where the boundaries meet: edge i of A and edge j of B, and what their cones do there.
class Meeting {
 public:
  Meeting(const PlacedPair& placed, Tally& tally) : placed_(placed), tally_(tally) {}

  [[nodiscard]] bool has_touched() const { return has_touched_; }

  // Do the interiors meet beside a point of both edges? At the ends of the edges, their starts are
  // looked at: the edges that begin where they end have the others.
  bool overlaps(Index i, Index j) {
    const SumEdge p = placed_.edge_of_a(i);
    const SumEdge q = placed_.edge_of_b(j);
    const int q_start = side(p, placed_.vertex_of_b(j), tally_);
    const int q_end = side(p, placed_.vertex_of_b(placed_.b.next(j)), tally_);
    if (q_start * q_end > 0) {
      return false;
    }
    const int p_start = side(q, placed_.vertex_of_a(i), tally_);
    const int p_end = side(q, placed_.vertex_of_a(placed_.a.next(i)), tally_);
    if (p_start * p_end > 0) {
      return false;
    }
    if (q_start == 0 && q_end == 0) {
      return overlaps_on_line(i, j);
    }
    if (q_start * q_end < 0 && p_start * p_end < 0) {
      return !is_sum_of_touches(i, j);
    }
    has_touched_ = true;
    if (q_start == 0 && p_start == 0) {
      return overlap_in_vertices(i, j);
    }
    if (q_start == 0) {
      return p_end != 0 && overlap_on_edge_of_a(i, j);
    }
    return p_start == 0 && q_end != 0 && overlap_on_edge_of_b(i, j);
  }

 private:
  // Both edges lie on one line.
  bool overlaps_on_line(Index i, Index j) {
    const SumPoint p = placed_.vertex_of_a(i);
    const SumPoint p_end = placed_.vertex_of_a(placed_.a.next(i));
    const SumPoint q = placed_.vertex_of_b(j);
    const SumPoint q_end = placed_.vertex_of_b(placed_.b.next(j));
    // The order of points along the edge of A.
    const bool by_x = p.a.x != p_end.a.x;
    const bool forwards = by_x ? p.a.x < p_end.a.x : p.a.y < p_end.a.y;
    const auto compare = [&](const SumPoint& u, const SumPoint& v) {
      const int order = by_x ? compare_sums(u.a.x, u.b.x, v.a.x, v.b.x, tally_)
                             : compare_sums(u.a.y, u.b.y, v.a.y, v.b.y, tally_);
      return forwards ? order : -order;
    };
    const int start_to_start = compare(q, p);
    const int start_to_end = compare(q, p_end);
    const int end_to_start = compare(q_end, p);
    const int end_to_end = compare(q_end, p_end);
    if ((start_to_start < 0 && end_to_start < 0) || (start_to_end > 0 && end_to_end > 0)) {
      return false;
    }
    has_touched_ = true;
    if (start_to_start == 0) {
      return overlap_in_vertices(i, j);
    }
    return (start_to_start > 0 && start_to_end < 0 && overlap_on_edge_of_a(i, j)) ||
           (start_to_start * end_to_start < 0 && overlap_on_edge_of_b(i, j));
  }

  bool overlap_in_vertices(Index i, Index j) {
    return overlap(cones_of_vertex(placed_.a, placed_.pair.touches_a, i, tally_),
                   cones_of_vertex(placed_.b, placed_.pair.touches_b, j, tally_), tally_);
  }
  // The start of edge j of B lies on the inside of edge i of A. Where a ring touches that edge
  // there, its vertex has all cones.
  bool overlap_on_edge_of_a(Index i, Index j) {
    const std::vector<Index>& touching = placed_.pair.touches_a.on(i);
    const SumPoint vertex = placed_.vertex_of_b(j);
    return std::none_of(
               touching.begin(), touching.end(),
               [&](Index k) { return are_equal(placed_.vertex_of_a(k), vertex, tally_); }) &&
           overlap(cones_of_edge(placed_.a, i),
                   cones_of_vertex(placed_.b, placed_.pair.touches_b, j, tally_), tally_);
  }
  bool overlap_on_edge_of_b(Index i, Index j) {
    const std::vector<Index>& touching = placed_.pair.touches_b.on(j);
    const SumPoint vertex = placed_.vertex_of_a(i);
    return std::none_of(
               touching.begin(), touching.end(),
               [&](Index k) { return are_equal(placed_.vertex_of_b(k), vertex, tally_); }) &&
           overlap(cones_of_vertex(placed_.a, placed_.pair.touches_a, i, tally_),
                   cones_of_edge(placed_.b, j), tally_);
  }
  // The edges cross. Do they where rings touch both? Then the vertices there have all cones.
  bool is_sum_of_touches(Index i, Index j) {
    const std::vector<Index>& on_a = placed_.pair.touches_a.on(i);
    const std::vector<Index>& on_b = placed_.pair.touches_b.on(j);
    const bool is_sum = std::any_of(on_a.begin(), on_a.end(), [&](Index k) {
      return std::any_of(on_b.begin(), on_b.end(), [&](Index l) {
        return are_equal(placed_.vertex_of_a(k), placed_.vertex_of_b(l), tally_);
      });
    });
    has_touched_ = has_touched_ || is_sum;
    return is_sum;
  }

  const PlacedPair& placed_;
  Tally& tally_;
  bool has_touched_ = false;
};

}  // namespace

Relation relation(const PlacedPair& placed, Tally& tally) {
  Meeting meeting(placed, tally);
  if (any_near_pair(placed, [&](Index i, Index j) { return meeting.overlaps(i, j); })) {
    return Relation::overlapping;
  }
  if (meeting.has_touched()) {
    return Relation::touching;
  }
  return a_holds_b(placed, tally) || b_holds_a(placed, tally) ? Relation::overlapping
                                                              : Relation::apart;
}

}  // namespace gcv
