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

  // Four edges, or one four times, and four points.
  struct FourEnds {
    SimdDouble from_x;
    SimdDouble from_y;
    SimdDouble to_x;
    SimdDouble to_y;

    static FourEnds of(const Ends& ends) {
      return {SimdDouble::of(ends.from.x), SimdDouble::of(ends.from.y), SimdDouble::of(ends.to.x),
              SimdDouble::of(ends.to.y)};
    }
  };
  [[nodiscard]] FourEnds edges_of_a(Index block) const {
    return scaled(last_blocks(placed_.a)[block], {0, 0});
  }
  [[nodiscard]] FourEnds edges_of_b(Index block) const {
    return scaled(last_blocks(placed_.b)[block], offset_);
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
  static SimdDouble squares_of_distances(const FourEnds& segments, const SimdDouble& px,
                                         const SimdDouble& py) {
    const SimdDouble dx = segments.to_x - segments.from_x;
    const SimdDouble dy = segments.to_y - segments.from_y;
    const SimdDouble x = px - segments.from_x;
    const SimdDouble y = py - segments.from_y;
    const SimdDouble end_x = px - segments.to_x;
    const SimdDouble end_y = py - segments.to_y;
    const SimdDouble length = dx * dx + dy * dy;
    const SimdDouble along = dx * x + dy * y;
    const SimdDouble height = dx * y - dy * x;
    const SimdDouble not_from_start =
        select(along < length, height * (height / length), end_x * end_x + end_y * end_y);
    return select(along > 0, not_from_start, x * x + y * y);
  }
  // What the square of a distance up to `reach` may be in doubles.
  [[nodiscard]] double limit_of_squares(double reach) const {
    const double most = reach + 2 * slack_;
    return (1 + 0x1p-48) * most * most + std::numeric_limits<double>::min();
  }

 private:
  [[nodiscard]] Point moved(const Point& p) const { return {p.x + offset_.x, p.y + offset_.y}; }
  [[nodiscard]] Point scaled(const Point& p) const { return {scale_ * p.x, scale_ * p.y}; }
  [[nodiscard]] FourEnds scaled(const SegmentBlock& edges, const Point& offset) const {
    return {scale_ * (SimdDouble::load(edges.x0) + offset.x),
            scale_ * (SimdDouble::load(edges.y0) + offset.y),
            scale_ * (SimdDouble::load(edges.x1) + offset.x),
            scale_ * (SimdDouble::load(edges.y1) + offset.y)};
  }
  // Those of edges.
  static const SweptSphereBlock* last_blocks(const PlacedPolygon& polygon) {
    const ChainIndex& index = polygon.boundary.index();
    return index.spheres.data() + index.tree.first_block.back();
  }

  const PlacedPair& placed_;
  const Point offset_;
  const double scale_;
  const double slack_;
};

}  // namespace gcv
