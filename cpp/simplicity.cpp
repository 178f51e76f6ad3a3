// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The sweep of Shamos and Hoey ("Geometric intersection problems", 1976) with exact
// predicates. A line sweeps over the vertices in lexicographic order; the edges that it
// meets are kept in order from bottom to top. Of the lexicographically smallest point in
// which two edges meet, two edges become neighbours in this order before the line leaves
// it, so it is enough to test each pair of edges that become neighbours.
#include "simplicity.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "chain_tree.hpp"
#include "predicates.hpp"

namespace gcv {

namespace {

using Edge = std::uint32_t;

// Are the segments ab and cd of one line apart?
bool disjoint_on_a_line(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto& [ab_min, ab_max] = std::minmax(a, b, lexicographically_less);
  const auto& [cd_min, cd_max] = std::minmax(c, d, lexicographically_less);
  return lexicographically_less(ab_max, cd_min) || lexicographically_less(cd_max, ab_min);
}

// Have the closed segments ab and cd a point in common?
bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d, Tally& tally) {
  const int c_side = orientation(a, b, c, tally);
  const int d_side = orientation(a, b, d, tally);
  if (c_side == 0 && d_side == 0) {
    return !disjoint_on_a_line(a, b, c, d);
  }
  return c_side * d_side <= 0 && orientation(c, d, a, tally) * orientation(c, d, b, tally) <= 0;
}

class Sweep {
 public:
  explicit Sweep(std::span<const Point> ring) : ring_(ring), active_(Below{this}) {}

  std::optional<Conflict> run() {
    std::vector<Edge> order(ring_.size());
    std::iota(order.begin(), order.end(), Edge{0});
    std::sort(order.begin(), order.end(),
              [this](Edge i, Edge j) { return lexicographically_less(ring_[i], ring_[j]); });
    for (std::size_t k = 0; k + 1 < order.size(); ++k) {
      if (ring_[order[k]] == ring_[order[k + 1]]) {
        return Conflict{std::min(order[k], order[k + 1]), std::max(order[k], order[k + 1])};
      }
    }
    places_.resize(ring_.size());
    for (const Edge vertex : order) {
      pass(vertex);
      if (conflict_) {
        return conflict_;
      }
    }
    return std::nullopt;
  }

 private:
  struct Below {
    Sweep* sweep;
    bool operator()(Edge e, Edge f) const { return sweep->below(e, f); }
  };
  using Active = std::set<Edge, Below>;
  using Place = Active::iterator;

  [[nodiscard]] Edge next(Edge i) const { return i + 1 == ring_.size() ? 0 : i + 1; }
  [[nodiscard]] Edge previous(Edge i) const {
    return i == 0 ? static_cast<Edge>(ring_.size() - 1) : i - 1;
  }
  [[nodiscard]] bool goes_right(Edge e) const {
    return lexicographically_less(ring_[e], ring_[next(e)]);
  }
  [[nodiscard]] const Point& left_end(Edge e) const { return ring_[goes_right(e) ? e : next(e)]; }
  [[nodiscard]] const Point& right_end(Edge e) const { return ring_[goes_right(e) ? next(e) : e]; }

  void report(Edge e, Edge f) {
    if (!conflict_) {
      conflict_ = Conflict{std::min(e, f), std::max(e, f)};
    }
  }

  // The order of two edges that the sweep line meets, by the left end that comes later.
  bool below(Edge e, Edge f) {
    if (e == f) {
      return false;
    }
    const Point& le = left_end(e);
    const Point& lf = left_end(f);
    if (le == lf) {
      const int turn = orientation(le, right_end(e), right_end(f), tally_);
      if (turn == 0) {
        report(e, f);
      }
      return turn > 0;
    }
    const bool e_is_later = lexicographically_less(lf, le);
    const int turn = e_is_later ? -orientation(lf, right_end(f), le, tally_)
                                : orientation(le, right_end(e), lf, tally_);
    if (turn == 0) {
      report(e, f);
    }
    return turn > 0;
  }

  // Neighbours meet in their common vertex, and the order of the edges finds the rest.
  [[nodiscard]] bool meet(Edge e, Edge f) {
    return next(e) != f && next(f) != e &&
           segments_meet(ring_[e], ring_[next(e)], ring_[f], ring_[next(f)], tally_);
  }

  void test_with_lower_neighbour(Place place) {
    if (place != active_.begin() && place != active_.end() && meet(*std::prev(place), *place)) {
      report(*std::prev(place), *place);
    }
  }

  void enter(Edge edge, Place hint) {
    const auto place = active_.insert(hint, edge);
    places_[edge] = place;
    test_with_lower_neighbour(place);
    test_with_lower_neighbour(std::next(place));
  }

  Place leave(Edge edge) { return active_.erase(places_[edge]); }

  void pass(Edge vertex) {
    const Edge incoming = previous(vertex);
    const Edge outgoing = vertex;
    const bool incoming_starts = !goes_right(incoming);
    const bool outgoing_starts = goes_right(outgoing);
    if (incoming_starts && outgoing_starts) {
      enter(incoming, active_.end());
      if (!conflict_) {
        enter(outgoing, std::next(places_[incoming]));
      }
    } else if (outgoing_starts) {
      enter(outgoing, leave(incoming));
    } else if (incoming_starts) {
      enter(incoming, leave(outgoing));
    } else {
      leave(incoming);
      test_with_lower_neighbour(leave(outgoing));
    }
  }

  std::span<const Point> ring_;
  Active active_;
  std::vector<Place> places_;
  std::optional<Conflict> conflict_;
  Tally tally_;
};

bool overlap(const Box& a, const Box& b) {
  return a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1;
}

// Descends the tree of boxes against itself, to all pairs of edges that meet.
class PairSearch {
 public:
  PairSearch(std::span<const Point> ring, const ChainTree& tree) : ring_(ring), tree_(tree) {}

  std::vector<Conflict> run() {
    within(tree_.root());
    // In an order that the shape of the tree has no part in.
    std::sort(conflicts_.begin(), conflicts_.end(), [](const Conflict& a, const Conflict& b) {
      return std::tie(a.first, a.second) < std::tie(b.first, b.second);
    });
    return std::move(conflicts_);
  }

 private:
  using Node = ChainTree::Node;

  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 == ring_.size() ? 0 : i + 1; }

  void within(Node node) {
    if (node.level == 0) {
      for (Edge e = ChainTree::first_edge(node.k); e < tree_.last_edge(node.k); ++e) {
        for (Edge f = e + 1; f < tree_.last_edge(node.k); ++f) {
          test(e, f);
        }
      }
      return;
    }
    const Node left{node.level - 1, 2 * node.k};
    within(left);
    if (tree_.has_right_child(node)) {
      const Node right{node.level - 1, 2 * node.k + 1};
      within(right);
      between(left, right);
    }
  }

  // All edges below one node with all edges below another on the same level.
  void between(Node first, Node second) {
    if (!overlap(tree_.boxes[tree_.index(first)], tree_.boxes[tree_.index(second)])) {
      return;
    }
    if (first.level == 0) {
      for (Edge e = ChainTree::first_edge(first.k); e < tree_.last_edge(first.k); ++e) {
        for (Edge f = ChainTree::first_edge(second.k); f < tree_.last_edge(second.k); ++f) {
          test(e, f);
        }
      }
      return;
    }
    for (Edge i = 0; i < 2; ++i) {
      for (Edge j = 0; j < 2; ++j) {
        if ((i == 0 || tree_.has_right_child(first)) && (j == 0 || tree_.has_right_child(second))) {
          between({first.level - 1, 2 * first.k + i}, {second.level - 1, 2 * second.k + j});
        }
      }
    }
  }

  void test(Edge e, Edge f) {
    if (conflicting(e, f)) {
      conflicts_.push_back({std::min(e, f), std::max(e, f)});
    }
  }

  [[nodiscard]] bool conflicting(Edge e, Edge f) {
    if (next(e) == f) {
      return fold_back(ring_[e], ring_[f], ring_[next(f)]);
    }
    if (next(f) == e) {
      return fold_back(ring_[f], ring_[e], ring_[next(e)]);
    }
    return segments_meet(ring_[e], ring_[next(e)], ring_[f], ring_[next(f)], tally_);
  }

  // Do the neighbours pq and qr overlap?
  [[nodiscard]] bool fold_back(const Point& p, const Point& q, const Point& r) {
    return orientation(p, q, r, tally_) == 0 &&
           lexicographically_less(p, q) != lexicographically_less(q, r);
  }

  std::span<const Point> ring_;
  const ChainTree& tree_;
  std::vector<Conflict> conflicts_;
  Tally tally_;
};

}  // namespace

std::optional<Conflict> find_conflict(std::span<const Point> ring) { return Sweep(ring).run(); }

bool is_counter_clockwise(std::span<const Point> ring) {
  const auto lowest = static_cast<std::size_t>(
      std::min_element(ring.begin(), ring.end(), lexicographically_less) - ring.begin());
  const std::size_t n = ring.size();
  Tally tally;
  return orientation(ring[(lowest + n - 1) % n], ring[lowest], ring[(lowest + 1) % n], tally) > 0;
}

std::vector<Conflict> find_all_conflicts(std::span<const Point> ring) {
  const ChainTree tree = build_chain_tree(ring);
  return PairSearch(ring, tree).run();
}

}  // namespace gcv
