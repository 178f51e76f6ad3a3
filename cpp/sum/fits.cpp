// SPDX-License-Identifier: LGPL-3.0-or-later
#include "fits.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "predicates.hpp"
#include "ring_predicates.hpp"

namespace gcv {

// Segments on one line follow each other in this order: by the direction of the line, then by the
// line, then by their first ends. Of equal ones, that with the smallest name comes first.
class Fits::LineOrder {
 public:
  LineOrder(const Operands& operands, const ExactOrder& order, Tally& tally)
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
    return is_before(order_, p, q) || (!is_before(order_, q, p) && p.edge.key() < q.edge.key());
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
    const int side =
        gcv::side(coordinates(operands_.a, operands_.b, along), operands_.start(line(q)), tally_);
    return along.rank < operands_.directions.half_turn ? side : -side;
  }

  const Operands& operands_;
  const ExactOrder& order_;
  Tally& tally_;
};

bool Fits::is_before(const ExactOrder& order, const ExactSegment& p, const ExactSegment& q) {
  const int by_first = order.compare(p.ends[0], q.ends[0]);
  return by_first != 0 ? by_first < 0 : order.compare(p.ends[1], q.ends[1]) < 0;
}

void Fits::add_segment(const EdgeName& edge, const RingVertex& from, const RingVertex& to) {
  segments_.push_back({edge, {order_.placed(from), order_.placed(to)}});
  auto& [first, last] = segments_.back().ends;
  if (order_.compare(last, first) < 0) {
    std::swap(first, last);
  }
}

void Fits::finish(const std::vector<RingVertex>& corners) {
  // Of equal ones, that with the smallest names comes first.
  std::sort(points_.begin(), points_.end(), [&](const auto& p, const auto& q) {
    const int order = order_.compare(p, q);
    const auto names = [](const RingVertex& v) {
      return std::pair(v.leaving().key(), v.arriving().key());
    };
    return order < 0 || (order == 0 && names(p.vertex) < names(q.vertex));
  });
  points_.erase(
      std::unique(points_.begin(), points_.end(),
                  [&](const auto& p, const auto& q) { return order_.compare(p, q) == 0; }),
      points_.end());
  if (!segments_.empty()) {
    cut(join(), corners);
  }
}

bool Fits::is_on(const EdgeName& edge, const ExactOrder::Placed& from, const ExactOrder::Placed& to,
                 const ExactOrder::Placed& point) const {
  const int order = order_.compare(from, point);
  return order == 0 ||
         (order * order_.compare(point, to) >= 0 &&
          side_of_vertex(operands_.a, operands_.b, coordinates(operands_.a, operands_.b, edge),
                         point.vertex, tally_) == 0);
}

void Fits::drop_points_on(const std::vector<RingVertex>& vertices,
                          std::span<const RegionPart> rings) {
  std::erase_if(points_, [&](const ExactOrder::Placed& point) {
    const bool is_on_segment =
        std::any_of(segments_.begin(), segments_.end(), [&](const ExactSegment& segment) {
          return is_on(segment.edge, segment.ends[0], segment.ends[1], point);
        });
    return is_on_segment || std::any_of(rings.begin(), rings.end(), [&](const RegionPart& ring) {
             ExactOrder::Placed from = order_.placed(vertices[ring.end() - 1]);
             for (std::size_t k = ring.first; k < ring.end(); ++k) {
               const EdgeName edge = from.vertex.leaving();
               const ExactOrder::Placed to = order_.placed(vertices[k]);
               if (is_on(edge, from, to, point)) {
                 return true;
               }
               from = to;
             }
             return false;
           });
  });
}

// Where segments overlap or follow each other, they are one.
std::vector<Fits::Joined> Fits::join() {
  const LineOrder line_order(operands_, order_, tally_);
  std::sort(segments_.begin(), segments_.end(), line_order);
  std::vector<Joined> joined;
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    const ExactSegment& segment = segments_[k];
    if (joined.empty() || !line_order.are_on_one_line(segments_[joined.back().first], segment) ||
        order_.compare(joined.back().end, segment.ends[0]) < 0) {
      joined.push_back({k, segment.ends[1]});
    } else if (order_.compare(joined.back().end, segment.ends[1]) < 0) {
      joined.back().end = segment.ends[1];
    }
  }
  return joined;
}

// Each piece has the edge of the first segment that goes on where it begins.
void Fits::cut(const std::vector<Joined>& joined, const std::vector<RingVertex>& corners) {
  using Placed = ExactOrder::Placed;
  const auto is_before_in_order = [&](const Placed& p, const Placed& q) {
    return order_.compare(p, q) < 0;
  };
  std::vector<Placed> sorted;
  sorted.reserve(corners.size());
  for (const RingVertex& corner : corners) {
    sorted.push_back(order_.placed(corner));
  }
  std::sort(sorted.begin(), sorted.end(), is_before_in_order);
  std::vector<ExactSegment> pieces;
  for (const auto& [first, to] : joined) {
    const Placed& from = segments_[first].ends[0];
    const SumEdge line = coordinates(operands_.a, operands_.b, segments_[first].edge);
    Placed begin = from;
    std::size_t segment = first;
    const auto add_piece = [&](const Placed& end) {
      while (!is_before_in_order(begin, segments_[segment].ends[1])) {
        ++segment;
      }
      pieces.push_back({segments_[segment].edge, {begin, end}});
      begin = end;
    };
    for (auto corner = std::upper_bound(sorted.begin(), sorted.end(), from, is_before_in_order);
         corner != sorted.end() && is_before_in_order(*corner, to); ++corner) {
      if (side_of_vertex(operands_.a, operands_.b, line, corner->vertex, tally_) == 0 &&
          is_before_in_order(begin, *corner)) {
        add_piece(*corner);
      }
    }
    add_piece(to);
  }
  std::sort(pieces.begin(), pieces.end(),
            [&](const auto& p, const auto& q) { return is_before(order_, p, q); });
  segments_ = std::move(pieces);
}

}  // namespace gcv
