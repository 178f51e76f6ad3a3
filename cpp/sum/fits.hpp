// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Exact fits: the segments and points of a region, made canonical.
#pragma once

#include <array>
#include <vector>

#include "contributing_vertices.hpp"
#include "exact_ring.hpp"
#include "tally.hpp"

namespace gcv {

// A straight part of the boundary without area on either side.
struct ExactSegment {
  EdgeName edge;                   // a superset edge along it
  std::array<RingVertex, 2> ends;  // in lexicographic order
};

// Collects the segments and points that were found on superset edges. Several edges may have found
// the same ones, or parts of them.
class Fits {
 public:
  Fits(const Operands& operands, Tally& tally) : operands_(operands), tally_(tally) {}

  // Both lie on that superset edge.
  void add_segment(const EdgeName& edge, const RingVertex& from, const RingVertex& to) {
    segments_.push_back({edge, {from, to}});
  }
  void add_point(const RingVertex& point) { points_.push_back(point); }

  // Makes each point and segment the only one of its kind. Segments become maximal, and are cut where
  // they meet one of these corners of rings. O(k log k + corners) where segments overlap no more
  // than a few others.
  void finish(std::vector<RingVertex> corners);

  [[nodiscard]] const std::vector<ExactSegment>& segments() const { return segments_; }
  [[nodiscard]] const std::vector<RingVertex>& points() const { return points_; }

 private:
  void join();
  void cut(std::vector<RingVertex> corners);

  const Operands& operands_;
  Tally& tally_;
  std::vector<ExactSegment> segments_;
  std::vector<RingVertex> points_;
};

}  // namespace gcv
