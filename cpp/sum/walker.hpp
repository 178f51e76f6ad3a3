// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A walk along the boundary of one face of the complement of the sum (the paper, section 4.3, way
// 1), with the free side on its right: counter-clockwise along the outer face, clockwise round a
// hole. Every decision is exact.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "error.hpp"
#include "predicates.hpp"
#include "step.hpp"
#include "task.hpp"
#include "walk.hpp"

namespace gcv {

// How much of both boundaries an arc has passed, in vertices: all of its arcs pass all of them.
class Extent {
 public:
  Extent(const Operands& operands, const VertexSum& first, const VertexSum& last)
      : a_(operands.a.size(), first.i, last.i), b_(operands.b.size(), first.j, last.j) {
    if (first == last) {
      a_.length = operands.a.size();
      b_.length = operands.b.size();
    }
  }

  // The vertices that are passed up to an edge, but for those before. Ways back do not count.
  std::uint64_t pass(const EdgeName& edge) { return pass(a_.to(edge.i) + b_.to(edge.j)); }
  // The others.
  std::uint64_t finish() { return pass(a_.length + b_.length); }

 private:
  // A part of a ring.
  struct Part {
    Part(std::uint64_t ring_size, Index from, Index to)
        : size(ring_size), begin(from), length((to + ring_size - from) % ring_size) {}

    // How far a vertex lies along it. What lies before the part, or behind, is taken to its ends.
    [[nodiscard]] std::uint64_t to(Index vertex) const {
      const std::uint64_t along = (vertex + size - begin) % size;
      return along <= length ? along : along - length < size - along ? length : 0;
    }

    std::uint64_t size;
    std::uint64_t begin;
    std::uint64_t length;
  };

  std::uint64_t pass(std::uint64_t total) {
    const std::uint64_t more = total > passed_ ? total - passed_ : 0;
    passed_ += more;
    return more;
  }

  Part a_;
  Part b_;
  std::uint64_t passed_ = 0;
};

// Search finds superset edges:
//   turn, way: as for Step;
//   edges_from(i, j): the two that start in a vertex of the hull of the sum;
//   only_way_on(): the edge that goes on from the end of that on which the walk is, where no others
//     come near, or else none; the walk takes it. Only searches without ranks know one;
//   continued(e, place): where other edges of its direction lead on to, without a gap, if that is
//     worth knowing: the walk goes straight on there, along e;
//   find(step): gives the step the edges that have a point in common with its stretch;
//   follow(e): of those, the walk takes e.
template <class Search>
class Walker {
 public:
  Walker(const Operands& operands, Search search, double slack, Task& task)
      : operands_(operands),
        search_(std::move(search)),
        task_(task),
        step_(operands, search_, place_, slack, tally_) {}
  Walker(const Walker&) = delete;
  Walker& operator=(const Walker&) = delete;

  // The boundary from one vertex of the hull of the sum to the next. No superset edge passes
  // through such a vertex: the walk leaves it along one that starts there, and arrives by the end
  // of another. The first vertex has no arriving edge yet: it is that of the walk that ends there.
  Arc arc(const VertexSum& first, const VertexSum& last) {
    const std::size_t vertices = std::size_t{operands_.a.size()} + operands_.b.size();
    walk_.vertices.reserve(std::min<std::size_t>(vertices + vertices / 4, 4096));
    place_ = Place::of(first);
    next_ = first_edge(first);
    last_ = last;
    extent_.emplace(operands_, first, last);
    EdgeName arriving = next_;
    do {
      if (turns_) {
        add_vertex(arriving);
      }
      arriving = next_;
      turns_ = advance();
    } while (!(place_.is_sum && place_.sum == last));
    return {finished(), arriving, tally_};
  }

  // A ring, or nothing where it is known, and the place where it leaves the edge that the walk
  // began on.
  struct Ring {
    std::optional<Walk> walk;
    Place leaves;
  };

  // The ring that bounds the face on the right of the edge at the place. The edge is a superset
  // edge through the place, and on the boundary from there on. The place is a sum of two vertices,
  // or else the crossing with any edge that is not parallel, not only a superset edge. The ring
  // begins in its first vertex behind the place. It is known where is_known(that vertex).
  //
  // It ends where the first turn comes again, between the same two lines. Of edges that overlap,
  // the walk may take others the second time.
  template <class IsKnown>
  Ring ring(const Place& place, const PairEdge& edge, IsKnown is_known) {
    walk_ = {};
    place_ = place;
    next_ = edge;
    turns_ = true;
    turns_ = advance();
    Ring ring{{}, place_};
    if (!place_.is_sum) {  // seen from the edge that the walk began on
      const PairEdge leaving = next_;
      const auto at = [&](const PairEdge& e) { return coordinates(operands_.a, operands_.b, e); };
      ring.leaves = {false, {}, leaving, crossing_parameter(at(edge), at(leaving))};
    }
    PairEdge arriving = edge;
    while (!turns_) {
      arriving = next_;
      turns_ = advance();
    }
    const PairEdge first_arriving = arriving;
    const PairEdge first_leaving = next_;
    add_vertex(arriving);
    if (is_known(walk_.vertices.front())) {
      return ring;
    }
    while (true) {
      arriving = next_;
      turns_ = advance();
      if (!turns_) {
        continue;
      }
      if (leads_along(arriving, first_arriving) && leads_along(next_, first_leaving)) {
        ring.walk = finished();
        return ring;
      }
      add_vertex(arriving);
    }
  }
  [[nodiscard]] const Tally& tally() const { return tally_; }

 private:
  Walk finished() {
    task_.advance(walk_.steps % Task::portion, extent_ ? extent_->finish() : 0);
    walk_.candidates += step_.candidates();
    return std::move(walk_);
  }

  // Are both edges on one line, in the same direction?
  bool leads_along(const PairEdge& e, const PairEdge& f) {
    const SumEdge line = coordinates(operands_.a, operands_.b, f);
    return search_.turn(e, f, tally_) == 0 && search_.way(e, f, tally_) != Way::back &&
           side(line, operands_.start(e), tally_) == 0;
  }

  void add_vertex(const EdgeName& arriving) {
    walk_.vertices.push_back(place_.is_sum
                                 ? RingVertex::sum(place_.sum.i, place_.sum.j, arriving, next_)
                                 : RingVertex::crossing(arriving, next_));
  }

  // Goes along the next edge to where the boundary leaves it. Does it turn there?
  bool advance() {
    count_step();
    if (const auto successor = search_.only_way_on()) {
      ++walk_.candidates;
      place_.become(start_of(successor->edge));
      static_cast<EdgeName&>(next_) = successor->edge;  // it has no rank
      return !successor->is_straight;
    }
    step_.set_out(next_);
    if (!turns_) {
      if (const auto further = search_.continued(next_, place_.sum)) {
        step_.go_to(further->end, further->length);
      }
    }
    search_.find(step_);
    const PairEdge s = next_;
    if (const std::optional<Event>& event = step_.event()) {
      next_ = event->line.edge;
      place_ = event->place;
      if (!place_.is_sum) {  // from now on, seen from the next edge
        place_.crossing = s;
        place_.parameter = crossing_parameter(event->line.at, step_.line().at);
      }
    } else {
      place_.become(step_.end());
      if (step_.onwards()) {
        next_ = *step_.onwards();
      } else if (!(place_.sum == last_)) {  // which no edge need pass through
        throw Error(Status::internal,
                    "no superset edge leads on from vertex %u of a + vertex %u of b",
                    operands_.a.corners[place_.sum.i].vertex_number,
                    operands_.b.corners[place_.sum.j].vertex_number);
      }
    }
    search_.follow(next_);
    return search_.turn(s, next_, tally_) != 0;
  }

  // Of the two superset edges that start in a vertex of the hull, the more clockwise one.
  PairEdge first_edge(const VertexSum& start) {
    const auto [e, f] = search_.edges_from(start.i, start.j);
    const int turn = search_.turn(e, f, tally_);
    const bool is_first =
        turn == 0 ? step_.is_preferred(Line::of(operands_, e), Line::of(operands_, f)) : turn > 0;
    return is_first ? e : f;
  }

  // One face of an arrangement of N segments has almost N edges at most, up to a factor that no
  // real N brings above 64. A walk beyond that has lost its way.
  void count_step() {
    if (++walk_.steps % Task::portion != 0) {
      return;
    }
    task_.advance(Task::portion, extent_ ? extent_->pass(next_) : 0);
    const double segments = 2.0 * operands_.a.size() * operands_.b.size();
    if (static_cast<double>(walk_.steps) > 64 * segments) {
      throw Error(Status::internal, "the walk along the outer face does not end");
    }
  }

  static constexpr Index no_vertex = 0xffffffff;

  const Operands& operands_;
  Search search_;
  Task& task_;
  Tally tally_;
  Place place_{};  // where the walk is
  Step<Search> step_;
  Walk walk_;
  PairEdge next_{};    // the edge that it leaves the place by
  bool turns_ = true;  // does the boundary turn in the place?
  VertexSum last_{no_vertex, no_vertex};
  std::optional<Extent> extent_;  // of an arc
};

}  // namespace gcv
