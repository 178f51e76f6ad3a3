// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Exact fits: the segments and points of a region, made canonical.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "contributing_vertices.hpp"
#include "exact_order.hpp"
#include "exact_ring.hpp"
#include "region.hpp"
#include "tally.hpp"

namespace gcv {

// A straight part of the boundary without area on either side.
struct ExactSegment {
  EdgeName edge;                           // a superset edge along it
  std::array<ExactOrder::Placed, 2> ends;  // in lexicographic order
};

// Collects the segments and points that were found on superset edges. Several edges may have found
// the same ones, or parts of them.
class Fits {
 public:
  Fits(const Operands& operands, Tally& tally)
      : operands_(operands), tally_(tally), order_(operands.a, operands.b, {0, 0}, tally) {}

  // Both lie on that superset edge.
  void add_segment(const EdgeName& edge, const RingVertex& from, const RingVertex& to);
  void add_point(const RingVertex& point) { points_.push_back(order_.placed(point)); }

  // Makes each point and segment the only one of its kind. Segments become maximal, and are cut
  // where they meet one of these corners of rings. O(k log k + corners) where few corners lie
  // between the ends of a segment, in lexicographic order.
  void finish(const std::vector<RingVertex>& corners);

  // Leaves out points that lie on one of these rings, which follow one another, or on a segment.
  // Needed for a window alone: one point of a fit can be in it, and be there otherwise. O(rings and
  // segments) for each point.
  void drop_points_on(const std::vector<RingVertex>& vertices, std::span<const RegionPart> rings);

  [[nodiscard]] const std::vector<ExactSegment>& segments() const { return segments_; }
  [[nodiscard]] const std::vector<ExactOrder::Placed>& points() const { return points_; }

 private:
  class LineOrder;

  static bool is_before(const ExactOrder& order, const ExactSegment& p, const ExactSegment& q);
  // Does the point lie on the closed part of the edge's line?
  [[nodiscard]] bool is_on(const EdgeName& edge, const ExactOrder::Placed& from,
                           const ExactOrder::Placed& to, const ExactOrder::Placed& point) const;
  // Segments that are one, from the first of these on.
  struct Joined {
    std::size_t first;
    ExactOrder::Placed end;
  };
  std::vector<Joined> join();
  void cut(const std::vector<Joined>& joined, const std::vector<RingVertex>& corners);

  const Operands& operands_;
  Tally& tally_;
  ExactOrder order_;
  std::vector<ExactSegment> segments_;
  std::vector<ExactOrder::Placed> points_;
};

}  // namespace gcv
