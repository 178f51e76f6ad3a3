// SPDX-License-Identifier: LGPL-3.0-or-later
#include "search.hpp"

#include <cmath>

#include "limits.hpp"

namespace gcv {

Search::Search(const SearchableSuperset& superset)
    : superset_(superset), operands_(superset.operands()) {
  if (const auto& product = superset.product()) {
    if (product->has_equal_chains()) {
      visited_ = std::make_unique<VisitedPairs>();
    }
    near_.emplace(*product, superset.slack());
    ahead_.emplace(*product, superset.slack());
  }
}

// Of a convex polygon and another one, no more than a few superset edges overlap anywhere: one edge
// of the convex one has a direction, and the edges of the other one do not overlap. The search
// along lines sorts vertices, which boundaries at several positions have not in one order.
std::optional<Search::Continuation> Search::continued(const PairEdge& s, const VertexSum& place) {
  if (!superset_.product() || operands_.a.is_convex || operands_.b.is_convex ||
      !operands_.a.positions.empty()) {
    return std::nullopt;
  }
  straight_cost_ += limits::line_cost_of_a_step + last_candidates_;
  if (!line_ || !line_->is_about(s)) {
    const std::uint64_t price =
        limits::line_price_a_vertex * (std::uint64_t{operands_.a.size()} + operands_.b.size());
    if (straight_cost_ < price) {
      return std::nullopt;
    }
    straight_cost_ = 0;
    line_.emplace(operands_, s);
  }
  line_->go_to(s);
  const VertexSum end = line_->reach(place);
  const SumEdge line = coordinates(operands_.a, operands_.b, s);
  const Point from = operands_.relative_start(s);
  const Point to = operands_.relative(end.i, end.j);
  const bool by_x = std::abs(line.dx) >= std::abs(line.dy);
  const double length = by_x ? (to.x - from.x) / line.dx : (to.y - from.y) / line.dy;
  if (!(length > 1)) {
    return std::nullopt;
  }
  is_continued_ = true;
  return Continuation{end, length};
}

}  // namespace gcv
