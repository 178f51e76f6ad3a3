// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The solid is on the left of all rings. Where two rings touch, each must go through the solid of
// the other: both of its ways out of the point lie strictly inside the cone of the other's solid.
// Then they do not cross there, and neither lies where the other has no solid. A sweep tests edges
// that become neighbours, and in each vertex the ways of all rings through that point. Holes that
// begin there, in their smallest vertices, and touch none that has begun before, are located: right
// below must be an edge with the solid above. Edges further left have been found to lie well by
// then.
#include "ring_nesting.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "error.hpp"
#include "predicates.hpp"
#include "ring_sweep.hpp"

namespace gcv {

namespace {

// How a ring goes through a point: in a vertex, or along an edge.
struct Passage {
  Index edge;  // one that has the point
  Point from;
  Point to;
};

// A way out of a point: back along a passage, or on.
struct WayOut {
  Point to;
  std::size_t passage;
  bool is_back;
};

// A hole that lies where it may not. Its message names an edge, and an end of that.
[[noreturn]] void fail_outside(const char* name, Index hole, const char* where, Index ring,
                               const Boundary::Corner& p, const Point& end) {
  throw Error(
      Status::not_simple,
      "%s: ring %u, a hole, lies %s ring %u: edge %u has an end in vertex %u (%.17g, %.17g)", name,
      hole, where, ring, p.edge_number, p.vertex_number, end.x, end.y);
}

class Nesting : public RingVisitor {
 public:
  Nesting(std::span<const Boundary* const> rings, const char* name)
      : rings_(rings), name_(name), layout_(rings.front()->size()) {
    for (const Boundary* ring : rings) {
      points_.insert(points_.end(), ring->vertices.begin(), ring->vertices.end());
      if (ring != rings.front()) {
        layout_.add(ring->size());
      }
    }
  }

  Tally check() {
    sweep_over(points_, layout_, *this, tally_);
    if (misplaced_) {
      const Index vertex = layout_.begin(misplaced_->hole);
      fail_outside(name_, misplaced_->hole, misplaced_->ring == 0 ? "outside" : "inside",
                   misplaced_->ring, corner(vertex), points_[vertex]);
    }
    return tally_;
  }

 private:
  [[nodiscard]] Index ring(Index edge) const { return layout_.ring_of(edge); }
  [[nodiscard]] const Point& from(Index edge) const { return points_[edge]; }
  [[nodiscard]] const Point& to(Index edge) const { return points_[layout_.next(edge)]; }
  // The caller's numbers of an edge and of one of its ends.
  [[nodiscard]] const Boundary::Corner& corner(Index edge) const {
    return rings_[ring(edge)]->corners[edge - layout_.begin(ring(edge))];
  }
  // Is it the first vertex of a hole?
  [[nodiscard]] bool begins(Index vertex) const { return layout_.starts_another(vertex); }

  void pass(const Place& at) override {
    const Index first = at.vertices.front();
    if (at.vertices.size() > 1 || at.through != none) {
      passages_.clear();
      for (const Index vertex : at.vertices) {
        passages_.push_back({vertex, points_[layout_.previous(vertex)], to(vertex)});
      }
      if (at.through != none) {
        passages_.push_back({at.through, from(at.through), to(at.through)});
      }
      check_passages(points_[first]);
    }
    if (at.is_first && std::all_of(at.vertices.begin(), at.vertices.end(),
                                   [&](Index vertex) { return begins(vertex); })) {
      check_below(ring(first), at.below);
    }
  }

  // Do the edges of two rings cross between their ends?
  void meet(Index e, Index f) override {
    if (ring(e) == ring(f)) {
      return;
    }
    const auto is_crossed = [&](Index p, Index q) {
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
  void check_below(Index hole, Index below) {
    const bool is_in_solid = below != none && lexicographically_less(from(below), to(below));
    if (!misplaced_ && !is_in_solid) {
      misplaced_ = {hole, below == none ? 0 : ring(below)};
    }
  }

  [[noreturn]] void fail(Index e, Index f, const char* what) const {
    if (ring(e) > ring(f)) {
      std::swap(e, f);
    }
    const Boundary::Corner& p = corner(e);
    const Boundary::Corner& q = corner(f);
    throw Error(Status::not_simple,
                "%s: rings %u and %u %s: edges %u and %u meet; they have an end in vertex %u "
                "(%.17g, %.17g) and in vertex %u (%.17g, %.17g)",
                name_, ring(e), ring(f), what, p.edge_number, q.edge_number, p.vertex_number,
                from(e).x, from(e).y, q.vertex_number, from(f).x, from(f).y);
  }

  std::span<const Boundary* const> rings_;
  const char* name_;
  PointVector points_;  // of all rings
  RingLayout layout_;
  Tally tally_;
  std::vector<Passage> passages_;  // through a point
  std::vector<WayOut> ways_;       // of these
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
