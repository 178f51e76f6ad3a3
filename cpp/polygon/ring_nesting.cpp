// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The solid is on the left of all rings. Where two rings touch, each must go through the solid of
// the other: both of its ways out of the point lie strictly inside the cone of the other's solid.
// Then they do not cross there, and neither lies where the other has no solid. Rings that touch,
// directly or by others, form a group. In a group that has the outer ring, all is well then. Of
// each other group, one vertex is located: the lexicographically smallest one, below which the
// group has no edges. Right below it must be an edge with the solid above: of a group whose
// smallest vertex comes before, and which has then been found to lie well. A sweep finds these
// edges.
#include "ring_nesting.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <set>
#include <vector>

#include "box.hpp"
#include "curve_order.hpp"
#include "error.hpp"
#include "overlapping_pairs.hpp"
#include "predicates.hpp"
#include "task.hpp"

namespace gcv {

namespace {

struct Edge {
  Index ring;
  Index number;  // in its ring
};

// Two straight ways through a point, in the direction of a ring.
struct Passage {
  Point from;
  Point place;
  Point to;
};

template <class Value, class Key>
void sort_by(std::vector<Value>& values, Key key) {
  Pace pace;
  std::sort(values.begin(), values.end(), [&](const Value& p, const Value& q) {
    pace.step();
    return key(p) < key(q);
  });
}

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
      : rings_(rings), name_(name), group_(rings.size()) {
    std::iota(group_.begin(), group_.end(), Index{0});
  }

  Tally check() {
    Pace pace;
    for (const Index r : order_for_tree(static_cast<Index>(rings_.size()),
                                        [&](Index ring) { return rings_[ring]->bounds; })) {
      pace.step(2 * std::uint64_t{rings_[r]->size()});
      for (Index i = 0; i < rings_[r]->size(); ++i) {
        edges_.push_back({r, i});
        boxes_.push_back(box_of(from(edges_.back()), to(edges_.back())));
      }
    }
    OverlappingPairs(boxes_).visit_all([&](std::size_t e, std::size_t f) {
      const auto& [first, second] = std::minmax(
          edges_[e], edges_[f], [](const Edge& p, const Edge& q) { return p.ring < q.ring; });
      if (first.ring != second.ring) {
        check_pair(first, second);
      }
    });
    locate_groups();
    return tally_;
  }

 private:
  [[nodiscard]] const Point& from(const Edge& e) const {
    return rings_[e.ring]->vertices[e.number];
  }
  [[nodiscard]] const Point& to(const Edge& e) const {
    return rings_[e.ring]->vertices[rings_[e.ring]->next(e.number)];
  }

  // The caller's numbers of an edge and of one of its ends.
  [[nodiscard]] const Boundary::Corner& corner(const Edge& e) const {
    return rings_[e.ring]->corners[e.number];
  }

  // Edges of two rings, whose boxes overlap.
  void check_pair(const Edge& e, const Edge& f) {
    const int from_side = orientation(from(e), to(e), from(f), tally_);
    const int to_side = orientation(from(e), to(e), to(f), tally_);
    if (from_side * to_side > 0) {
      return;
    }
    const int side_of_from = orientation(from(f), to(f), from(e), tally_);
    const int side_of_to = orientation(from(f), to(f), to(e), tally_);
    if (side_of_from * side_of_to > 0) {
      return;
    }
    if (from_side * to_side < 0 && side_of_from * side_of_to < 0) {
      fail(e, f, "cross");
    }
    // An end of one lies on the line of the other, and on the other itself: its box says so.
    if (from_side == 0) {
      check_touch(e, f, from(f));
    }
    if (to_side == 0) {
      check_touch(e, f, to(f));
    }
    if (side_of_from == 0) {
      check_touch(e, f, from(e));
    }
    if (side_of_to == 0) {
      check_touch(e, f, to(e));
    }
  }

  void check_touch(const Edge& e, const Edge& f, const Point& place) {
    if (!is_in_box(e, place) || !is_in_box(f, place)) {
      return;
    }
    const Passage of_e = passage(e, place);
    const Passage of_f = passage(f, place);
    if (!is_in_solid(of_e, of_f.from) || !is_in_solid(of_e, of_f.to) ||
        !is_in_solid(of_f, of_e.from) || !is_in_solid(of_f, of_e.to)) {
      fail(e, f, "cross, overlap, or touch from the wrong side");
    }
    join(e.ring, f.ring);
  }

  [[nodiscard]] bool is_in_box(const Edge& e, const Point& p) const {
    return !are_apart(box_of(from(e), to(e)), box_of(p, p));
  }

  // How the ring of the edge goes through a point of it.
  [[nodiscard]] Passage passage(const Edge& e, const Point& place) const {
    const Boundary& ring = *rings_[e.ring];
    if (place == from(e)) {
      return {ring.vertices[ring.previous(e.number)], place, to(e)};
    }
    if (place == to(e)) {
      return {from(e), place, ring.vertices[ring.next(ring.next(e.number))]};
    }
    return {from(e), place, to(e)};
  }

  // Does the way from the place to q begin strictly inside the solid on the left of the passage?
  bool is_in_solid(const Passage& passage, const Point& q) {
    const auto& [from, place, to] = passage;
    const int turn = orientation(from, place, to, tally_);
    const int after_out = orientation(place, to, q, tally_);
    if (turn == 0) {
      return after_out > 0;
    }
    const int after_back = orientation(place, from, q, tally_);
    return turn > 0 ? after_out > 0 && after_back < 0 : !(after_back >= 0 && after_out <= 0);
  }

  Index root(Index ring) {
    while (group_[ring] != ring) {
      ring = group_[ring] = group_[group_[ring]];
    }
    return ring;
  }
  // The smaller ring stands for the group.
  void join(Index r, Index s) {
    r = root(r);
    s = root(s);
    group_[std::max(r, s)] = std::min(r, s);
  }

  // A ray downwards from the smallest vertex of a group.
  struct Ray {
    Index ring;
    Point from;
  };

  // An edge that is not upright.
  struct Span {
    Point left;
    Point right;
    Edge edge;
  };

  // Of spans that do not cross and have a part of their extents by x in common, from below; and of
  // a point among them.
  struct FromBelow {
    using is_transparent = void;
    Tally& tally;

    // On which side of p is q?
    [[nodiscard]] int side(const Span& p, const Span& q) const {
      const int of_left = orientation(p.left, p.right, q.left, tally);
      return of_left != 0 ? of_left : orientation(p.left, p.right, q.right, tally);
    }
    bool operator()(const Span* p, const Span* q) const {
      return p->left.x <= q->left.x ? side(*p, *q) > 0 : side(*q, *p) < 0;
    }
    bool operator()(const Span* p, const Point& q) const {
      return orientation(p->left, p->right, q, tally) > 0;
    }
  };
  using Sweep = std::set<const Span*, FromBelow>;

  [[nodiscard]] std::vector<Ray> rays_of_groups() {
    std::vector<Ray> smallest(rings_.size(), Ray{0, {}});
    for (Index r = 0; r < static_cast<Index>(rings_.size()); ++r) {
      const Point& vertex = rings_[r]->vertices.front();
      Ray& ray = smallest[root(r)];
      if (root(r) != 0 && (ray.ring == 0 || lexicographically_less(vertex, ray.from))) {
        ray = {r, vertex};
      }
    }
    smallest.erase(std::remove_if(smallest.begin(), smallest.end(),
                                  [](const Ray& ray) { return ray.ring == 0; }),
                   smallest.end());
    return smallest;
  }

  [[nodiscard]] std::vector<Span> spans_by_left() const {
    std::vector<Span> spans;
    for (const Edge& e : edges_) {
      if (from(e).x != to(e).x) {
        const auto& [left, right] = std::minmax(from(e), to(e), lexicographically_less);
        spans.push_back({left, right, e});
      }
    }
    sort_by(spans, [](const Span& span) { return span.left.x; });
    return spans;
  }

  // Edges hold their left end, and not the right one.
  void locate_groups() {
    std::vector<Ray> rays = rays_of_groups();
    if (rays.empty()) {
      return;
    }
    std::sort(rays.begin(), rays.end(),
              [](const Ray& r, const Ray& s) { return lexicographically_less(r.from, s.from); });
    const std::vector<Span> spans = spans_by_left();
    std::vector<std::size_t> by_right(spans.size());
    std::iota(by_right.begin(), by_right.end(), std::size_t{0});
    sort_by(by_right, [&](std::size_t k) { return spans[k].right.x; });
    Sweep sweep(FromBelow{tally_});
    std::vector<Sweep::iterator> places(spans.size(), sweep.end());
    auto ending = by_right.begin();
    std::size_t begun = 0;
    Pace pace;
    for (const Ray& ray : rays) {
      pace.step(16);
      for (; ending != by_right.end() && spans[*ending].right.x <= ray.from.x; ++ending) {
        if (places[*ending] != sweep.end()) {
          sweep.erase(places[*ending]);
        }
      }
      for (; begun < spans.size() && spans[begun].left.x <= ray.from.x; ++begun) {
        if (ray.from.x < spans[begun].right.x) {
          places[begun] = sweep.insert(&spans[begun]).first;
        }
      }
      check_below(ray, sweep);
    }
  }

  void check_below(const Ray& ray, const Sweep& sweep) {
    const auto above = sweep.lower_bound(ray.from);
    if (above == sweep.begin()) {
      fail_at(ray, "outside", 0);
    }
    const Edge& below = (*std::prev(above))->edge;
    if (from(below).x > to(below).x) {
      fail_at(ray, below.ring == 0 ? "outside" : "inside", below.ring);
    }
  }

  [[noreturn]] void fail(const Edge& e, const Edge& f, const char* what) const {
    const Boundary::Corner& p = corner(e);
    const Boundary::Corner& q = corner(f);
    throw Error(Status::not_simple,
                "%s: rings %u and %u %s: edges %u and %u meet; they have an end in vertex %u "
                "(%.17g, %.17g) and in vertex %u (%.17g, %.17g)",
                name_, e.ring, f.ring, what, p.edge_number, q.edge_number, p.vertex_number,
                from(e).x, from(e).y, q.vertex_number, from(f).x, from(f).y);
  }

  [[noreturn]] void fail_at(const Ray& ray, const char* where, Index ring) const {
    fail_outside(name_, ray.ring, where, ring, corner({ray.ring, 0}), ray.from);
  }

  std::span<const Boundary* const> rings_;
  const char* name_;
  std::vector<Edge> edges_;
  std::vector<Box> boxes_;
  std::vector<Index> group_;  // of each ring, another one of its group, or itself
  Tally tally_;
};

}  // namespace

Tally check_nesting(std::span<const Boundary* const> rings, const char* name) {
  return rings.size() > 1 ? Nesting(rings, name).check() : Tally{};
}

}  // namespace gcv
