// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "capsules.hpp"
#include "chain_tree.hpp"
#include "implicit_superset.hpp"
#include "lanes.hpp"
#include "point.hpp"

namespace gcv {

// A piece of an edge s, from `from` to `to` in relative coordinates, as a place to search for
// the superset edges that cross or touch it.
//
// With u times the extents of both polygons, uE, as the unit: a box side is off by 2, an end
// of the piece by 5. Of the offset from the line of s, times |dx| + |dy|: a capsule is off by 24,
// `origin` by 2, and the products and sums of all add 20.
// `slack` is 64. The smallest normal double covers underflow. Where anything overflows,
// nothing is dropped.
class Piece {
 public:
  Piece(const SumEdge& s, const Point& origin, const Point& from, const Point& to, double slack)
      : dx_(s.dx),
        dy_(s.dy),
        length_(length_bound(s.dx, s.dy)),
        offset_(s.dx * origin.y - s.dy * origin.x),
        tolerance_(offset_tolerance(s.dx, s.dy, slack)),
        slack_(slack),
        margin_(margin(slack)),
        from_(from),
        to_(to) {
    shorten(to);
  }

  void shorten(const Point& to) {
    to_ = to;
    const Box box = box_of(from_, to);
    box_ = {box.x0 - slack_, box.y0 - slack_, box.x1 + slack_, box.y1 + slack_};
  }

  [[nodiscard]] ImplicitSuperset::Offsets offsets(const Box& box) const {
    return {dx_ * (dx_ > 0 ? box.y0 : box.y1) - dy_ * (dy_ > 0 ? box.x1 : box.x0),
            dx_ * (dx_ > 0 ? box.y1 : box.y0) - dy_ * (dy_ > 0 ? box.x0 : box.x1)};
  }

  // The lanes whose sums with the other node reach the box of the piece, and the line of s or
  // both of its sides.
  void look(const ImplicitSuperset::Block& block, const ImplicitSuperset::Node& other,
            ImplicitSuperset::Look& look) const {
    const CapsuleBlock& capsules = block.capsules;
    const DoubleLanes from =
        dx_ * DoubleLanes::load(capsules.y0) - dy_ * DoubleLanes::load(capsules.x0);
    const DoubleLanes to =
        dx_ * DoubleLanes::load(capsules.y1) - dy_ * DoubleLanes::load(capsules.x1);
    const DoubleLanes radius = length_ * DoubleLanes::load(capsules.radius);
    const DoubleLanes lowest = smaller(from, to) - radius;
    const DoubleLanes highest = larger(from, to) + radius;
    lowest.store(look.lowest);
    highest.store(look.highest);
    const unsigned apart = ((highest < offset_ - tolerance_ - other.offsets.highest) |
                            (lowest > offset_ + tolerance_ - other.offsets.lowest))
                               .bits();
    look.lanes = block.boxes.overlapping({box_.x0 - other.box.x1, box_.y0 - other.box.y1,
                                          box_.x1 - other.box.x0, box_.y1 - other.box.y0}) &
                 ~apart;
    if (look.lanes != 0) {
      look.lanes &= ~(apart_along_chains(capsules, other) | apart_along(capsules, other)).bits();
    }
  }

 private:
  // Twice the slack; infinite where the offset of a point from a chain can overflow.
  static double margin(double slack) {
    const double extents = 0x1p48 * slack;
    return extents * extents <= std::numeric_limits<double>::max()
               ? 2 * slack
               : std::numeric_limits<double>::infinity();
  }

  // DoubleLanes whose sums with the other node lie beside the piece, seen along their chains.
  [[nodiscard]] DoubleMask apart_along_chains(const CapsuleBlock& capsules,
                                              const ImplicitSuperset::Node& other) const {
    const DoubleLanes x = DoubleLanes::load(capsules.x0);
    const DoubleLanes y = DoubleLanes::load(capsules.y0);
    const DoubleLanes dx = DoubleLanes::load(capsules.x1) - x;
    const DoubleLanes dy = DoubleLanes::load(capsules.y1) - y;
    const auto offset = [&](const Point& p) { return p.y * dx - p.x * dy; };
    const DoubleLanes chain = dx * y - dy * x;
    const DoubleLanes first = offset(other.from);
    const DoubleLanes second = offset(other.to);
    const DoubleLanes begin = offset(from_) - chain;
    const DoubleLanes end = offset(to_) - chain;
    const DoubleLanes reach = (DoubleLanes::load(capsules.radius) + (other.radius + margin_)) *
                                  (magnitude(dx) + magnitude(dy)) +
                              std::numeric_limits<double>::min();
    return (larger(first, second) + reach < smaller(begin, end)) |
           (smaller(first, second) - reach > larger(begin, end));
  }

  // The same, seen along the chain of the other node.
  [[nodiscard]] DoubleMask apart_along(const CapsuleBlock& capsules,
                                       const ImplicitSuperset::Node& other) const {
    const double dx = other.to.x - other.from.x;
    const double dy = other.to.y - other.from.y;
    const auto offset = [&](const Point& p) { return dx * p.y - dy * p.x; };
    const double chain = offset(other.from);
    const double begin = offset(from_) - chain;
    const double end = offset(to_) - chain;
    const DoubleLanes first =
        dx * DoubleLanes::load(capsules.y0) - dy * DoubleLanes::load(capsules.x0);
    const DoubleLanes second =
        dx * DoubleLanes::load(capsules.y1) - dy * DoubleLanes::load(capsules.x1);
    const double size = std::abs(dx) + std::abs(dy);
    const DoubleLanes reach =
        size * (DoubleLanes::load(capsules.radius) + (other.radius + margin_)) +
        std::numeric_limits<double>::min();
    return (larger(first, second) + reach < std::min(begin, end)) |
           (smaller(first, second) - reach > std::max(begin, end));
  }

  double dx_;
  double dy_;
  double length_;
  double offset_;  // of the line of s, from the relative origin
  double tolerance_;
  double slack_;
  double margin_;  // infinite where an offset can overflow
  Point from_;
  Point to_;
  Box box_{};
};

}  // namespace gcv
