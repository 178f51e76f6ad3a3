// SPDX-License-Identifier: LGPL-3.0-or-later
#include "containment.hpp"

#include <algorithm>

#include "box.hpp"
#include "predicates.hpp"

namespace gcv {

namespace {

// Tells whether a place of a line, and the germ there, lie inside closed rings of translated edges.
// Follows the line from the place on, moved to its right by an infinitesimal, and counts the edges
// that cross it.
class PointInRings {
 public:
  PointInRings(const Operands& operands, const PlacesOnLine& places, const Place& place,
               Tally& tally)
      : operands_(operands), places_(places), place_(place), tally_(tally) {}

  void pass(const PairEdge& edge) {
    const VertexSum from = start_of(edge);
    const VertexSum to = end_of(operands_, edge);
    const int from_side = side_of(from);
    const int to_side = side_of(to);
    if (from_side * to_side > 0) {
      return;
    }
    if (from_side == 0 && to_side == 0) {
      const int from_order = places_.compare(Place::of(from), place_);
      const int to_order = places_.compare(Place::of(to), place_);
      is_on_ring_ = is_on_ring_ || from_order * to_order <= 0;
      runs_along_ = runs_along_ ||
                    (std::min(from_order, to_order) <= 0 && std::max(from_order, to_order) > 0);
      meet(Place::of(from), from_order);
      meet(Place::of(to), to_order);
      return;
    }
    const Place crossing = from_side == 0 ? Place::of(from)
                           : to_side == 0 ? Place::of(to)
                                          : places_.crossing(Line::of(operands_, edge));
    const int order = places_.compare(crossing, place_);
    is_on_ring_ = is_on_ring_ || order == 0;
    meet(crossing, order);
    is_inside_ = is_inside_ != (order > 0 && (from_side < 0 || to_side < 0));
  }

  [[nodiscard]] bool holds_germ() const { return is_inside_; }
  [[nodiscard]] bool is_on_ring() const { return is_on_ring_; }
  // Does a ring run along the line behind the place?
  [[nodiscard]] bool runs_along() const { return runs_along_; }
  // Where the line meets a ring next, behind the place.
  [[nodiscard]] const std::optional<Place>& next() const { return next_; }

 private:
  void meet(const Place& place, int order) {
    if (order > 0 && (!next_ || places_.compare(place, *next_) < 0)) {
      next_ = place;
    }
  }
  [[nodiscard]] int side_of(const VertexSum& sum) const {
    return side(places_.line().at, operands_.point(sum), tally_);
  }

  const Operands& operands_;
  const PlacesOnLine& places_;
  const Place& place_;
  Tally& tally_;
  bool is_inside_ = false;
  bool is_on_ring_ = false;
  bool runs_along_ = false;
  std::optional<Place> next_;
};

}  // namespace

Containment containment_at(const Operands& operands, const PlacesOnLine& places, const Place& place,
                           const Box& around, Index seen, Tally& tally) {
  Containment result{false, false, false, std::nullopt};
  const Boundary& a = operands.a;
  const Boundary& b = operands.b;
  const Box box_b = b.cover_index().chords.blocks.front().boxes.box(0);
  const auto add = [&](const PointInRings& rings, bool inside) {
    if (rings.holds_germ() == inside) {
      result.of_germ = true;
      const bool is_further =
          !result.of_line ||
          (result.end && (!rings.next() || places.compare(*rings.next(), *result.end) > 0));
      if (is_further && !rings.runs_along()) {
        result.end = rings.next();
        result.of_line = true;
      }
      result.of_place = result.of_place || !rings.is_on_ring();
    }
  };
  // The first vertex of B is at 0.
  const Box near{around.x0 - box_b.x1, around.y0 - box_b.y1, around.x1 - box_b.x0,
                 around.y1 - box_b.y0};
  a.cover_index().solids.for_each_near(near, [&](Index solid, const Box& box) {
    const Index first = a.layout.begin(a.solids[solid]);
    if (first >= seen) {
      return;
    }
    const Point p = a.relative(first);
    if (!are_apart(near, {p.x, p.y, p.x, p.y})) {
      PointInRings rings(operands, places, place, tally);
      for (Index j = 0; j < b.size(); ++j) {
        rings.pass(operands.corner(first, j));
      }
      add(rings, true);
    }
    if (are_apart(around, box)) {
      return;
    }
    PointInRings rings(operands, places, place, tally);
    for (Index i = first; i < a.layout.end(a.solid_end(solid) - 1); ++i) {
      rings.pass(operands.translated(i, 0));
    }
    add(rings, solid != 0 || a.kind == Boundary::Kind::outer);
  });
  return result;
}

}  // namespace gcv
