// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The boundary of all that is free, found once, so that what is nearest to each of many points is
// soon found.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "box_tree.hpp"
#include "exact_ring.hpp"
#include "places_on_line.hpp"
#include "region.hpp"

namespace gcv {

// The parts of an exact region in a tree of boxes.
class FreeBoundary {
 public:
  // Those of a region of these operands, which must live longer. `slack`: how far coordinates of
  // points in relative coordinates may be off. O(n log n) for n vertices.
  FreeBoundary(const Operands& operands, const ExactRegion& region, double slack, Tally& tally);

  // Edges of rings, segments, and points: from one place on the line of a superset edge to another,
  // for edges of rings in the direction of that.
  struct Piece {
    RingVertex from;
    RingVertex to;
    PartKind kind;

    [[nodiscard]] bool is_point() const { return kind == PartKind::point; }
    [[nodiscard]] bool is_of_ring() const { return kind <= PartKind::hole; }
  };

  // Calls visit(places, from, to, is_of_ring), in the direction of the line, for the pieces whose
  // distance from a point, in relative coordinates, may be at most `reach`, which may fall on the
  // way. In squares that grow until one holds the reach or all: so it calls for some again.
  template <class Visit>
  void for_each_near(const Point& p, const double& reach, Tally& tally, Visit visit) const {
    double radius = first_radius_;
    bool is_last = false;
    do {
      const Box square = widened(box_of(p, p), std::min(radius, reach));
      is_last = !(radius < reach) || holds(square, bounds_);
      tree_.for_each_near(square, [&](std::uint32_t k, const Box& /*box*/) {
        visit_piece(pieces_[k], tally, visit);
      });
      is_last = is_last || !(reach > radius);
      radius *= 2;
    } while (!is_last);
  }

 private:
  template <class Visit>
  void visit_piece(const Piece& piece, Tally& tally, Visit& visit) const {
    const PlacesOnLine places(operands_, operands_.named(piece.from.leaving()), tally);
    const Place from = place_on(places, piece.from);
    const Place to = piece.is_point() ? from : place_on(places, piece.to);
    if (piece.is_of_ring() || places.compare(from, to) <= 0) {
      visit(places, from, to, piece.is_of_ring());
    } else {
      visit(places, to, from, false);
    }
  }
  // A vertex on the line, as the crossing with that of its edges which is not parallel.
  [[nodiscard]] static Place place_on(const PlacesOnLine& places, const RingVertex& v) {
    return places.place(v, places.is_parallel(v.arriving()) ? v.leaving() : v.arriving());
  }

  const Operands& operands_;
  std::vector<Piece> pieces_;
  BoxTree tree_;         // of the pieces
  Box bounds_;           // of all
  double first_radius_;  // of squares, about as large as pieces are apart
};

}  // namespace gcv
