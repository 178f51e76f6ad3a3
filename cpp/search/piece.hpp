// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

#include "box.hpp"
#include "chain_tree.hpp"
#include "point.hpp"
#include "simd.hpp"
#include "swept_spheres.hpp"
#include "tree_product.hpp"
#include "vector.hpp"

namespace gcv {

// A piece of an edge s, from `from` to `to` in relative coordinates, as a place to search for
// the superset edges that cross or touch it.
//
// With u times the extents of both polygons, uE, as the unit: a box side is off by 2, an end
// of the piece by 5. Of the offset from the line of s, times |dx| + |dy|: a line-swept sphere is
// off by 24, `origin` by 2, and the products and sums of all add 20. `slack` is 64. Of the offset
// from a side of the sum of two line-swept spheres, likewise: they are off by 24, an end of the
// piece, seen from a corner of them, by 10, and the products and sums of all add 20. `margin` is
// 128. The smallest normal double covers underflow. Where anything overflows, nothing is dropped.
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

  [[nodiscard]] TreeProduct::Offsets offsets(const Box& box) const {
    return TreeProduct::offsets(box, dx_, dy_);
  }

  // The lanes whose sums with the other node reach the box of the piece, and the line of s or
  // both of its sides.
  void cull(const TreeProduct::Block& block, const TreeProduct::Node& other,
            TreeProduct::Survivors& survivors) const {
    const SweptSphereBlock& spheres = block.spheres;
    const SimdDouble from = dx_ * SimdDouble::load(spheres.y0) - dy_ * SimdDouble::load(spheres.x0);
    const SimdDouble to = dx_ * SimdDouble::load(spheres.y1) - dy_ * SimdDouble::load(spheres.x1);
    const SimdDouble radius = length_ * SimdDouble::load(spheres.radius);
    const SimdDouble lowest = smaller(from, to) - radius;
    const SimdDouble highest = larger(from, to) + radius;
    lowest.store(survivors.lowest);
    highest.store(survivors.highest);
    const DoubleMask off_line = (highest < offset_ - tolerance_ - other.offsets.highest) |
                                (lowest > offset_ + tolerance_ - other.offsets.lowest);
    const DoubleMask beyond = block.boxes.apart({box_.x0 - other.box.x1, box_.y0 - other.box.y1,
                                                 box_.x1 - other.box.x0, box_.y1 - other.box.y0});
    survivors.lanes = ~(off_line | beyond | beside(spheres, other)).bits() & SimdDouble::all;
  }

  // The lanes whose segments, parts of superset edges, reach the line of s and have ends of the
  // piece on both sides or close to their own.
  [[nodiscard]] unsigned touching(const SegmentBlock& segments) const {
    const SimdDouble x0 = SimdDouble::load(segments.x0);
    const SimdDouble y0 = SimdDouble::load(segments.y0);
    const SimdDouble x1 = SimdDouble::load(segments.x1);
    const SimdDouble y1 = SimdDouble::load(segments.y1);
    const SimdDouble start = dx_ * y0 - dy_ * x0;
    const SimdDouble end = dx_ * y1 - dy_ * x1;
    const DoubleMask off_line =
        (larger(start, end) < offset_ - tolerance_) | (smaller(start, end) > offset_ + tolerance_);
    const SimdDouble dx = x1 - x0;
    const SimdDouble dy = y1 - y0;
    const SimdDouble from = dx * (from_.y - y0) - dy * (from_.x - x0);
    const SimdDouble to = dx * (to_.y - y0) - dy * (to_.x - x0);
    const SimdDouble reach = margin_ * (magnitude(dx) + magnitude(dy)) + smallest;
    const DoubleMask beside = (larger(from, to) + reach < 0) | (smaller(from, to) > reach);
    return ~(off_line | beside).bits() & SimdDouble::all;
  }

 private:
  static constexpr double smallest = std::numeric_limits<double>::min();

  // Twice the slack; infinite where the offset of a point from a side can overflow.
  static double margin(double slack) {
    const double extents = 0x1p48 * slack;
    return extents * extents <= std::numeric_limits<double>::max() ? 2 * slack : infinity;
  }

  // The lanes whose sums with the line-swept sphere of the other node, parallelograms with round
  // corners, lie beside the piece, seen along one of their sides.
  [[nodiscard]] DoubleMask beside(const SweptSphereBlock& spheres,
                                  const TreeProduct::Node& other) const {
    const SimdDouble x0 = SimdDouble::load(spheres.x0);
    const SimdDouble y0 = SimdDouble::load(spheres.y0);
    const SimdDouble dx = SimdDouble::load(spheres.x1) - x0;
    const SimdDouble dy = SimdDouble::load(spheres.y1) - y0;
    const double other_dx = other.to.x - other.from.x;
    const double other_dy = other.to.y - other.from.y;
    // The ends of the piece, seen from a corner of the parallelogram.
    const SimdDouble from_x = (from_.x - other.from.x) - x0;
    const SimdDouble from_y = (from_.y - other.from.y) - y0;
    const SimdDouble to_x = (to_.x - other.from.x) - x0;
    const SimdDouble to_y = (to_.y - other.from.y) - y0;
    const SimdDouble width = other_dy * dx - other_dx * dy;
    const SimdDouble radius = SimdDouble::load(spheres.radius) + (other.radius + margin_);
    const SimdDouble lowest = smaller(width, SimdDouble::of(0));
    const SimdDouble highest = larger(width, SimdDouble::of(0));
    const auto beside_along = [&](const SimdDouble& first, const SimdDouble& second,
                                  const SimdDouble& reach) {
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
