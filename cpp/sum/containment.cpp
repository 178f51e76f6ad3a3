// SPDX-License-Identifier: LGPL-3.0-or-later
#include "containment.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "box.hpp"
#include "chord_tree.hpp"
#include "predicates.hpp"
#include "tree_product.hpp"

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

// What follows a place on a line, as far as it may be met: in relative coordinates.
class Ahead {
 public:
  Ahead(const SumEdge& line, const Box& around, double slack)
      : way_{line.dx, line.dy},
        around_(around),
        margin_(0x1p-47 * (0x1p49 * slack * (std::abs(line.dx) + std::abs(line.dy))) +
                std::numeric_limits<double>::min()) {}

  // False if no edge in the box meets it. The margin allows for roundings of all extents, and is
  // infinite where products may overflow. What is not a number is met.
  [[nodiscard]] bool may_meet(const Box& box) const {
    const Box to{box.x0 - around_.x1, box.y0 - around_.y1, box.x1 - around_.x0,
                 box.y1 - around_.y0};
    const auto most = [&](double x, double y) {
      return x * (x > 0 ? to.x1 : to.x0) + y * (y > 0 ? to.y1 : to.y0);
    };
    return !(most(way_.x, way_.y) < -margin_ || most(-way_.y, way_.x) < -margin_ ||
             most(way_.y, -way_.x) < -margin_);
  }

 private:
  Point way_;
  Box around_;
  double margin_;
};

// Calls visit(edge) for the edges below nodes whose boxes may_meet(box) does not leave out.
template <class MayMeet, class Visit>
void for_each_edge(const ChordTree& tree, MayMeet may_meet, Visit visit) {
  boost::container::small_vector<ChordTree::Node, 128> waiting{ChordTree::root};
  while (!waiting.empty()) {
    const ChordTree::Node node = waiting.back();
    waiting.pop_back();
    if (!may_meet(tree.box(node))) {
      continue;
    }
    if (tree.is_edge(node)) {
      visit(static_cast<Index>(tree.below(node)));
      continue;
    }
    const std::uint32_t block = tree.below(node);
    for_each_lane(tree.blocks[block].lanes,
                  [&](std::uint32_t lane) { waiting.push_back(ChordTree::node(block, lane)); });
  }
}

// The edges of a solid that has no more are looked at one by one. Those of a container, which is
// near everywhere, would be looked for among the edges of all members.
constexpr Index few_edges = 16;

// A solid of A and the first vertex of B, with edges to look for; or without, where all have been
// looked at.
struct SolidAt {
  Index first;
  Index end;
  bool is_inside;  // is what its rings hold covered?
  PointInRings rings;
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
  const Ahead ahead(places.line().at, around, slack_of(operands));
  // The first vertex of B is at 0.
  const Box near{around.x0 - box_b.x1, around.y0 - box_b.y1, around.x1 - box_b.x0,
                 around.y1 - box_b.y0};
  boost::container::small_vector<SolidAt, 4> solids;
  Box box_of_all = empty_box;
  a.cover_index().solids.for_each_near(near, [&](Index solid, const Box& box) {
    const Index first = a.layout.begin(a.solids[solid]);
    if (first >= seen) {
      return;
    }
    const Point p = a.relative(first);
    if (!are_apart(near, {p.x, p.y, p.x, p.y})) {
      PointInRings rings(operands, places, place, tally);
      for_each_edge(
          b.cover_index().chords,
          [&](const Box& edges) {
            return ahead.may_meet({p.x + edges.x0, p.y + edges.y0, p.x + edges.x1, p.y + edges.y1});
          },
          [&](Index j) { rings.pass(operands.corner(first, j)); });
      solids.push_back({0, 0, true, rings});
    }
    if (!are_apart(around, box)) {
      const Index end = a.layout.end(a.solid_end(solid) - 1);
      const bool is_few = end - first <= few_edges;
      solids.push_back({first, is_few ? first : end, solid != 0 || a.kind == Boundary::Kind::outer,
                        PointInRings(operands, places, place, tally)});
      for (Index i = first; is_few && i < end; ++i) {
        if (ahead.may_meet(box_of(a.relative(i), a.relative(a.next(i))))) {
          solids.back().rings.pass(operands.translated(i, 0));
        }
      }
      if (!is_few) {
        box_of_all = hull_of(box_of_all, box);
      }
    }
  });
  std::vector<std::uint64_t> by_first;  // with their places in `solids`
  for (std::size_t k = 0; k < solids.size(); ++k) {
    if (solids[k].end > solids[k].first) {
      by_first.push_back(std::uint64_t{solids[k].first} << 32 | k);
    }
  }
  std::sort(by_first.begin(), by_first.end());
  if (!by_first.empty()) {
    for_each_edge(
        a.cover_index().chords,
        [&](const Box& edges) { return !are_apart(edges, box_of_all) && ahead.may_meet(edges); },
        [&](Index i) {
          const auto next =
              std::lower_bound(by_first.begin(), by_first.end(), (std::uint64_t{i} + 1) << 32);
          if (next != by_first.begin()) {
            SolidAt& solid = solids[static_cast<std::uint32_t>(*(next - 1))];
            if (i < solid.end) {
              solid.rings.pass(operands.translated(i, 0));
            }
          }
        });
  }
  for (const SolidAt& solid : solids) {
    add(solid.rings, solid.is_inside);
  }
  return result;
}

}  // namespace gcv
