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
// `origin` by 2, and the products and sums of all add 20. `slack` is 64. Of the offset from a side
// of the sum of two capsules, likewise: they are off by 24, an end of the piece, seen from a corner
// of them, by 10, and the products and sums of all add 20. `margin` is 128. The smallest normal
// double covers underflow. Where anything overflows, nothing is dropped.
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

  [[nodiscard]] const Point& from() const { return from_; }
  [[nodiscard]] const Point& to() const { return to_; }

  void shorten(const Point& to) {
    to_ = to;
    box_ = widened(box_of(from_, to), slack_);
  }

  [[nodiscard]] ImplicitSuperset::Offsets offsets(const Box& box) const {
    return ImplicitSuperset::offsets(box, dx_, dy_);
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
    const DoubleMask off_line = (highest < offset_ - tolerance_ - other.offsets.highest) |
                                (lowest > offset_ + tolerance_ - other.offsets.lowest);
    const DoubleMask beyond = block.boxes.apart({box_.x0 - other.box.x1, box_.y0 - other.box.y1,
                                                 box_.x1 - other.box.x0, box_.y1 - other.box.y0});
    look.lanes = ~(off_line | beyond | beside(capsules, other)).bits() & DoubleLanes::all;
  }

  // The lanes whose segments, parts of superset edges, reach the line of s and have ends of the
  // piece on both sides or close to their own.
  [[nodiscard]] unsigned touching(const SegmentBlock& segments) const {
    const DoubleLanes x0 = DoubleLanes::load(segments.x0);
    const DoubleLanes y0 = DoubleLanes::load(segments.y0);
    const DoubleLanes x1 = DoubleLanes::load(segments.x1);
    const DoubleLanes y1 = DoubleLanes::load(segments.y1);
    const DoubleLanes start = dx_ * y0 - dy_ * x0;
    const DoubleLanes end = dx_ * y1 - dy_ * x1;
    const DoubleMask off_line =
        (larger(start, end) < offset_ - tolerance_) | (smaller(start, end) > offset_ + tolerance_);
    const DoubleLanes dx = x1 - x0;
    const DoubleLanes dy = y1 - y0;
    const DoubleLanes from = dx * (from_.y - y0) - dy * (from_.x - x0);
    const DoubleLanes to = dx * (to_.y - y0) - dy * (to_.x - x0);
    const DoubleLanes reach = margin_ * (magnitude(dx) + magnitude(dy)) + smallest;
    const DoubleMask beside = (larger(from, to) + reach < 0) | (smaller(from, to) > reach);
    return ~(off_line | beside).bits() & DoubleLanes::all;
  }

 private:
  static constexpr double smallest = std::numeric_limits<double>::min();

  // Twice the slack; infinite where the offset of a point from a side can overflow.
  static double margin(double slack) {
    const double extents = 0x1p48 * slack;
    return extents * extents <= std::numeric_limits<double>::max()
               ? 2 * slack
               : std::numeric_limits<double>::infinity();
  }

  // The lanes whose sums with the capsule of the other node, parallelograms with round corners, lie
  // beside the piece, seen along one of their sides.
  [[nodiscard]] DoubleMask beside(const CapsuleBlock& capsules,
                                  const ImplicitSuperset::Node& other) const {
    const DoubleLanes x0 = DoubleLanes::load(capsules.x0);
    const DoubleLanes y0 = DoubleLanes::load(capsules.y0);
    const DoubleLanes dx = DoubleLanes::load(capsules.x1) - x0;
    const DoubleLanes dy = DoubleLanes::load(capsules.y1) - y0;
    const double other_dx = other.to.x - other.from.x;
    const double other_dy = other.to.y - other.from.y;
    // The ends of the piece, seen from a corner of the parallelogram.
    const DoubleLanes from_x = (from_.x - other.from.x) - x0;
    const DoubleLanes from_y = (from_.y - other.from.y) - y0;
    const DoubleLanes to_x = (to_.x - other.from.x) - x0;
    const DoubleLanes to_y = (to_.y - other.from.y) - y0;
    const DoubleLanes width = other_dy * dx - other_dx * dy;
    const DoubleLanes radius = DoubleLanes::load(capsules.radius) + (other.radius + margin_);
    const DoubleLanes lowest = smaller(width, DoubleLanes::of(0));
    const DoubleLanes highest = larger(width, DoubleLanes::of(0));
    const auto beside_along = [&](const DoubleLanes& first, const DoubleLanes& second,
                                  const DoubleLanes& reach) {
      return (highest + reach < smaller(first, second)) | (larger(first, second) < lowest - reach);
    };
    return beside_along(dx * from_y - dy * from_x, dx * to_y - dy * to_x,
                        radius * (magnitude(dx) + magnitude(dy)) + smallest) |
           beside_along(other_dy * from_x - other_dx * from_y, other_dy * to_x - other_dx * to_y,
                        (std::abs(other_dx) + std::abs(other_dy)) * radius + smallest);
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
