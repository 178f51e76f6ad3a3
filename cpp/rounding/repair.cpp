// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The method. Take two exact edges that do not meet, and let their rounded counterparts meet. Then
// an end of one has changed sides of the line of the other: the sign of an orientation is lost. The
// repair restores each such sign. It moves the end and the line apart, along the normal of the
// line. That can move them onto others, so it takes several rounds.
#include "repair.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "cycle.hpp"
#include "predicates.hpp"
#include "ring_predicates.hpp"
#include "simplicity.hpp"
#include "units.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

constexpr int rounds = 16;
constexpr double furthest = 6;  // the units in the last place that a vertex may move

class Separator {
 public:
  Separator(const ExactRing& exact, const PointVector& nearest, Tally& tally)
      : exact_(exact),
        nearest_(nearest),
        largest_units_(units_in_last_place(nearest)),
        places_(nearest),
        moves_(nearest.size(), Point{0, 0}),
        tally_(tally) {}

  std::optional<PointVector> run() {
    for (int round = 0; round < rounds; ++round) {
      ring_ = snap(places_);
      if (ring_.vertices.size() < 3) {
        return std::nullopt;
      }
      const std::vector<Conflict> conflicts = find_all_conflicts(ring_.vertices);
      if (conflicts.empty()) {
        return is_counter_clockwise(ring_.vertices) ? std::optional(places_) : std::nullopt;
      }
      demands_.assign(places_.size(), {0, 0});
      for (const Conflict& conflict : conflicts) {
        restore_sides(conflict.first, conflict.second);
        restore_sides(conflict.second, conflict.first);
      }
      move();
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] std::size_t next(std::size_t k) const {
    return cyclic_next(k, ring_.vertices.size());
  }

  // Moves the ends of edge f back to their sides of the line of edge e.
  void restore_sides(std::size_t e, std::size_t f) {
    for (const std::size_t end : {f, next(f)}) {
      if (end != e && end != next(e)) {
        restore_side(e, end);
      }
    }
  }

  void restore_side(std::size_t e, std::size_t end) {
    const Point& p = ring_.vertices[e];
    const Point& q = ring_.vertices[next(e)];
    const int wanted = exact_side(exact_, ring_.source[e], ring_.source[end], tally_);
    if (wanted == 0 || orientation(p, q, ring_.vertices[end], tally_) == wanted) {
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

  void demand(std::size_t k, const Point& normal, double factor) {
    Point& sum = demands_[ring_.source[k]];
    sum = {sum.x + factor * normal.x, sum.y + factor * normal.y};
  }

  // Moves each vertex by one unit in the last place in the direction demanded of it. Vertices that
  // were rounded to one point move together.
  void move() {
    std::size_t k = 0;
    for (const std::size_t last : ring_.source) {
      const Point& sum = demands_[last];
      const double length = std::sqrt(sum.x * sum.x + sum.y * sum.y);
      for (; k <= last; ++k) {
        shift(k, sum, length);
      }
    }
    const Point& first = demands_[ring_.source.front()];
    for (; k < places_.size(); ++k) {  // vertices that were rounded to the same point as vertex 0
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
    if (distance > furthest) {
      move = {move.x * (furthest / distance), move.y * (furthest / distance)};
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
  const PointVector& nearest_;
  Point largest_units_;
  PointVector places_;
  PointVector moves_;  // in units in the last place
  PointVector demands_;
  SnappedRing ring_;
  Tally& tally_;
};

}  // namespace

SnappedRing snap(const PointVector& places) {
  SnappedRing ring;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!(places[k] == places[cyclic_next(k, places.size())])) {
      ring.vertices.push_back(places[k]);
      ring.source.push_back(k);
    }
  }
  return ring;
}

std::optional<PointVector> separate(const ExactRing& ring, const PointVector& nearest,
                                    Tally& tally) {
  assert(nearest.size() == ring.size());
  return Separator(ring, nearest, tally).run();
}

}  // namespace gcv
