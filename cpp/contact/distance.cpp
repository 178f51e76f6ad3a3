// SPDX-License-Identifier: LGPL-3.0-or-later
#include "distance.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "relative_pair.hpp"

namespace gcv {

namespace {

// The pairs of an edge and a vertex of two polygons that are apart which may be nearest to each
// other, if they are no further than a distance. In doubles.
class NearestPairs {
 public:
  explicit NearestPairs(const PlacedPair& placed, double distance = infinity)
      : relative_(placed), limit_(relative_.limit_of_squares(relative_.scale() * distance)) {
    relative_.descend(*this);
  }

  // The nearest one first.
  template <class Visit>
  bool any_child(const ChainTree::Block& block, const Box& box, bool /*is_of_a*/, Visit visit) {
    double squares[ChainTree::width];
    relative_.squares_of_distances(block, box).store(squares);
    return any_in_order(children_of(block), squares, limit_, visit);
  }

  [[nodiscard]] bool are_beyond_reach(const ChainTree::Node& a, const ChainTree::Node& b) const {
    const double gap = relative_.gap_between(a, b);
    return gap > 0 && gap * gap > limit_;
  }

  // The start of each of the edges and the other edge.
  template <bool is_of_a>
  bool meet_edges(const ChainTree::Block& block, const Box& /*box*/,
                  const EdgesOfBlock<is_of_a>& edges) {
    const FourEnds p = relative_.edges_of_a(edges);
    const FourEnds q = relative_.edges_of_b(edges);
    const unsigned lanes = children_of(block);
    add(ContactKind::edge_vertex, lanes, edges,
        RelativePair::square_of_distance(p, q.from_x, q.from_y));
    add(ContactKind::vertex_edge, lanes, edges,
        RelativePair::square_of_distance(q, p.from_x, p.from_y));
    return false;
  }

  // Is is(name) true for one of them? The vertex may be nearest to an end of the edge.
  template <class Is>
  [[nodiscard]] bool any(Is is) const {
    return std::any_of(candidates_.begin(), candidates_.end(), [&](const Candidate& candidate) {
      return !(candidate.square > limit_) && is(candidate.name);
    });
  }

 private:
  struct Candidate {
    double square;  // of the distance
    ContactName name;
  };
  using FourEnds = RelativePair::FourEnds;

  template <bool is_of_a>
  void add(ContactKind kind, unsigned lanes, const EdgesOfBlock<is_of_a>& edges,
           const SimdDouble& squares) {
    double each[ChainTree::width];
    squares.store(each);
    const unsigned far = (squares > limit_).bits();
    for_each_lane(lanes & ~far, [&](std::uint32_t lane) {
      add({kind, edges.i(lane), edges.j(lane)}, each[lane]);
    });
  }
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
  double limit_;
  boost::container::small_vector<Candidate, 16> candidates_;
};

// The features that are nearest to each other in such a pair.
ContactName features(const PlacedPair& placed, const ContactName& name, Nearest nearest) {
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

std::optional<NearestFeatures> nearest_features(const PlacedPair& placed, Tally& tally,
                                                double distance) {
  std::optional<NearestFeatures> best;
  static_cast<void>(NearestPairs(placed, distance).any([&](const ContactName& candidate) {
    const EdgeAndVertex pair = edge_and_vertex(placed, candidate);
    const Nearest nearest = nearest_on(pair, tally);
    const ContactName name = features(placed, candidate, nearest);
    if (best && best->name == name) {
      return false;
    }
    const Gap gap = gap_between(pair, nearest);
    const int order = best ? compare_gaps(gap, best->gap, tally) : -1;
    if (order < 0 || (order == 0 && order_of(placed, name) < order_of(placed, best->name))) {
      best = {name, gap};
    }
    return false;
  }));
  return best;
}

Separation distance(const PlacedPair& placed, Tally& tally) {
  const Relation relation = gcv::relation(placed, tally);
  if (relation != Relation::apart) {
    return {relation, 0, {}};
  }
  const std::optional<NearestFeatures> features = nearest_features(placed, tally);
  assert(features);
  const Contact nearest = contact_across(placed, features->name, features->gap, tally);
  return {relation, nearest.gap, nearest};
}

std::optional<Relation> relation_within(const PlacedPair& placed, double distance, Tally& tally) {
  const Relation relation = gcv::relation(placed, tally);
  if (relation != Relation::apart) {
    return relation;
  }
  const auto is_within = [&](const ContactName& candidate) {
    const EdgeAndVertex pair = edge_and_vertex(placed, candidate);
    return compare_gap(gap_between(pair, nearest_on(pair, tally)), distance, tally) <= 0;
  };
  return distance > 0 && NearestPairs(placed, distance).any(is_within) ? std::optional(relation)
                                                                       : std::nullopt;
}

}  // namespace gcv
