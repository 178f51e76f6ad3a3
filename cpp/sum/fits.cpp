// SPDX-License-Identifier: LGPL-3.0-or-later
#include "fits.hpp"

#include <algorithm>
#include <utility>

#include "exact_order.hpp"
#include "predicates.hpp"
#include "ring_predicates.hpp"

namespace gcv {

namespace {

// Segments on one line follow each other in this order: by the direction of the line, then by the
// line, then by their first ends.
class SegmentOrder {
 public:
  SegmentOrder(const Operands& operands, const ExactOrder& order, Tally& tally)
      : operands_(operands), order_(order), tally_(tally) {}

  [[nodiscard]] bool operator()(const ExactSegment& p, const ExactSegment& q) const {
    const Rank rank_p = line_rank(p);
    const Rank rank_q = line_rank(q);
    if (rank_p != rank_q) {
      return rank_p < rank_q;
    }
    if (const int side = side_of(p, q); side != 0) {
      return side < 0;
    }
    const int by_first = order_.compare(p.ends[0], q.ends[0]);
    return by_first != 0 ? by_first < 0 : order_.compare(p.ends[1], q.ends[1]) < 0;
  }

  [[nodiscard]] bool are_on_one_line(const ExactSegment& p, const ExactSegment& q) const {
    return line_rank(p) == line_rank(q) && side_of(p, q) == 0;
  }

 private:
  [[nodiscard]] PairEdge line(const ExactSegment& segment) const {
    return operands_.named(segment.edge);
  }
  [[nodiscard]] Rank line_rank(const ExactSegment& segment) const {
    return line(segment).rank % operands_.directions.half_turn;
  }
  // On which side of the line of p is that of q, seen in the direction below half a turn?
  [[nodiscard]] int side_of(const ExactSegment& p, const ExactSegment& q) const {
    const PairEdge along = line(p);
    const int side = gcv::side(coordinates(operands_.a, operands_.b, along),
                               operands_.start(line(q)), tally_);
    return along.rank < operands_.directions.half_turn ? side : -side;
  }

  const Operands& operands_;
  const ExactOrder& order_;
  Tally& tally_;
};

}  // namespace

void Fits::finish(std::vector<RingVertex> corners) {
  const ExactOrder order(operands_, tally_);
  std::sort(points_.begin(), points_.end(), [&](const RingVertex& p, const RingVertex& q) {
    return order.compare(p, q) < 0;
  });
  points_.erase(std::unique(points_.begin(), points_.end(),
                            [&](const RingVertex& p, const RingVertex& q) {
                              return order.compare(p, q) == 0;
                            }),
                points_.end());
  if (!segments_.empty()) {
    join();
    cut(std::move(corners));
  }
}

void Fits::join() {
  const ExactOrder order(operands_, tally_);
  for (ExactSegment& segment : segments_) {
    if (order.compare(segment.ends[1], segment.ends[0]) < 0) {
      std::swap(segment.ends[0], segment.ends[1]);
    }
  }
  const SegmentOrder segment_order(operands_, order, tally_);
  std::sort(segments_.begin(), segments_.end(), segment_order);
  std::vector<ExactSegment> joined;
  for (const ExactSegment& segment : segments_) {
    if (!joined.empty() && segment_order.are_on_one_line(joined.back(), segment) &&
        order.compare(joined.back().ends[1], segment.ends[0]) >= 0) {
      if (order.compare(joined.back().ends[1], segment.ends[1]) < 0) {
        joined.back().ends[1] = segment.ends[1];
      }
    } else {
      joined.push_back(segment);
    }
  }
  segments_ = std::move(joined);
}

void Fits::cut(std::vector<RingVertex> corners) {
  const ExactOrder order(operands_, tally_);
  const auto is_before = [&](const RingVertex& p, const RingVertex& q) {
    return order.compare(p, q) < 0;
  };
  std::sort(corners.begin(), corners.end(), is_before);
  std::vector<ExactSegment> pieces;
  for (const auto& [edge, ends] : segments_) {
    const auto& [from, to] = ends;
    const SumEdge line = coordinates(operands_.a, operands_.b, edge);
    RingVertex begin = from;
    for (auto corner = std::upper_bound(corners.begin(), corners.end(), from, is_before);
         corner != corners.end() && is_before(*corner, to); ++corner) {
      if (side_of_vertex(operands_.a, operands_.b, line, *corner, tally_) == 0 &&
          is_before(begin, *corner)) {
        pieces.push_back({edge, {begin, *corner}});
        begin = *corner;
      }
    }
    pieces.push_back({edge, {begin, to}});
  }
  std::sort(pieces.begin(), pieces.end(), [&](const ExactSegment& p, const ExactSegment& q) {
    const int by_first = order.compare(p.ends[0], q.ends[0]);
    return by_first != 0 ? by_first < 0 : order.compare(p.ends[1], q.ends[1]) < 0;
  });
  segments_ = std::move(pieces);
}

}  // namespace gcv
