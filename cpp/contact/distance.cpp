// SPDX-License-Identifier: LGPL-3.0-or-later
#include "distance.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cassert>
#include <cmath>
#include <optional>
#include <vector>

#include "convex_distance.hpp"
#include "far_pairs.hpp"
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

// Is is(name) true for one of the pairs of an edge and a vertex that may be nearest to each other,
// if they are no further than a distance?
template <class Is>
bool any_nearest_pair(const PlacedPair& placed, double distance, Is is) {
  if (are_far_apart(placed)) {
    const std::vector<ContactName> pairs = nearest_of_far_pair(placed);
    return std::any_of(pairs.begin(), pairs.end(), is);
  }
  return NearestPairs(placed, distance).any(is);
}

// The nearest of pairs of an edge and a vertex, exactly; of several the first in the order of
// contacts.
class NearestOf {
 public:
  NearestOf(const PlacedPair& placed, Tally& tally) : placed_(placed), tally_(tally) {}

  void consider(const ContactName& candidate) {
    const EdgeAndVertex pair = edge_and_vertex(placed_, candidate);
    const Nearest nearest = nearest_on(pair, tally_);
    const ContactName name = features(placed_, candidate, nearest);
    if (best_ && best_->name == name) {
      return;
    }
    const Gap gap = gap_between(pair, nearest);
    const int order = best_ ? compare_gaps(gap, best_->gap, tally_) : -1;
    if (order < 0 || (order == 0 && order_of(placed_, name) < order_of(placed_, best_->name))) {
      best_ = {name, gap};
    }
  }
  [[nodiscard]] const std::optional<NearestFeatures>& found() const { return best_; }

 private:
  const PlacedPair& placed_;
  Tally& tally_;
  std::optional<NearestFeatures> best_;
};

// Of two polygons that are apart, if they are no further than a distance.
std::optional<NearestFeatures> nearest_features(const PlacedPair& placed, double distance,
                                                Tally& tally) {
  NearestOf nearest(placed, tally);
  any_nearest_pair(placed, distance, [&](const ContactName& candidate) {
    nearest.consider(candidate);
    return false;
  });
  return nearest.found();
}

// Of features that are known to be the nearest.
NearestFeatures with_gap(const PlacedPair& placed, const ContactName& name, Tally& tally) {
  return {name, name.kind == ContactKind::vertex_vertex
                    ? gap_of(placed, name, tally)
                    : gap_between(edge_and_vertex(placed, name), Nearest::inside)};
}

// Of parallel edges that face each other, all contacts of a vertex between the ends of the other
// edge are as near.
std::optional<NearestFeatures> nearest_of_facing(const PlacedPair& placed, Index i, Index j,
                                                 Tally& tally) {
  const auto is_between_ends = [&](const ContactName& name) {
    return nearest_on(edge_and_vertex(placed, name), tally) == Nearest::inside;
  };
  if (const auto name = first_of_facing(placed, i, j, is_between_ends)) {
    return with_gap(placed, *name, tally);
  }
  NearestOf nearest(placed, tally);
  nearest.consider({ContactKind::edge_vertex, i, j});
  nearest.consider({ContactKind::edge_vertex, i, placed.b.next(j)});
  return nearest.found();
}

// The relation, and what is known of the nearest features.
struct Answer {
  Relation relation;
  NearestOfConvex nearest;
};
using Kind = NearestOfConvex::Kind;
constexpr NearestOfConvex unknown{Kind::unknown, {}};
constexpr NearestOfConvex further{Kind::further, {}};
Answer ask(const PlacedPair& placed, double distance, Tally& tally) {
  if (!are_small_and_convex(placed)) {
    return {relation(placed, tally), unknown};
  }
  const ConvexPair pair(placed);
  const ConvexSeparation separation = convex_separation(pair, tally);
  return {separation.relation, separation.relation == Relation::apart
                                   ? nearest_of_convex(placed, pair, separation, distance, tally)
                                   : unknown};
}

}  // namespace

NearestOfPair nearest_of_pair(const PlacedPair& placed, double distance, Tally& tally) {
  const auto [relation, nearest] = ask(placed, distance, tally);
  if (relation != Relation::apart) {
    return {relation, std::nullopt};
  }
  switch (nearest.kind) {
    case Kind::alone:
      return {relation, with_gap(placed, nearest.name, tally)};
    case Kind::facing:
      return {relation, nearest_of_facing(placed, nearest.edge_of_a, nearest.edge_of_b, tally)};
    case Kind::further:
      return {relation, std::nullopt};
    default:
      return {relation, nearest_features(placed, distance, tally)};
  }
}

Separation distance(const PlacedPair& placed, Tally& tally) {
  const auto [relation, features] = nearest_of_pair(placed, infinity, tally);
  if (relation != Relation::apart) {
    return {relation, 0, {}};
  }
  assert(features);
  const Contact nearest = contact_across(placed, features->name, features->gap, tally);
  return {relation, nearest.gap, nearest};
}

std::optional<Relation> relation_within(const PlacedPair& placed, double distance, Tally& tally) {
  const auto [relation, nearest] =
      distance > 0 ? ask(placed, distance, tally) : Answer{gcv::relation(placed, tally), further};
  if (relation != Relation::apart) {
    return relation;
  }
  const auto is_within = [&](const Gap& gap) { return compare_gap(gap, distance, tally) <= 0; };
  const auto is_candidate_within = [&](const ContactName& candidate) {
    const EdgeAndVertex pair = edge_and_vertex(placed, candidate);
    return is_within(gap_between(pair, nearest_on(pair, tally)));
  };
  const bool is_near =
      nearest.kind == Kind::unknown
          ? any_nearest_pair(placed, distance, is_candidate_within)
          : nearest.kind != Kind::further && is_within(with_gap(placed, nearest.name, tally).gap);
  return is_near ? std::optional(relation) : std::nullopt;
}

}  // namespace gcv
