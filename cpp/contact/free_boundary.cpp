// SPDX-License-Identifier: LGPL-3.0-or-later
#include "free_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "witness.hpp"

namespace gcv {

namespace {

// Around a place on the line of an edge.
Box box_around(const Operands& operands, const PlacesOnLine& places, const Place& place) {
  if (place.is_sum) {
    const Point p = operands.relative(place.sum.i, place.sum.j);
    return box_of(p, p);
  }
  const Line& s = places.line();
  const RelativeLine line{operands.relative_start(s.edge), s.at.dx, s.at.dy};
  return box_of(line.at(place.parameter.lo), line.at(place.parameter.hi));
}

}  // namespace

FreeBoundary::FreeBoundary(const Operands& operands, const ExactRegion& region, double slack,
                           Tally& tally)
    : operands_(operands), bounds_(empty_box) {
  for (const RegionPart& part : region.parts) {
    const std::size_t edges = part.is_ring() ? part.size : 1;
    for (std::size_t k = 0; k < edges; ++k) {
      pieces_.push_back({region.vertices[part.first + k],
                         region.vertices[part.first + (k + 1) % part.size], part.kind});
    }
  }
  std::vector<Box> boxes;
  boxes.reserve(pieces_.size());
  for (const Piece& piece : pieces_) {
    const PlacesOnLine places(operands_, operands_.named(piece.from.leaving()), tally);
    Box box = box_around(operands_, places, place_on(places, piece.from));
    if (!piece.is_point()) {
      box = hull_of(box, box_around(operands_, places, place_on(places, piece.to)));
    }
    boxes.push_back(widened(box, 8 * slack));
    bounds_ = hull_of(bounds_, boxes.back());
  }
  tree_ = BoxTree(boxes);
  const double pieces_a_side = 8 * std::sqrt(static_cast<double>(pieces_.size()));
  first_radius_ = std::max(extents_of(operands_.relative_bounds()) / pieces_a_side,
                           std::numeric_limits<double>::min());
}

}  // namespace gcv
