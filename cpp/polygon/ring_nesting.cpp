// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The solid is on the left of all rings. Where two rings touch, each must go through the solid of
// the other: both of its ways out of the point lie strictly inside the cone of the other's solid.
// Then they do not cross there, and neither lies where the other has no solid. A line sweeps over
// the vertices in lexicographic order, as in simplicity.cpp. It keeps the edges that it meets in
// order, from bottom to top, and tests edges that become neighbours: two that cross do so before
// the line comes to their crossing. At each vertex it looks at the ways of all rings through that
// point. Holes that begin there, in their smallest vertices, and touch none that has begun before,
// are located: right below must be an edge with the solid above. Edges further left have been found
// to lie well by then.
#include "ring_nesting.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "error.hpp"
#include "predicates.hpp"
#include "task.hpp"

namespace gcv {

namespace {

struct Edge {
  Index ring;
  Index number;  // in its ring
};

// How a ring goes through a point: in a vertex, or along an edge.
struct Passage {
  Edge edge;  // one that has the point
  Point from;
  Point to;
};

// A way out of a point: back along a passage, or on.
struct WayOut {
  Point to;
  std::size_t passage;
  bool is_back;
};

// An edge from its lexicographically smaller end on.
struct Span {
  Point left;
  Point right;
  Edge edge;
  bool goes_right;  // as the ring does: then the solid is above
};

// A hole that lies where it may not. Its message names an edge, and an end of that.
[[noreturn]] void fail_outside(const char* name, Index hole, const char* where, Index ring,
                               const Boundary::Corner& p, const Point& end) {
  throw Error(
      Status::not_simple,
      "%s: ring %u, a hole, lies %s ring %u: edge %u has an end in vertex %u (%.17g, %.17g)", name,
      hole, where, ring, p.edge_number, p.vertex_number, end.x, end.y);
}

class Nesting {
 public:
  Nesting(std::span<const Boundary* const> rings, const char* name)
      : rings_(rings), name_(name), sweep_(FromBelow{tally_}) {}

  Tally check() {
    Pace pace;
    std::size_t size = 0;
    for (const Boundary* ring : rings_) {
      first_.push_back(size);
      size += ring->size();
    }
    vertices_.reserve(size);
    spans_.resize(size);
    places_.resize(size);
    for (Index r = 0; r < static_cast<Index>(rings_.size()); ++r) {
      for (Index i = 0; i < rings_[r]->size(); ++i) {
        add({r, i});
      }
    }
    std::sort(vertices_.begin(), vertices_.end(), [&](const Edge& p, const Edge& q) {
      pace.step();
      return lexicographically_less(from(p), from(q));
    });
    for (std::size_t k = 0; k < size;) {
      std::size_t end = k + 1;
      while (end < size && from(vertices_[end]) == from(vertices_[k])) {
        ++end;
      }
      pace.step(16 * (end - k));
      pass(std::span(vertices_).subspan(k, end - k));
      k = end;
    }
    if (misplaced_) {
      const auto [hole, ring] = *misplaced_;
      const Edge vertex{hole, 0};
      fail_outside(name_, hole, ring == 0 ? "outside" : "inside", ring, corner(vertex),
                   from(vertex));
    }
    return tally_;
  }

 private:
  // Of spans that do not cross and are met by one line, from below; and of a point among them.
  struct FromBelow {
    using is_transparent = void;
    Tally& tally;

    // On which side of p is q?
    [[nodiscard]] int side(const Span& p, const Span& q) const {
      const int of_left = orientation(p.left, p.right, q.left, tally);
      return of_left != 0 ? of_left : orientation(p.left, p.right, q.right, tally);
    }
    bool operator()(const Span* p, const Span* q) const {
      return lexicographically_less(q->left, p->left) ? side(*q, *p) < 0 : side(*p, *q) > 0;
    }
    bool operator()(const Span* p, const Point& q) const {
      return orientation(p->left, p->right, q, tally) > 0;
    }
  };
  using Sweep = std::set<const Span*, FromBelow>;

  [[nodiscard]] const Point& from(const Edge& e) const {
    return rings_[e.ring]->vertices[e.number];
  }
  [[nodiscard]] const Point& to(const Edge& e) const {
    return rings_[e.ring]->vertices[rings_[e.ring]->next(e.number)];
  }
  // The edge before, on the same ring.
  [[nodiscard]] Edge before(const Edge& e) const {
    return {e.ring, rings_[e.ring]->previous(e.number)};
  }
  // The caller's numbers of an edge and of one of its ends.
  [[nodiscard]] const Boundary::Corner& corner(const Edge& e) const {
    return rings_[e.ring]->corners[e.number];
  }
  [[nodiscard]] std::size_t number(const Edge& e) const { return first_[e.ring] + e.number; }

  void add(const Edge& e) {
    vertices_.push_back(e);
    const bool goes_right = lexicographically_less(from(e), to(e));
    spans_[number(e)] = goes_right ? Span{from(e), to(e), e, true} : Span{to(e), from(e), e, false};
  }

  // The line comes to a point, with those vertices.
  void pass(std::span<const Edge> vertices) {
    const Point& place = from(vertices.front());
    Sweep::iterator lowest = lowest_on(vertices);
    passages_.clear();
    for (const Edge& e : vertices) {
      passages_.push_back({e, from(before(e)), to(e)});
    }
    auto beyond = lowest;
    for (; beyond != sweep_.end() && is_on(**beyond, place); ++beyond) {
      if (!((*beyond)->right == place)) {
        const Edge& e = (*beyond)->edge;
        passages_.push_back({e, from(e), to(e)});
      }
    }
    if (passages_.size() > 1) {
      check_passages(place);
    }
    const bool all_begin = std::all_of(vertices.begin(), vertices.end(), [](const Edge& vertex) {
      return vertex.number == 0 && vertex.ring != 0;
    });
    if (lowest == beyond && all_begin) {
      check_below(vertices.front().ring, lowest);
    }
    while (lowest != beyond) {
      lowest = (*lowest)->right == place ? sweep_.erase(lowest) : std::next(lowest);
    }
    for (const Edge& e : vertices) {
      enter(e, place, beyond);
      enter(before(e), place, beyond);
    }
    check_neighbours(place, beyond);
  }

  // The lowest span that has the point, or the one above it.
  Sweep::iterator lowest_on(std::span<const Edge> vertices) {
    const Point& place = from(vertices.front());
    for (const Edge& vertex : vertices) {
      for (const Edge& e : {vertex, before(vertex)}) {
        if (spans_[number(e)].right == place) {
          Sweep::iterator lowest = places_[number(e)];
          while (lowest != sweep_.begin() && is_on(**std::prev(lowest), place)) {
            --lowest;
          }
          return lowest;
        }
      }
    }
    return sweep_.lower_bound(place);
  }

  bool is_on(const Span& span, const Point& place) {
    return orientation(span.left, span.right, place, tally_) == 0;
  }

  void enter(const Edge& e, const Point& place, Sweep::iterator beyond) {
    const Span& span = spans_[number(e)];
    if (span.left == place) {
      places_[number(e)] = sweep_.insert(beyond, &span);
    }
  }

  // Those around the place, from the one beyond it down to the one below. Two that have the place
  // in common do not cross.
  void check_neighbours(const Point& place, Sweep::iterator above) {
    bool is_above_on = false;
    while (above != sweep_.begin()) {
      const auto below = std::prev(above);
      const bool is_below_on = is_on(**below, place);
      if (above != sweep_.end() && !(is_above_on && is_below_on)) {
        check_pair((*below)->edge, (*above)->edge);
      }
      if (!is_below_on) {
        return;
      }
      above = below;
      is_above_on = true;
    }
  }

  // Do the edges of two rings cross between their ends?
  void check_pair(const Edge& e, const Edge& f) {
    if (e.ring == f.ring) {
      return;
    }
    const auto is_crossed = [&](const Edge& p, const Edge& q) {
      return orientation(from(p), to(p), from(q), tally_) *
                 orientation(from(p), to(p), to(q), tally_) <
             0;
    };
    if (is_crossed(e, f) && is_crossed(f, e)) {
      fail(e, f, "cross");
    }
  }

  // Goes round the place, counter-clockwise. Between the way back of a passage and its way on there
  // is no solid, and so no way of another passage.
  void check_passages(const Point& place) {
    ways_.clear();
    for (std::size_t k = 0; k < passages_.size(); ++k) {
      ways_.push_back({passages_[k].from, k, true});
      ways_.push_back({passages_[k].to, k, false});
    }
    const auto turn = [&](const WayOut& p, const WayOut& q) {
      return orientation(place, p.to, q.to, tally_);
    };
    const auto is_left = [&](const WayOut& p) { return lexicographically_less(p.to, place); };
    std::sort(ways_.begin(), ways_.end(), [&](const WayOut& p, const WayOut& q) {
      return is_left(p) != is_left(q) ? is_left(q) : turn(p, q) > 0;
    });
    for (std::size_t k = 0; k < ways_.size(); ++k) {
      const WayOut& way = ways_[k];
      const WayOut& next = ways_[k + 1 < ways_.size() ? k + 1 : 0];
      const bool are_one = is_left(way) == is_left(next) && turn(way, next) == 0;
      if (way.passage != next.passage && (are_one || way.is_back || !next.is_back)) {
        fail(passages_[way.passage].edge, passages_[next.passage].edge,
             "cross, overlap, or touch from the wrong side");
      }
    }
  }

  // A hole begins. That rings cross would be said first.
  void check_below(Index hole, Sweep::iterator above) {
    const bool is_lowest = above == sweep_.begin();
    if (!misplaced_ && (is_lowest || !(*std::prev(above))->goes_right)) {
      misplaced_ = {hole, is_lowest ? 0 : (*std::prev(above))->edge.ring};
    }
  }

  [[noreturn]] void fail(Edge e, Edge f, const char* what) const {
    if (e.ring > f.ring) {
      std::swap(e, f);
    }
    const Boundary::Corner& p = corner(e);
    const Boundary::Corner& q = corner(f);
    throw Error(Status::not_simple,
                "%s: rings %u and %u %s: edges %u and %u meet; they have an end in vertex %u "
                "(%.17g, %.17g) and in vertex %u (%.17g, %.17g)",
                name_, e.ring, f.ring, what, p.edge_number, q.edge_number, p.vertex_number,
                from(e).x, from(e).y, q.vertex_number, from(f).x, from(f).y);
  }

  std::span<const Boundary* const> rings_;
  const char* name_;
  Tally tally_;
  std::vector<std::size_t> first_;  // of all edges, that of each ring
  std::vector<Edge> vertices_;      // as the edges behind them, in lexicographic order
  std::vector<Span> spans_;         // of all edges
  Sweep sweep_;
  std::vector<Sweep::iterator> places_;  // of spans that the line meets
  std::vector<Passage> passages_;        // through a point
  std::vector<WayOut> ways_;             // of these
  struct Misplaced {
    Index hole;
    Index ring;  // that it should not be in, or the outer one, which it should be in
  };
  std::optional<Misplaced> misplaced_;  // the first one
};

}  // namespace

Tally check_nesting(std::span<const Boundary* const> rings, const char* name) {
  return rings.size() > 1 ? Nesting(rings, name).check() : Tally{};
}

}  // namespace gcv
