// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The sweep of Shamos and Hoey ("Geometric intersection problems", 1976), with exact predicates. A
// line sweeps over the vertices in lexicographic order. The edges that the line meets are kept in
// order, from bottom to top. Consider the lexicographically smallest point in which two edges meet.
// Two edges through that point become neighbours in the order before the line leaves the point. So
// it is enough to test every pair of edges that become neighbours.
#include "simplicity.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <set>
#include <tuple>
#include <vector>

#include "cycle.hpp"
#include "overlapping_pairs.hpp"
#include "parallel.hpp"
#include "predicates.hpp"
#include "task.hpp"

namespace gcv {

namespace {

using EdgeIndex = std::uint32_t;

// Are the segments ab and cd apart? They must lie on one line.
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
    std::vector<EdgeIndex> order(ring_.size());
    std::iota(order.begin(), order.end(), EdgeIndex{0});
    std::sort(order.begin(), order.end(), [this](EdgeIndex i, EdgeIndex j) {
      return lexicographically_less(ring_[i], ring_[j]);
    });
    for (std::size_t k = 0; k + 1 < order.size(); ++k) {
      if (ring_[order[k]] == ring_[order[k + 1]]) {
        return Conflict{std::min(order[k], order[k + 1]), std::max(order[k], order[k + 1])};
      }
    }
    places_.resize(ring_.size());
    Pace pace;
    for (const EdgeIndex vertex : order) {
      pace.step(16);
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
    bool operator()(EdgeIndex e, EdgeIndex f) const { return sweep->below(e, f); }
  };
  using Active = std::set<EdgeIndex, Below>;
  using Place = Active::iterator;

  [[nodiscard]] EdgeIndex size() const { return static_cast<EdgeIndex>(ring_.size()); }
  [[nodiscard]] EdgeIndex next(EdgeIndex i) const { return cyclic_next(i, size()); }
  [[nodiscard]] bool goes_right(EdgeIndex e) const {
    return lexicographically_less(ring_[e], ring_[next(e)]);
  }
  [[nodiscard]] const Point& left_end(EdgeIndex e) const {
    return ring_[goes_right(e) ? e : next(e)];
  }
  [[nodiscard]] const Point& right_end(EdgeIndex e) const {
    return ring_[goes_right(e) ? next(e) : e];
  }

  void report(EdgeIndex e, EdgeIndex f) {
    if (!conflict_) {
      conflict_ = Conflict{std::min(e, f), std::max(e, f)};
    }
  }

  // The order of two edges that the sweep line meets. Compares the left end that comes later with
  // the other edge.
  bool below(EdgeIndex e, EdgeIndex f) {
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

  // Neighbours in the ring meet in their common vertex. If they overlap, below() finds that.
  [[nodiscard]] bool meet(EdgeIndex e, EdgeIndex f) {
    return next(e) != f && next(f) != e &&
           segments_meet(ring_[e], ring_[next(e)], ring_[f], ring_[next(f)], tally_);
  }

  void test_with_lower_neighbour(Place place) {
    if (place != active_.begin() && place != active_.end() && meet(*std::prev(place), *place)) {
      report(*std::prev(place), *place);
    }
  }

  void enter(EdgeIndex edge, Place hint) {
    const auto place = active_.insert(hint, edge);
    places_[edge] = place;
    test_with_lower_neighbour(place);
    test_with_lower_neighbour(std::next(place));
  }

  Place leave(EdgeIndex edge) { return active_.erase(places_[edge]); }

  void pass(EdgeIndex vertex) {
    const EdgeIndex incoming = cyclic_previous(vertex, size());
    const EdgeIndex outgoing = vertex;
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

// Calls visit(i) for every vertex where the ring turns back, until visit() returns false. The edges
// before and behind such a vertex overlap.
template <class Visit>
void for_each_fold(std::span<const Point> ring, Visit visit) {
  assert(ring.size() >= 3);
  Tally tally;
  std::size_t before = ring.size() - 1;
  bool forwards = lexicographically_less(ring[before], ring[0]);
  for (std::size_t i = 0; i < ring.size(); before = i++) {
    const std::size_t next = cyclic_next(i, ring.size());
    const bool were_forwards = std::exchange(forwards, lexicographically_less(ring[i], ring[next]));
    if (forwards != were_forwards && orientation(ring[before], ring[i], ring[next], tally) == 0 &&
        !visit(i)) {
      return;
    }
  }
}

bool folds_back_somewhere(std::span<const Point> ring) {
  bool folds = false;
  for_each_fold(ring, [&](std::size_t /*vertex*/) {
    folds = true;
    return false;
  });
  return folds;
}

// Do edges e and f meet, and are they not neighbours?
bool conflicting(std::span<const Point> ring, std::size_t e, std::size_t f, Tally& tally) {
  const std::size_t after_e = cyclic_next(e, ring.size());
  const std::size_t after_f = cyclic_next(f, ring.size());
  return after_e != f && after_f != e &&
         segments_meet(ring[e], ring[after_e], ring[f], ring[after_f], tally);
}

// Do a few tests in a bounding volume hierarchy show that no two edges meet? They do if most edges
// are near few others, and they take a fraction of the time of the sweep. With several threads each
// node of some level is one part of the work: its own pairs, and its pairs with later nodes.
bool is_soon_seen_simple(std::span<const Point> ring, const Box& bounds, unsigned threads) {
  constexpr std::uint64_t pairs_per_edge = 8;
  constexpr std::size_t many_edges = 4096;
  if (folds_back_somewhere(ring)) {
    return false;
  }
  const OverlappingPairs pairs(ring, bounds);
  const std::uint32_t level =
      pairs.last_level() - (threads > 1 && ring.size() > many_edges ? 2 : 0);
  const std::uint32_t parts = pairs.nodes(level);
  std::atomic<bool> seen{true};
  for_each_in_parallel(parts, threads, [&](std::size_t part) {
    Tally tally_of_part;
    Pace pace;
    if (!pairs.visit_from(level, static_cast<std::uint32_t>(part),
                          pairs_per_edge * ring.size() / parts, [&](std::size_t e, std::size_t f) {
                            pace.step();
                            return !conflicting(ring, e, f, tally_of_part);
                          })) {
      seen = false;
    }
  });
  return seen;
}

}  // namespace

std::optional<Conflict> find_conflict(std::span<const Point> ring, const Box& bounds,
                                      unsigned threads) {
  const std::size_t n = ring.size();
  Tally tally;
  if (is_convex_ring(ring, [&](std::size_t i) {
        return orientation(ring[cyclic_previous(i, n)], ring[i], ring[cyclic_next(i, n)], tally);
      })) {
    return std::nullopt;
  }
  return is_soon_seen_simple(ring, bounds, threads) ? std::nullopt : Sweep(ring).run();
}

bool is_counter_clockwise(std::span<const Point> ring) {
  assert(ring.size() >= 3);
  const std::size_t lowest = lexicographic_min(ring);
  const std::size_t n = ring.size();
  Tally tally;
  return orientation(ring[cyclic_previous(lowest, n)], ring[lowest], ring[cyclic_next(lowest, n)],
                     tally) > 0;
}

std::vector<Conflict> find_all_conflicts(std::span<const Point> ring) {
  std::vector<Conflict> conflicts;
  Tally tally;
  for_each_fold(ring, [&](std::size_t f) {
    const std::size_t e = cyclic_previous(f, ring.size());
    conflicts.push_back({std::min(e, f), std::max(e, f)});
    return true;
  });
  OverlappingPairs(ring, box_of(ring)).visit_all([&](std::size_t e, std::size_t f) {
    if (conflicting(ring, e, f, tally)) {
      conflicts.push_back({std::min(e, f), std::max(e, f)});
    }
  });
  // The order must not depend on the shape of the tree.
  std::sort(conflicts.begin(), conflicts.end(), [](const Conflict& a, const Conflict& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
  });
  return conflicts;
}

std::vector<std::size_t> find_conflicting_edges(std::span<const Point> ring) {
  constexpr std::uint64_t pairs_per_edge = 64;
  std::vector<std::uint8_t> is_wrong(ring.size());
  Tally tally;
  for_each_fold(ring, [&](std::size_t f) {
    is_wrong[cyclic_previous(f, ring.size())] = is_wrong[f] = 1;
    return true;
  });
  const bool all_seen =
      OverlappingPairs(ring, box_of(ring))
          .visit_some(pairs_per_edge * ring.size(), [&](std::size_t e, std::size_t f) {
            if ((is_wrong[e] & is_wrong[f]) == 0 && conflicting(ring, e, f, tally)) {
              is_wrong[e] = is_wrong[f] = 1;
            }
            return true;
          });
  const bool any = std::find(is_wrong.begin(), is_wrong.end(), 1) != is_wrong.end();
  if (!all_seen && !any && Sweep(ring).run()) {
    std::fill(is_wrong.begin(), is_wrong.end(), std::uint8_t{1});
  }
  std::vector<std::size_t> wrong;
  for (std::size_t e = 0; e < ring.size(); ++e) {
    if (is_wrong[e] != 0) {
      wrong.push_back(e);
    }
  }
  return wrong;
}

}  // namespace gcv
