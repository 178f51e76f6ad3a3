// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A placed pair in doubles, seen from the first vertex of A.
#pragma once

#include <algorithm>
#include <cmath>

#include "limits.hpp"
#include "pair_descent.hpp"
#include "polygon_pair.hpp"
#include "vector.hpp"

namespace gcv {

class RelativePair {
 public:
  explicit RelativePair(const PlacedPair& placed)
      : RelativePair(placed, index_beside(placed.a.boundary, placed.b.boundary),
                     index_beside(placed.b.boundary, placed.a.boundary)) {}

  // Descends the trees of both (pair_descent.hpp). Did the search end?
  template <class Search>
  bool descend(Search& search) const {
    const bool by_spreads =
        limits::is_one_small(placed_.a.boundary.size(), placed_.b.boundary.size());
    return PairDescent(index_a_, index_b_, offset_, by_spreads, search).run();
  }
  [[nodiscard]] const Point& offset() const { return offset_; }

  // A power of two by which all lengths are multiplied, so that their squares are in range.
  [[nodiscard]] double scale() const { return scale_; }
  // Of scaled lengths: the slack of the placed pair, and how far points of the two are
  // from each other along both axes together, at most.
  [[nodiscard]] double slack() const { return slack_; }
  [[nodiscard]] double reach() const {
    return scale_ * (extents_ + (std::abs(offset_.x) + std::abs(offset_.y)));
  }

  // The start of an edge of A or B, and its end; or those of four edges.
  template <class Number>
  struct EndsOf {
    Number from_x;
    Number from_y;
    Number to_x;
    Number to_y;
  };
  using Ends = EndsOf<double>;
  using FourEnds = EndsOf<SimdDouble>;

  [[nodiscard]] Ends edge_of_a(Index i) const {
    const Boundary& a = placed_.a.boundary;
    return scaled(a.relative(i), a.relative(placed_.a.next(i)), {0, 0});
  }
  [[nodiscard]] Ends edge_of_b(Index j) const {
    const Boundary& b = placed_.b.boundary;
    return scaled(b.relative(j), b.relative(placed_.b.next(j)), offset_);
  }
  // Of the pairs of edges in the lanes, the edges of A, and those of B.
  template <bool is_of_a>
  [[nodiscard]] FourEnds edges_of_a(const EdgesOfBlock<is_of_a>& edges) const {
    if constexpr (is_of_a) {
      return scaled(edges_a_[edges.number], {0, 0});
    } else {
      return four_times(edge_of_a(edges.other));
    }
  }
  template <bool is_of_a>
  [[nodiscard]] FourEnds edges_of_b(const EdgesOfBlock<is_of_a>& edges) const {
    if constexpr (is_of_a) {
      return four_times(edge_of_b(edges.other));
    } else {
      return scaled(edges_b_[edges.number], offset_);
    }
  }

  // The squares of the distances of a box from the children of a node.
  [[nodiscard]] SimdDouble squares_of_distances(const ChainTree::Block& block,
                                                const Box& box) const {
    const SimdDouble none = SimdDouble::of(0);
    const SimdDouble x = scale_ * larger(none, larger(SimdDouble::load(block.x0) + -box.x1,
                                                      box.x0 - SimdDouble::load(block.x1)));
    const SimdDouble y = scale_ * larger(none, larger(SimdDouble::load(block.y0) + -box.y1,
                                                      box.y0 - SimdDouble::load(block.y1)));
    return x * x + y * y;
  }

  // How far all below a node of A is from all below one of B, or less, wherever B is on a motion:
  // by the line-swept spheres, seen along their segments and across. Scaled.
  //
  // Both spheres are off by 24 u times the extents, other coordinates by less than a quarter of the
  // slack, and products and sums of unit vectors add less than the slack.
  [[nodiscard]] double gap_between(const ChainTree::Node& of_a, const ChainTree::Node& of_b,
                                   const Point& motion = {0, 0}) const;

  // How far q begins on the left of the line of p, and p on the left of that of q, as cross
  // products; and how much further left of p, and less far left of q, the other ends are.
  template <class Number>
  struct CrossProducts {
    Number q_from;
    Number p_from;
    Number cross;
  };
  template <class Number>
  static CrossProducts<Number> cross_products(const EndsOf<Number>& p, const EndsOf<Number>& q) {
    const Number dx = p.to_x - p.from_x;
    const Number dy = p.to_y - p.from_y;
    const Number ex = q.to_x - q.from_x;
    const Number ey = q.to_y - q.from_y;
    const Number x = q.from_x - p.from_x;
    const Number y = q.from_y - p.from_y;
    return {dx * y - dy * x, x * ey - y * ex, dx * ey - dy * ex};
  }

  // The lanes in which neither of two edges lies on one side of the line of the other, as bits,
  // among others. Their boxes must be near each other.
  //
  // Coordinates are off by less than a quarter of the slack. So each cross product is off by less
  // than 1.1 slack (extents + slack), and a sum of two by less than the room.
  [[nodiscard]] unsigned may_cross(const FourEnds& p, const FourEnds& q) const {
    const auto [q_from, p_from, cross] = cross_products(p, q);
    return ~(are_aside(q_from, q_from + cross) | are_aside(p_from, p_from - cross)).bits() &
           SimdDouble::all;
  }

  // Do two edges cross, wherever B is moved to by at most that much along each axis? False where
  // doubles do not tell.
  [[nodiscard]] bool cross_nearby(const Ends& p, const Ends& q, double moved_by) const {
    const double slack = slack_ + 4 * scale_ * moved_by;
    const double room = 4 * slack * (reach() + slack);
    const auto are_opposite = [&](double s, double t) {
      return std::min(s, t) < -room && std::max(s, t) > room;
    };
    const auto [q_from, p_from, cross] = cross_products(p, q);
    return are_opposite(q_from, q_from + cross) && are_opposite(p_from, p_from - cross);
  }

  static double square(double x, double y) { return x * x + y * y; }
  // Of the distance of a point from a segment.
  template <class Number>
  static Number square_of_distance(const EndsOf<Number>& segment, const Number& px,
                                   const Number& py) {
    const Number dx = segment.to_x - segment.from_x;
    const Number dy = segment.to_y - segment.from_y;
    const Number x = px - segment.from_x;
    const Number y = py - segment.from_y;
    const Number end_x = px - segment.to_x;
    const Number end_y = py - segment.to_y;
    const Number length = dx * dx + dy * dy;
    const Number along = dx * x + dy * y;
    const Number height = dx * y - dy * x;
    const Number not_from_start =
        select(along < length, height * (height / length), end_x * end_x + end_y * end_y);
    return select(along > 0, not_from_start, x * x + y * y);
  }
  // What the square of a distance up to `reach` may be in doubles.
  [[nodiscard]] double limit_of_squares(double reach) const {
    const double most = reach + 2 * slack_;
    return (1 + 0x1p-48) * most * most + std::numeric_limits<double>::min();
  }

 private:
  struct Sphere {
    Ends segment;
    double radius;
  };
  [[nodiscard]] Sphere sphere_of(const ChainIndex& index, const ChainTree::Node& node,
                                 const Point& offset) const;
  static double gap_seen_from(const Sphere& p, const Sphere& q, const Point& shift);

  // That of a large polygon beside a small one may be in the order of a curve (tree_product.cpp).
  static const ChainIndex& index_beside(const Boundary& polygon, const Boundary& other) {
    return limits::is_small_beside(other.size(), polygon.size()) ? polygon.search_index()
                                                                 : polygon.index();
  }
  RelativePair(const PlacedPair& placed, const ChainIndex& a, const ChainIndex& b)
      : placed_(placed),
        index_a_(a),
        index_b_(b),
        edges_a_(blocks_of_edges(a)),
        edges_b_(blocks_of_edges(b)),
        offset_(placed.offset()),
        extents_(extents_of(a.tree.box) + extents_of(b.tree.box)),
        scale_(scale_for_squares(extents_ + std::abs(offset_.x) + std::abs(offset_.y))),
        slack_(scale_ * placed.slack(offset_)),
        room_(4 * slack_ * (scale_ * extents_ + slack_)) {}

  // Are both above 0, or both below, by more than roundings are?
  [[nodiscard]] DoubleMask are_aside(const SimdDouble& p, const SimdDouble& q) const {
    return (smaller(p, q) > room_) | (larger(p, q) < -room_);
  }

  static FourEnds four_times(const Ends& edge) {
    return {SimdDouble::of(edge.from_x), SimdDouble::of(edge.from_y), SimdDouble::of(edge.to_x),
            SimdDouble::of(edge.to_y)};
  }
  static double select(bool is_first, double p, double q) { return is_first ? p : q; }
  static SimdDouble select(const DoubleMask& mask, const SimdDouble& p, const SimdDouble& q) {
    return gcv::select(mask, p, q);
  }

  [[nodiscard]] Ends scaled(const Point& from, const Point& to, const Point& offset) const {
    return {scale_ * (from.x + offset.x), scale_ * (from.y + offset.y), scale_ * (to.x + offset.x),
            scale_ * (to.y + offset.y)};
  }
  [[nodiscard]] FourEnds scaled(const SegmentBlock& edges, const Point& offset) const {
    return {scale_ * (SimdDouble::load(edges.x0) + offset.x),
            scale_ * (SimdDouble::load(edges.y0) + offset.y),
            scale_ * (SimdDouble::load(edges.x1) + offset.x),
            scale_ * (SimdDouble::load(edges.y1) + offset.y)};
  }
  static const SweptSphereBlock* blocks_of_edges(const ChainIndex& index) {
    return index.spheres.data() + index.tree.first_block.back();
  }

  const PlacedPair& placed_;
  const ChainIndex& index_a_;
  const ChainIndex& index_b_;
  const SweptSphereBlock* const edges_a_;
  const SweptSphereBlock* const edges_b_;
  const Point offset_;
  const double extents_;  // of both
  const double scale_;
  const double slack_;
  const double room_;  // of cross products
};

}  // namespace gcv
