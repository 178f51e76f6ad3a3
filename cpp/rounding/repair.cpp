// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The method. Take two exact edges that do not meet, and let their rounded counterparts meet. Then
// an end of one has changed sides of the line of the other: the sign of an orientation is lost. The
// repair restores each such sign. It moves the end and the line apart, along the normal of the
// line. That can move them onto others, so it takes several rounds. Or exact edges of two
// rings touch: then an end of one that lies on the line of the other has come to lie beyond it.
#include "repair.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "cycle.hpp"
#include "predicates.hpp"
#include "ring_conflicts.hpp"
#include "ring_predicates.hpp"
#include "simplicity.hpp"
#include "units.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

constexpr int rounds = 16;
constexpr double furthest_move = 6;  // the units in the last place that a vertex may move

class Separator {
 public:
  Separator(const ExactRing& exact, std::span<const RingRange> rings, const PointVector& nearest,
            Tally& tally)
      : exact_(exact),
        ranges_(rings),
        nearest_(nearest),
        largest_units_(units_in_last_place(nearest)),
        places_(nearest),
        moves_(nearest.size(), Point{0, 0}),
        tally_(tally) {}

  std::optional<PointVector> run() {
    for (int round = 0; round < rounds; ++round) {
      if (!snap_all()) {
        return std::nullopt;
      }
      const std::vector<RingConflict> conflicts = find_ring_conflicts(rings_);
      if (conflicts.empty()) {
        return are_turned_right() ? std::optional(places_) : std::nullopt;
      }
      demands_.assign(places_.size(), {0, 0});
      for (const auto& [first, second] : conflicts) {
        restore_sides(first, second);
        restore_sides(second, first);
      }
      for (std::size_t r = 0; r < rings_.size(); ++r) {
        if (!ranges_[r].is_fixed) {
          move(r);
        }
      }
    }
    return std::nullopt;
  }

 private:
  // False where less than three vertices are left of a ring.
  bool snap_all() {
    rings_.resize(ranges_.size());
    sources_.resize(ranges_.size());
    for (std::size_t r = 0; r < ranges_.size(); ++r) {
      SnappedRing ring = snap(std::span(places_).subspan(ranges_[r].first, ranges_[r].size));
      rings_[r] = std::move(ring.vertices);
      sources_[r] = std::move(ring.source);
      if (rings_[r].size() < 3) {
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] bool are_turned_right() const {
    for (std::size_t r = 0; r < ranges_.size(); ++r) {
      if (is_counter_clockwise(rings_[r]) != ranges_[r].is_counter_clockwise) {
        return false;
      }
    }
    return true;
  }

  // Vertices and edges of rings have the same numbers.
  [[nodiscard]] RingEdge next(const RingEdge& k) const {
    return {k.ring, cyclic_next(k.edge, rings_[k.ring].size())};
  }
  [[nodiscard]] const Point& vertex(const RingEdge& k) const { return rings_[k.ring][k.edge]; }
  // The exact vertex that it stands for.
  [[nodiscard]] std::size_t source(const RingEdge& k) const {
    return ranges_[k.ring].first + sources_[k.ring][k.edge];
  }

  // Moves the ends of edge f back to their sides of the line of edge e.
  void restore_sides(const RingEdge& e, const RingEdge& f) {
    const auto is_end_of_e = [&](const RingEdge& end) {
      return end.ring == e.ring && (end.edge == e.edge || end.edge == next(e).edge);
    };
    for (const RingEdge& end : {f, next(f)}) {
      if (!is_end_of_e(end)) {
        restore_side(e, end);
      }
    }
  }

  void restore_side(const RingEdge& e, const RingEdge& end) {
    const Point& p = vertex(e);
    const Point& q = vertex(next(e));
    const int exact = exact_side(exact_, source(e), source(end), tally_);
    const int wanted = exact != 0 ? exact : side_of_neighbours(e, end);
    const int side = orientation(p, q, vertex(end), tally_);
    if (wanted == 0 || side == wanted || side == exact) {
      return;
    }
    // The unit normal of the line, to the wanted side. Scaled first, so that nothing overflows or
    // underflows.
    const Point d = direction(p, q);
    const double size = std::max(std::abs(d.x), std::abs(d.y));
    const double dx = d.x / size;
    const double dy = d.y / size;
    const double length = std::sqrt(dx * dx + dy * dy);
    const Point normal{-wanted * dy / length, wanted * dx / length};
    demand(end, normal, 1);
    demand(e, normal, -1);
    demand(next(e), normal, -1);
  }

  // The side of the line of edge e that the edges at a vertex on it are on, if that is a vertex of
  // another ring. Else 0.
  [[nodiscard]] int side_of_neighbours(const RingEdge& e, const RingEdge& vertex) const {
    if (vertex.ring == e.ring) {
      return 0;
    }
    const RingEdge before{vertex.ring, cyclic_previous(vertex.edge, rings_[vertex.ring].size())};
    const int side = exact_side(exact_, source(e), source(before), tally_);
    const int other = exact_side(exact_, source(e), source(next(vertex)), tally_);
    return side == 0 || side == other ? other : other == 0 ? side : 0;
  }

  void demand(const RingEdge& k, const Point& normal, double factor) {
    Point& sum = demands_[source(k)];
    sum = {sum.x + factor * normal.x, sum.y + factor * normal.y};
  }

  // Moves each vertex by one unit in the last place in the direction demanded of it. Vertices that
  // were rounded to one point move together.
  void move(std::size_t ring) {
    const auto& [begin, size, is_counter_clockwise, is_fixed] = ranges_[ring];
    std::size_t k = begin;
    for (const std::size_t last : sources_[ring]) {
      const Point& sum = demands_[begin + last];
      const double length = std::sqrt(sum.x * sum.x + sum.y * sum.y);
      for (; k <= begin + last; ++k) {
        shift(k, sum, length);
      }
    }
    const Point& first = demands_[begin + sources_[ring].front()];
    for (; k < begin + size; ++k) {  // vertices that were rounded to the same point as the first
      shift(k, first, std::sqrt(first.x * first.x + first.y * first.y));
    }
  }

  void shift(std::size_t k, const Point& demand, double length) {
    if (length < 0.125) {
      return;
    }
    Point& move = moves_[k];
    move = {move.x + demand.x / length, move.y + demand.y / length};
    const double distance = std::sqrt(move.x * move.x + move.y * move.y);
    if (distance > furthest_move) {
      move = {move.x * (furthest_move / distance), move.y * (furthest_move / distance)};
    }
    const Point& p = nearest_[k];
    const double unit = std::max(unit_in_last_place(p.x), unit_in_last_place(p.y));
    const Point place{p.x + move.x * std::min(unit, largest_units_.x),
                      p.y + move.y * std::min(unit, largest_units_.y)};
    if (std::isfinite(place.x) && std::isfinite(place.y)) {
      places_[k] = place;
    }
  }

  const ExactRing& exact_;
  std::span<const RingRange> ranges_;
  const PointVector& nearest_;
  Point largest_units_;
  PointVector places_;
  PointVector moves_;  // in units in the last place
  PointVector demands_;
  std::vector<PointVector> rings_;
  std::vector<std::vector<std::size_t>> sources_;  // of their vertices, in their ranges
  Tally& tally_;
};

}  // namespace

SnappedRing snap(std::span<const Point> places) {
  SnappedRing ring;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!(places[k] == places[cyclic_next(k, places.size())])) {
      ring.vertices.push_back(places[k]);
      ring.source.push_back(k);
    }
  }
  return ring;
}

std::optional<PointVector> separate(const ExactRing& ring, std::span<const RingRange> rings,
                                    const PointVector& nearest, Tally& tally) {
  assert(nearest.size() == ring.size());
  return Separator(ring, rings, nearest, tally).run();
}

}  // namespace gcv
