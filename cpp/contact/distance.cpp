// SPDX-License-Identifier: LGPL-3.0-or-later
#include "distance.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cassert>
#include <cmath>
#include <optional>

#include "relative_pair.hpp"

namespace gcv {

namespace {

// The pairs of an edge and a vertex of two polygons that are apart which may be nearest to each
// other. In doubles.
class NearestPairs {
 public:
  explicit NearestPairs(const PlacedPair& placed) : relative_(placed) {
    PairDescent(placed, *this).run();
  }

  // The nearest one first.
  template <class Visit>
  bool any_child(const ChainTree::Block& block, const Box& box, bool /*is_of_a*/, Visit visit) {
    double squares[ChainTree::width];
    relative_.squares_of_distances(block, box).store(squares);
    return any_in_order(children_of(block), squares, limit_, visit);
  }

  // The start of each of the edges and the other edge.
  bool meet(Index i, Index j) {
    const RelativePair::Ends p = relative_.edge_of_a(i);
    const RelativePair::Ends q = relative_.edge_of_b(j);
    add({ContactKind::edge_vertex, i, j}, RelativePair::square_of_distance(p, q.from));
    add({ContactKind::vertex_edge, i, j}, RelativePair::square_of_distance(q, p.from));
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
      limit_ = relative_.limit_of_squares(std::sqrt(square));
    }
  }

  const RelativePair relative_;
  double least_ = infinity;
  double limit_ = infinity;
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

}  // namespace

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

Separation distance(const PlacedPair& placed, Tally& tally) {
  const Relation relation = gcv::relation(placed, tally);
  if (relation != Relation::apart) {
    return {relation, 0, {}};
  }
  const Contact nearest = contact_of(placed, nearest_features(placed, tally), tally);
  return {relation, nearest.gap, nearest};
}

std::optional<Relation> relation_within(const PlacedPair& placed, double distance, Tally& tally) {
  const Relation relation = gcv::relation(placed, tally);
  if (relation != Relation::apart) {
    return relation;
  }
  const bool is_within =
      distance > 0 &&
      compare_gap(gap_of(placed, nearest_features(placed, tally), tally), distance, tally) <= 0;
  return is_within ? std::optional(relation) : std::nullopt;
}

}  // namespace gcv
