// SPDX-License-Identifier: LGPL-3.0-or-later
#include "ring_sweep.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <set>
#include <vector>

#include "predicates.hpp"
#include "task.hpp"

namespace gcv {

namespace {

class RingSweep {
 public:
  RingSweep(std::span<const Point> points, const RingLayout& layout, RingVisitor& visitor,
            Tally& tally)
      : points_(points),
        layout_(layout),
        visitor_(visitor),
        tally_(tally),
        sweep_(FromBelow{this}),
        places_(points.size()) {
    spans_.reserve(points.size());
    for (Index e = 0; e < layout.size(); ++e) {
      const Point& from = points[e];
      const Point& to = points[layout.next(e)];
      spans_.push_back(lexicographically_less(from, to) ? Span{from, to} : Span{to, from});
    }
  }

  void run() {
    std::vector<Index> order(points_.size());
    std::iota(order.begin(), order.end(), Index{0});
    Pace pace;
    std::sort(order.begin(), order.end(), [&](Index i, Index j) {
      pace.step();
      return lexicographically_less(points_[i], points_[j]);
    });
    for (std::size_t k = 0; k < order.size();) {
      std::size_t end = k + 1;
      while (end < order.size() && points_[order[end]] == points_[order[k]]) {
        ++end;
      }
      pace.step(16 * (end - k));
      pass(std::span(order).subspan(k, end - k));
      k = end;
    }
  }

 private:
  // An edge from its lexicographically smaller end on.
  struct Span {
    Point left;
    Point right;
  };
  // Of edges that do not cross and are met by one line, from below; and of a point among them.
  struct FromBelow {
    using is_transparent = void;
    RingSweep* sweep;

    bool operator()(Index e, Index f) const {
      const Span& p = sweep->spans_[e];
      const Span& q = sweep->spans_[f];
      return lexicographically_less(q.left, p.left) ? sweep->side(q, p) < 0 : sweep->side(p, q) > 0;
    }
    bool operator()(Index e, const Point& q) const {
      const Span& p = sweep->spans_[e];
      return orientation(p.left, p.right, q, sweep->tally_) > 0;
    }
  };
  using Sweep = std::set<Index, FromBelow>;

  // On which side of p is q?
  int side(const Span& p, const Span& q) {
    const int of_left = orientation(p.left, p.right, q.left, tally_);
    return of_left != 0 ? of_left : orientation(p.left, p.right, q.right, tally_);
  }
  bool is_on(Index e, const Point& place) {
    const Span& s = spans_[e];
    return orientation(s.left, s.right, place, tally_) == 0;
  }

  // The line comes to a point, with those vertices.
  void pass(std::span<const Index> vertices) {
    const Point& place = points_[vertices.front()];
    auto lowest = lowest_on(vertices);
    auto beyond = lowest;
    Index through = RingVisitor::none;
    for (; beyond != sweep_.end() && is_on(*beyond, place); ++beyond) {
      if (!(spans_[*beyond].right == place)) {
        through = *beyond;
      }
    }
    const Index below = lowest == sweep_.begin() ? RingVisitor::none : *std::prev(lowest);
    visitor_.pass(RingVisitor::Place{vertices, through, lowest == beyond, below});
    while (lowest != beyond) {
      lowest = spans_[*lowest].right == place ? sweep_.erase(lowest) : std::next(lowest);
    }
    for (const Index vertex : vertices) {
      enter(vertex, place, beyond);
      enter(layout_.previous(vertex), place, beyond);
    }
    meet_neighbours(place, beyond);
  }

  // The lowest edge that has the point, or the one above it.
  Sweep::iterator lowest_on(std::span<const Index> vertices) {
    const Point& place = points_[vertices.front()];
    for (const Index vertex : vertices) {
      for (const Index e : {vertex, layout_.previous(vertex)}) {
        if (spans_[e].right == place) {
          auto lowest = places_[e];
          while (lowest != sweep_.begin() && is_on(*std::prev(lowest), place)) {
            --lowest;
          }
          return lowest;
        }
      }
    }
    return sweep_.lower_bound(place);
  }

  void enter(Index e, const Point& place, Sweep::iterator beyond) {
    if (spans_[e].left == place) {
      places_[e] = sweep_.insert(beyond, e);
    }
  }

  // Those around the place, from the one beyond it down to the one below.
  void meet_neighbours(const Point& place, Sweep::iterator above) {
    bool is_above_on = false;
    while (above != sweep_.begin()) {
      const auto below = std::prev(above);
      const bool is_below_on = is_on(*below, place);
      if (above != sweep_.end() && !(is_above_on && is_below_on)) {
        visitor_.meet(*below, *above);
      }
      if (!is_below_on) {
        return;
      }
      above = below;
      is_above_on = true;
    }
  }

  std::span<const Point> points_;
  const RingLayout& layout_;
  RingVisitor& visitor_;
  Tally& tally_;
  std::vector<Span> spans_;  // of all edges
  Sweep sweep_;
  std::vector<Sweep::iterator> places_;  // of edges that the line meets
};

}  // namespace

void sweep_over(std::span<const Point> points, const RingLayout& layout, RingVisitor& visitor,
                Tally& tally) {
  RingSweep(points, layout, visitor, tally).run();
}

}  // namespace gcv
