// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The boundary of all that is free, found once, so that what is nearest to each of many points is
// soon found.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

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
  ~FreeBoundary();
  FreeBoundary(FreeBoundary&& other) noexcept;
  FreeBoundary& operator=(FreeBoundary&& other) = delete;

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
  // way. About nearest first, some again.
  template <class Visit>
  void for_each_near(const Point& p, const double& reach, Tally& tally, Visit visit) const {
    std::vector<Near> near;
    for (std::size_t count = few;; count *= 4) {
      find_nearest(p, count, near);
      for (const Near& one : near) {
        if (one.distance > reach) {
          return;
        }
        const Piece& piece = pieces_[one.piece];
        const PlacesOnLine places(operands_, operands_.named(piece.from.leaving()), tally);
        const Place from = place_on(places, piece.from);
        const Place to = piece.is_point() ? from : place_on(places, piece.to);
        if (piece.is_of_ring() || places.compare(from, to) <= 0) {
          visit(places, from, to, piece.is_of_ring());
        } else {
          visit(places, to, from, false);
        }
      }
      if (near.size() == pieces_.size()) {
        return;
      }
    }
  }

 private:
  static constexpr std::size_t few = 8;
  // A piece, and a distance that it is not nearer than.
  struct Near {
    double distance;
    std::size_t piece;
  };
  struct Tree;

  // A vertex on the line, as the crossing with that of its edges which is not parallel.
  [[nodiscard]] static Place place_on(const PlacesOnLine& places, const RingVertex& v) {
    return places.place(v, places.is_parallel(v.arriving()) ? v.leaving() : v.arriving());
  }
  // So many pieces, or all of them, by their distances from a point.
  void find_nearest(const Point& p, std::size_t count, std::vector<Near>& near) const;

  const Operands& operands_;
  double slack_;
  double scale_;  // of coordinates in the tree, so that squares are in range
  std::vector<Piece> pieces_;
  std::vector<std::size_t> anywhere_;  // pieces without a box, where numbers have overflowed
  std::unique_ptr<const Tree> tree_;
};

}  // namespace gcv
