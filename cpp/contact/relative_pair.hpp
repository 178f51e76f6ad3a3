// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A placed pair in doubles, seen from the first vertex of A.
#pragma once

#include <cmath>

#include "pair_descent.hpp"
#include "polygon_pair.hpp"
#include "vector.hpp"

namespace gcv {

class RelativePair {
 public:
  explicit RelativePair(const PlacedPair& placed)
      : placed_(placed),
        offset_(placed.offset()),
        scale_(scale_for_squares(extent(placed.a.tree().box) + extent(placed.b.tree().box) +
                                 std::abs(offset_.x) + std::abs(offset_.y))),
        slack_(scale_ *
               (placed.pair.slack + 0x1p-48 * (std::abs(offset_.x) + std::abs(offset_.y)))) {}

  // A power of two by which all lengths are multiplied, so that their squares are in range.
  [[nodiscard]] double scale() const { return scale_; }

  // The start of an edge of A or B, and its end.
  struct Ends {
    Point from;
    Point to;
  };
  [[nodiscard]] Ends edge_of_a(Index i) const {
    const Boundary& a = placed_.a.boundary;
    return {scaled(a.relative(i)), scaled(a.relative(placed_.a.next(i)))};
  }
  [[nodiscard]] Ends edge_of_b(Index j) const {
    const Boundary& b = placed_.b.boundary;
    return {scaled(moved(b.relative(j))), scaled(moved(b.relative(placed_.b.next(j))))};
  }

  // The squares of the distances of a box from the children of a node.
  [[nodiscard]] SimdDouble squares_of_distances(const ChainTree::Block& block,
                                                const Box& box) const {
    const SimdDouble none = SimdDouble::of(0);
    const SimdDouble x = scale_ * larger(none, larger(SimdDouble::load(block.x0) + -box.x1,
                                                      box.x0 - SimdDouble::load(block.x1)));
    const SimdDouble y = scale_ * larger(none, larger(SimdDouble::load(block.y0) + -box.y1,
                                                      box.y0 - SimdDouble::load(block.y1)));
    return x * x + y * y;
  }

  static double square(double x, double y) { return x * x + y * y; }
  // Of the distance of a point from a segment.
  static double square_of_distance(const Ends& segment, const Point& p) {
    const double dx = segment.to.x - segment.from.x;
    const double dy = segment.to.y - segment.from.y;
    const double x = p.x - segment.from.x;
    const double y = p.y - segment.from.y;
    const double length = square(dx, dy);
    const double along = dx * x + dy * y;
    if (along > 0 && along < length) {
      const double height = dx * y - dy * x;
      return height * (height / length);
    }
    return along <= 0 ? square(x, y) : square(p.x - segment.to.x, p.y - segment.to.y);
  }
  // What the square of a distance up to `reach` may be in doubles.
  [[nodiscard]] double limit_of_squares(double reach) const {
    const double most = reach + 2 * slack_;
    return (1 + 0x1p-48) * most * most + std::numeric_limits<double>::min();
  }

 private:
  [[nodiscard]] Point moved(const Point& p) const { return {p.x + offset_.x, p.y + offset_.y}; }
  [[nodiscard]] Point scaled(const Point& p) const { return {scale_ * p.x, scale_ * p.y}; }

  const PlacedPair& placed_;
  const Point offset_;
  const double scale_;
  const double slack_;
};

}  // namespace gcv
