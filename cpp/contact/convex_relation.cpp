// SPDX-License-Identifier: LGPL-3.0-or-later
#include "convex_relation.hpp"

#include <bit>
#include <cstdint>
#include <optional>

#include "simd.hpp"

namespace gcv {

namespace {

// The order of two points along an edge that both lie on.
int compare_along(const SumEdge& e, const SumPoint& p, const SumPoint& q, Tally& tally) {
  if (e.from.x != e.to.x) {
    const int order = compare_x(p, q, tally);
    return e.from.x < e.to.x ? order : -order;
  }
  const int order = compare_y(p, q, tally);
  return e.from.y < e.to.y ? order : -order;
}

// How far points lie on the left of lines, as cross products.
SimdDouble left_of(const FourPoints& from, const FourPoints& to, const FourPoints& points) {
  return (to.x - from.x) * (points.y - from.y) - (to.y - from.y) * (points.x - from.x);
}

// Looks for an edge of one polygon that separates the other from it. `room`: more than cross
// products in doubles are off by.
class SeparatingEdge {
 public:
  SeparatingEdge(const SeenPolygon& polygon, const SeenPolygon& other, double room, Tally& tally)
      : polygon_(polygon), other_(other), room_(room), tally_(tally) {}

  // Nothing if there is none.
  std::optional<ConvexSeparation> find() {
    for (Index i = 0; i < polygon_.size();) {
      const auto passed = static_cast<Index>(std::countr_one(edges_with_left_on_left(i)));
      i += passed;
      if (passed == SimdDouble::width || i >= polygon_.size()) {
        continue;
      }
      if (is_to_the_right(i)) {
        return ConvexSeparation{meets(i) ? Relation::touching : Relation::apart, &polygon_, i};
      }
      ++i;
    }
    return std::nullopt;
  }

 private:
  // Of four edges from that one on, those that have the vertex left_ certainly on their left, as
  // bits.
  [[nodiscard]] unsigned edges_with_left_on_left(Index i) const {
    const FourPoints left = other_.four_times(left_);
    return (left_of(polygon_.four_from(i), polygon_.four_from(i + 1), left) > room_).bits();
  }
  // Does all of the other polygon lie on the line of the edge or to the right of it? Leaves the
  // vertices on the line, of which there are two at most; or else one on its left.
  bool is_to_the_right(Index edge) {
    const FourPoints from = polygon_.four_times(edge);
    const FourPoints to = polygon_.four_times(edge + 1);
    std::uint64_t undecided = 0;
    for (Index first = 0; first < other_.size(); first += SimdDouble::width) {
      const SimdDouble left = left_of(from, to, other_.four_from(first));
      if (const unsigned certain = (left > room_).bits(); certain != 0) {
        left_ = other_.around(first + static_cast<Index>(std::countr_zero(certain)));
        return false;
      }
      undecided |= std::uint64_t{~(left < -room_).bits() & SimdDouble::all} << first;
    }
    undecided &= (std::uint64_t{1} << other_.size()) - 1;
    on_line_count_ = 0;
    return !any_lane(undecided, [&](Index vertex) { return is_left(edge, vertex); });
  }
  // Keeps the vertex if it is, and also if it lies on the line.
  bool is_left(Index edge, Index vertex) {
    const int where = side(polygon_.edge(edge), other_.vertex(vertex), tally_);
    if (where > 0) {
      left_ = vertex;
    } else if (where == 0) {
      on_line_[on_line_count_++] = vertex;
    }
    return where > 0;
  }
  // Do they touch on the line?
  bool meets(Index edge) {
    const SumEdge e = polygon_.edge(edge);
    const SumPoint end = polygon_.vertex(polygon_.next(edge));
    bool is_before = true;
    bool is_behind = true;
    for (Index k = 0; k < on_line_count_; ++k) {
      const SumPoint point = other_.vertex(on_line_[k]);
      is_before = is_before && compare_along(e, point, e.origin, tally_) < 0;
      is_behind = is_behind && compare_along(e, point, end, tally_) > 0;
    }
    return !is_before && !is_behind;
  }

  const SeenPolygon& polygon_;
  const SeenPolygon& other_;
  const double room_;
  Tally& tally_;
  Index left_ = 0;
  Index on_line_[2] = {0, 0};
  Index on_line_count_ = 0;
};

}  // namespace

ConvexSeparation convex_separation(const ConvexPair& pair, Tally& tally) {
  if (const auto found = SeparatingEdge(pair.a, pair.b, pair.room, tally).find()) {
    return *found;
  }
  const auto found = SeparatingEdge(pair.b, pair.a, pair.room, tally).find();
  return found ? *found : ConvexSeparation{Relation::overlapping, nullptr, 0};
}

}  // namespace gcv
