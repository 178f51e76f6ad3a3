// SPDX-License-Identifier: LGPL-3.0-or-later
#include "free_boundary.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <iterator>
#include <utility>

#include "vector.hpp"
#include "witness.hpp"

namespace gcv {

namespace {

namespace bg = boost::geometry;
using TreePoint = bg::model::d2::point_xy<double>;
using TreeBox = bg::model::box<TreePoint>;
using TreePiece = std::pair<TreeBox, std::size_t>;

bool is_finite(const Box& box) {
  return std::isfinite(box.x0) && std::isfinite(box.y0) && std::isfinite(box.x1) &&
         std::isfinite(box.y1);
}

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

struct FreeBoundary::Tree : bg::index::rtree<TreePiece, bg::index::quadratic<16>> {
  using rtree::rtree;
};

FreeBoundary::FreeBoundary(const Operands& operands, const ExactRegion& region, double slack,
                           Tally& tally)
    : operands_(operands),
      slack_(slack),
      scale_(scale_for_squares(extents_of(operands.relative_bounds()))) {
  for (const RegionPart& part : region.parts) {
    const std::size_t edges = part.is_ring() ? part.size : 1;
    for (std::size_t k = 0; k < edges; ++k) {
      pieces_.push_back({region.vertices[part.first + k],
                         region.vertices[part.first + (k + 1) % part.size], part.kind});
    }
  }
  std::vector<TreePiece> boxes;
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    const Piece& piece = pieces_[k];
    const PlacesOnLine places(operands_, operands_.named(piece.from.leaving()), tally);
    Box box = box_around(operands_, places, place_on(places, piece.from));
    if (!piece.is_point()) {
      box = hull_of(box, box_around(operands_, places, place_on(places, piece.to)));
    }
    box = widened(box, 8 * slack_);
    if (is_finite(box)) {
      boxes.push_back(
          {{{scale_ * box.x0, scale_ * box.y0}, {scale_ * box.x1, scale_ * box.y1}}, k});
    } else {
      anywhere_.push_back(k);
    }
  }
  tree_ = std::make_unique<const Tree>(boxes.begin(), boxes.end());
}

FreeBoundary::~FreeBoundary() = default;
FreeBoundary::FreeBoundary(FreeBoundary&& other) noexcept = default;

void FreeBoundary::find_nearest(const Point& p, std::size_t count, std::vector<Near>& near) const {
  near.clear();
  for (const std::size_t k : anywhere_) {
    near.push_back({0, k});
  }
  if (tree_->empty()) {
    return;
  }
  const TreePoint scaled(scale_ * p.x, scale_ * p.y);
  std::vector<TreePiece> found;
  tree_->query(bg::index::nearest(scaled, static_cast<unsigned>(std::min(count, tree_->size()))),
               std::back_inserter(found));
  for (const auto& [box, piece] : found) {
    const double distance = std::sqrt(bg::comparable_distance(scaled, box)) / scale_;
    near.push_back({distance * (1 - 0x1p-40), piece});
  }
  std::sort(near.begin(), near.end(), [](const Near& one, const Near& other) {
    return one.distance != other.distance ? one.distance < other.distance : one.piece < other.piece;
  });
}

}  // namespace gcv
