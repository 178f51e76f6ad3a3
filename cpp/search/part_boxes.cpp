// SPDX-License-Identifier: LGPL-3.0-or-later
#include "part_boxes.hpp"

#include <span>
#include <utility>

#include "boundary.hpp"
#include "convex_pieces.hpp"

namespace gcv {

namespace {

// What a search by one more box costs, in boxes that it meets.
constexpr double cost_of_a_search = 8;
constexpr int most_slabs = 32;

double area_of(const Box& box) { return (box.x1 - box.x0) * (box.y1 - box.y0); }

// The box of what is between two levels of one coordinate, along x or along y. It may be off by
// roundings.
Box box_between(const Boundary& polygon, std::span<const Index> piece, double Point::*along,
                double from, double to) {
  Box box = empty_box;
  Point p = polygon.relative(piece.back());
  for (const Index i : piece) {
    const Point q = polygon.relative(i);
    const double d = q.*along - p.*along;
    for (const double level : {from, to, p.*along, q.*along}) {
      const double t = d != 0 ? (level - p.*along) / d : 0;
      if (t >= 0 && t <= 1 && level >= from && level <= to) {
        const Point at{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
        box = hull_of(box, box_of(at, at));
      }
    }
    p = q;
  }
  return box;
}

std::vector<Box> boxes_of_slabs(const Boundary& polygon, int slabs) {
  std::vector<Box> boxes;
  const ConvexPieces& pieces = polygon.convex_pieces();
  for (std::size_t k = 0; k < pieces.count(); ++k) {
    const std::span<const Index> piece = pieces.piece(k);
    const Box box = box_of_piece(polygon, piece);
    const bool is_wide = box.x1 - box.x0 > box.y1 - box.y0;
    const double start = is_wide ? box.x0 : box.y0;
    const double size = (is_wide ? box.x1 - box.x0 : box.y1 - box.y0) / slabs;
    for (int slab = 0; slab < slabs; ++slab) {
      boxes.push_back(box_between(polygon, piece, is_wide ? &Point::x : &Point::y,
                                  start + slab * size, start + (slab + 1) * size));
    }
  }
  return boxes;
}

}  // namespace

Box box_of_piece(const Boundary& polygon, std::span<const Index> piece) {
  Box box = empty_box;
  for (const Index i : piece) {
    const Point p = polygon.relative(i);
    box = hull_of(box, box_of(p, p));
  }
  return box;
}

std::vector<Box> part_boxes(const Boundary& polygon, double meeting) {
  const auto cost_of = [&](const std::vector<Box>& boxes) {
    double cost = cost_of_a_search * static_cast<double>(boxes.size());
    for (const Box& box : boxes) {
      cost += meeting * area_of(box);
    }
    return cost;
  };
  const auto pieces = static_cast<double>(polygon.convex_pieces().count());
  if (pieces == 0) {
    return {box_of(polygon.relative(0), polygon.relative(0))};
  }
  std::vector<Box> best{polygon.relative_bounds()};
  double least = cost_of(best);
  for (int slabs = 1; slabs <= most_slabs && pieces * slabs * cost_of_a_search < least;
       slabs *= 2) {
    std::vector<Box> boxes = boxes_of_slabs(polygon, slabs);
    const double cost = cost_of(boxes);
    if (cost < least) {
      least = cost;
      best = std::move(boxes);
    }
  }
  return best;
}

}  // namespace gcv
