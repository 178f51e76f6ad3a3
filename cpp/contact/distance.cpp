// SPDX-License-Identifier: LGPL-3.0-or-later
#include "distance.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cassert>
#include <cmath>
#include <optional>

#include "pair_descent.hpp"

namespace gcv {

namespace {

// The pairs of an edge and a vertex of two polygons that are apart which may be nearest to each
// other. In doubles, relative to the first vertex of A.
class NearestPairs {
 public:
  explicit NearestPairs(const PlacedPair& placed)
      : placed_(placed),
        offset_(placed.offset()),
        scale_(scale_for(extent(placed.a.tree.box) + extent(placed.b.tree.box) +
                         std::abs(offset_.x) + std::abs(offset_.y))),
        slack_(scale_ *
               (placed.pair.slack + 0x1p-48 * (std::abs(offset_.x) + std::abs(offset_.y)))) {
    PairDescent(placed, *this).run();
  }

  // The nearest one first.
  template <class Visit>
  bool any_child(const ChainTree::Block& block, const Box& box, bool /*is_of_a*/, Visit visit) {
    const SimdDouble none = SimdDouble::of(0);
    const SimdDouble x = scale_ * larger(none, larger(SimdDouble::load(block.x0) + -box.x1,
                                                      box.x0 - SimdDouble::load(block.x1)));
    const SimdDouble y = scale_ * larger(none, larger(SimdDouble::load(block.y0) + -box.y1,
                                                      box.y0 - SimdDouble::load(block.y1)));
    double squares[ChainTree::width];
    (x * x + y * y).store(squares);
    return any_in_order(children_of(block), squares, limit_, visit);
  }

  // The start of each of the edges and the other edge.
  bool meet(Index i, Index j) {
    const Point p = scaled(placed_.a.boundary.relative(i));
    const Point p_end = scaled(placed_.a.boundary.relative(placed_.a.next(i)));
    const Point q = scaled(moved(placed_.b.boundary.relative(j)));
    const Point q_end = scaled(moved(placed_.b.boundary.relative(placed_.b.next(j))));
    add({ContactKind::edge_vertex, i, j}, square_of_distance(p, p_end, q));
    add({ContactKind::vertex_edge, i, j}, square_of_distance(q, q_end, p));
    return false;
  }

  // Calls visit(name) for each of them: the vertex may be nearest to an end of the edge.
  template <class Visit>
  void for_each(Visit visit) const {
    for (const Candidate& candidate : candidates_) {
      if (!(candidate.square > limit_)) {
        visit(candidate.name);
      }
    }
  }

 private:
  struct Candidate {
    double square;  // of the distance
    ContactName name;
  };
  void add(const ContactName& name, double square) {
    if (square > limit_) {
      return;
    }
    candidates_.push_back({square, name});
    if (square < least_) {
      least_ = square;
      const double reach = std::sqrt(square) + 2 * slack_;
      limit_ = (1 + 0x1p-48) * reach * reach + std::numeric_limits<double>::min();
    }
  }

  [[nodiscard]] Point moved(const Point& p) const { return {p.x + offset_.x, p.y + offset_.y}; }
  [[nodiscard]] Point scaled(const Point& p) const { return {scale_ * p.x, scale_ * p.y}; }
  // A power of two by which lengths of that size can be multiplied so that their squares are in
  // range.
  static double scale_for(double size) {
    return size > 0x1p400 ? 0x1p-600 : size < 0x1p-400 ? 0x1p600 : 1;
  }

  static double square(double x, double y) { return x * x + y * y; }
  // Of a point from a segment.
  static double square_of_distance(const Point& from, const Point& to, const Point& p) {
    const double dx = to.x - from.x;
    const double dy = to.y - from.y;
    const double x = p.x - from.x;
    const double y = p.y - from.y;
    const double length = square(dx, dy);
    const double along = dx * x + dy * y;
    if (along > 0 && along < length) {
      const double height = dx * y - dy * x;
      return height * (height / length);
    }
    return along <= 0 ? square(x, y) : square(p.x - to.x, p.y - to.y);
  }

  const PlacedPair& placed_;
  const Point offset_;
  const double scale_;  // of all distances below
  const double slack_;
  double least_ = std::numeric_limits<double>::infinity();
  double limit_ = std::numeric_limits<double>::infinity();
  boost::container::small_vector<Candidate, 16> candidates_;
};

// The features that are nearest to each other in such a pair.
ContactName nearest_features(const PlacedPair& placed, const ContactName& name, Nearest nearest) {
  const bool is_end = nearest == Nearest::end;
  if (nearest == Nearest::inside) {
    return name;
  }
  if (name.kind == ContactKind::edge_vertex) {
    return {ContactKind::vertex_vertex, is_end ? placed.a.next(name.i) : name.i, name.j};
  }
  return {ContactKind::vertex_vertex, name.i, is_end ? placed.b.next(name.j) : name.j};
}

// The nearest pair of features, exactly.
ContactName nearest_features(const PlacedPair& placed, Tally& tally) {
  std::optional<ContactName> best;
  Gap gap{};
  NearestPairs(placed).for_each([&](const ContactName& candidate) {
    const EdgeAndVertex pair = edge_and_vertex(placed, candidate);
    const Nearest nearest = nearest_on(pair, tally);
    const ContactName name = nearest_features(placed, candidate, nearest);
    if (best == name) {
      return;
    }
    const Gap other = gap_between(pair, nearest);
    const int order = best ? compare_gaps(other, gap, tally) : -1;
    if (order < 0 || (order == 0 && order_of(placed, name) < order_of(placed, *best))) {
      best = name;
      gap = other;
    }
  });
  assert(best);
  return *best;
}

}  // namespace

Separation distance(const PlacedPair& placed, Tally& tally) {
  const Relation relation = gcv::relation(placed, tally);
  if (relation != Relation::apart) {
    return {relation, 0, {}};
  }
  const Contact nearest = contact_of(placed, nearest_features(placed, tally), tally);
  return {relation, nearest.gap, nearest};
}

}  // namespace gcv
