// SPDX-License-Identifier: LGPL-3.0-or-later
#include "convex_relation.hpp"

#include <cstdint>
#include <optional>

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

// Looks for an edge of one polygon that separates the other from it.
class SeparatingEdge {
 public:
  SeparatingEdge(const PlacedPolygon& polygon, const PlacedPolygon& other, Tally& tally)
      : polygon_(polygon), other_(other), tally_(tally) {}

  // Nothing if there is none.
  std::optional<Relation> find() {
    for (Index i = 0; i < polygon_.boundary.size(); ++i) {
      const SumEdge e = polygon_.edge(i);
      if (is_to_the_right(e)) {
        return meets(e, polygon_.vertex(polygon_.next(i))) ? Relation::touching : Relation::apart;
      }
    }
    return std::nullopt;
  }

 private:
  // Does all of the other polygon lie on the line or to the right of it? Begins with the vertex
  // that did not for the edge before. Leaves the vertices on the line, of which there are two at
  // most.
  bool is_to_the_right(const SumEdge& e) {
    const Index size = other_.boundary.size();
    on_line_count_ = 0;
    for (Index k = 0; k < size; ++k) {
      const Index j = left_ + k < size ? left_ + k : left_ + k - size;
      const int where = side(e, other_.vertex(j), tally_);
      if (where > 0) {
        left_ = j;
        return false;
      }
      if (where == 0) {
        on_line_[on_line_count_++] = j;
      }
    }
    return true;
  }
  // Do they touch on the line?
  bool meets(const SumEdge& e, const SumPoint& end) {
    bool is_before = true;
    bool is_behind = true;
    for (Index k = 0; k < on_line_count_; ++k) {
      const SumPoint point = other_.vertex(on_line_[k]);
      is_before = is_before && compare_along(e, point, e.origin, tally_) < 0;
      is_behind = is_behind && compare_along(e, point, end, tally_) > 0;
    }
    return !is_before && !is_behind;
  }

  const PlacedPolygon& polygon_;
  const PlacedPolygon& other_;
  Tally& tally_;
  Index left_ = 0;
  Index on_line_[2] = {0, 0};
  Index on_line_count_ = 0;
};

}  // namespace

bool are_small_and_convex(const PlacedPair& placed) {
  constexpr std::uint64_t most_vertices = 32;  // of both; above, a descent of the trees is faster
  const Boundary& a = placed.a.boundary;
  const Boundary& b = placed.b.boundary;
  return a.is_convex && b.is_convex && std::uint64_t{a.size()} + b.size() <= most_vertices;
}

Relation convex_relation(const PlacedPair& placed, Tally& tally) {
  if (const auto found = SeparatingEdge(placed.a, placed.b, tally).find()) {
    return *found;
  }
  return SeparatingEdge(placed.b, placed.a, tally).find().value_or(Relation::overlapping);
}

}  // namespace gcv
