// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cast.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "convex_cast.hpp"
#include "relative_pair.hpp"
#include "solid_cones.hpp"
#include "swept_box.hpp"

namespace gcv {

namespace {

double size_of(const Point& p) { return std::abs(p.x) + std::abs(p.y); }

// The first contact that the motion enters.
class FirstEntry {
 public:
  FirstEntry(const PlacedPair& placed, const Point& motion, Tally& tally)
      : placed_(placed),
        motion_(motion),
        direction_{{0, 0}, motion},
        path_{{placed.b.translation, negated(placed.a.translation)},
              {0, 0},
              motion,
              motion.x,
              motion.y},
        tally_(tally),
        relative_(placed),
        slack_(placed.slack(relative_.offset()) + 0x1p-48 * size_of(motion)),
        scaled_motion_{relative_.scale() * motion.x, relative_.scale() * motion.y},
        room_of_sides_(relative_.slack() * (2 * relative_.reach() + relative_.slack())),
        room_of_paths_(2 * relative_.slack() * size_of(scaled_motion_) +
                       std::numeric_limits<double>::min()) {
    const std::optional<ContactName> entered =
        are_small_and_convex(placed) ? contact_entered(placed, motion, tally) : std::nullopt;
    if (entered) {
      add(*entered);
    } else {
      relative_.descend(*this);
    }
  }

  // The children that a box meets on its way, the first one first. Seen from B, A moves backwards.
  template <class Visit>
  bool any_child(const ChainTree::Block& block, const Box& box, bool is_of_a, Visit visit) {
    const SweptBox swept{box, is_of_a ? motion_ : negated(motion_), slack_};
    return swept.any_child(block, limit_, visit);
  }

  [[nodiscard]] bool are_beyond_reach(const ChainTree::Node& a, const ChainTree::Node& b) const {
    return relative_.gap_between(a, b, {limit_ * motion_.x, limit_ * motion_.y}) > 0;
  }

  // The edges of the block that are met on the way.
  template <bool is_of_a>
  bool meet_edges(const ChainTree::Block& block, const Box& box,
                  const EdgesOfBlock<is_of_a>& edges) {
    std::optional<unsigned> may;
    return any_child(block, box, is_of_a, [&](std::uint32_t lane) {
      if (!may) {
        may = may_enter(relative_.edges_of_a(edges), relative_.edges_of_b(edges));
      }
      if ((*may >> lane & 1U) != 0) {
        meet(edges.i(lane), edges.j(lane));
      }
      return false;
    });
  }

  [[nodiscard]] const std::optional<Entry>& entry() const { return first_; }

 private:
  using FourEnds = RelativePair::FourEnds;

  // The start of each of the edges and the other edge.
  void meet(Index i, Index j) {
    const SumPoint p = placed_.a.vertex(i);
    const SumPoint q = placed_.b.vertex(j);
    const SumEdge path_of_q = path_of(q);
    const int p_side = side(path_of_q, p, tally_);
    if (p_side == 0) {
      if (enters_vertices(i, j, path_of_q)) {
        add({ContactKind::vertex_vertex, i, j});
      }
      return;
    }
    // The motion enters an edge from its right to its left.
    if (p_side > 0 && side(path_of_q, placed_.a.vertex(placed_.a.next(i)), tally_) < 0 &&
        side(placed_.a.edge(i), q, tally_) <= 0 && !passes_touch(placed_.a, i, path_of_q)) {
      add({ContactKind::edge_vertex, i, j});
    }
    // From p, q lies on the other side of its path than p from that of q.
    const SumEdge path_of_p = path_of(p);
    if (p_side > 0 && side(path_of_p, placed_.b.vertex(placed_.b.next(j)), tally_) > 0 &&
        side(placed_.b.edge(j), p, tally_) <= 0 && !passes_touch(placed_.b, j, path_of_p)) {
      add({ContactKind::vertex_edge, i, j});
    }
  }
  // The lanes for which meet() may find something, as bits: what it asks, in doubles.
  [[nodiscard]] unsigned may_enter(const FourEnds& p, const FourEnds& q) const {
    const SimdDouble p_from = left_of_motion(p.from_x, p.from_y);
    const SimdDouble p_to = left_of_motion(p.to_x, p.to_y);
    const SimdDouble q_from = left_of_motion(q.from_x, q.from_y);
    const SimdDouble q_to = left_of_motion(q.to_x, q.to_y);
    const auto sides = RelativePair::cross_products(p, q);
    const unsigned starts_aside = (q_from - p_from > room_of_paths_).bits();
    const unsigned starts_ahead = (p_from - q_from > room_of_paths_).bits();
    const unsigned p_stays =
        ((p_to - q_from > room_of_paths_) | (sides.q_from > room_of_sides_)).bits();
    const unsigned q_stays =
        ((p_from - q_to > room_of_paths_) | (sides.p_from > room_of_sides_)).bits();
    return ~(starts_aside | (starts_ahead & p_stays & q_stays));
  }
  // How far points lie on the left of the line of the motion, in times of its length.
  [[nodiscard]] SimdDouble left_of_motion(const SimdDouble& x, const SimdDouble& y) const {
    return scaled_motion_.x * y - scaled_motion_.y * x;
  }

  // The paths of a vertex of B, and of one of A as seen from B, with the direction of the motion.
  [[nodiscard]] SumEdge path_of(const SumPoint& vertex) const {
    return {vertex, {0, 0}, motion_, motion_.x, motion_.y};
  }

  // The vertices meet on the line of the motion. Is this ahead, and do cones overlap right after?
  bool enters_vertices(Index i, Index j, const SumEdge& path_of_q) {
    const SumEdge across = perpendicular(path_of_q, path_of_q.origin);
    return side(across, placed_.a.vertex(i), tally_) <= 0 &&
           overlap_once_moved(cones_of_vertex(placed_.a, i, tally_),
                              cones_of_vertex(placed_.b, j, tally_), direction_, tally_);
  }
  // Does the path cross the edge where a ring touches it? Then the vertex there has all cones.
  bool passes_touch(const PlacedPolygon& polygon, Index edge, const SumEdge& path) {
    const std::vector<Index>& touching = polygon.touches.on(edge);
    return std::any_of(touching.begin(), touching.end(),
                       [&](Index k) { return side(path, polygon.vertex(k), tally_) == 0; });
  }

  // The translations at which the features meet; of two vertices, a line through the one that there
  // is, along an axis that the motion is not parallel to.
  [[nodiscard]] SumEdge line_of(const ContactName& name) const {
    const SumPoint origin{placed_.a.boundary.vertices[name.i],
                          negated(placed_.b.boundary.vertices[name.j])};
    if (name.kind == ContactKind::vertex_vertex) {
      const Point axis = std::abs(motion_.x) >= std::abs(motion_.y) ? Point{0, 1} : Point{1, 0};
      return {origin, {0, 0}, axis, axis.x, axis.y};
    }
    const bool is_of_a = name.kind == ContactKind::edge_vertex;
    const Direction along =
        is_of_a ? direction_of_edge(placed_.a, name.i) : direction_of_edge(placed_.b, name.j);
    return {origin, along.from, along.to, along.to.x - along.from.x, along.to.y - along.from.y};
  }

  void add(const ContactName& name) {
    const SumEdge line = line_of(name);
    const Entry entry{name, path_, line, crossing_parameter(path_, line)};
    if (entry.time.lo > limit_ || (first_ && !is_before_first(entry))) {
      return;
    }
    first_ = entry;
    limit_ = std::min(limit_, entry.time.hi);
  }
  // Comes it before the first one known?
  bool is_before_first(const Entry& entry) {
    const int order = compare_times(entry, *first_, tally_);
    return order < 0 ||
           (order == 0 && order_of(placed_, entry.name) < order_of(placed_, first_->name));
  }

  const PlacedPair& placed_;
  const Point motion_;
  const Direction direction_;
  const SumEdge path_;  // of the translation
  Tally& tally_;
  const RelativePair relative_;
  const double slack_;
  const Point scaled_motion_;
  // More than cross products are off by: those of vectors between vertices; and with the motion,
  // the differences of two.
  const double room_of_sides_;
  const double room_of_paths_;
  double limit_ = 1;  // times after this do not matter
  std::optional<Entry> first_;
};

}  // namespace

int compare_times(const Entry& p, const Entry& q, Tally& tally) {
  if (const int order = order_of(p.time, q.time); order != 0) {
    return order;
  }
  return compare_crossings(p.path, p.line, q.path, q.line, tally);
}

bool is_at_start(const Entry& entry, Tally& tally) {
  return side(entry.line, entry.path.origin, tally) == 0;
}

double time_of(const Entry& entry, Tally& tally) {
  return parameter_below(entry.path, entry.line, tally);
}

Contact contact_on_entry(const PlacedPair& placed, const ContactName& name, const Point& motion,
                         Tally& tally) {
  Contact contact;
  std::tie(contact.kind, contact.a, contact.b) = order_of(placed, name);
  if (name.kind != ContactKind::vertex_vertex) {
    contact.normal = normal_of(placed, name, tally);
  }
  const SumEdge path{placed.b.vertex(name.j), {0, 0}, motion, motion.x, motion.y};
  contact.on_a = name.kind == ContactKind::edge_vertex
                     ? nearest_crossing(placed.a.edge(name.i), path, tally)
                     : nearest_point(placed.a.vertex(name.i), tally);
  contact.on_b = contact.on_a;
  return contact;
}

std::optional<Entry> first_entry(const PlacedPair& placed, const Point& motion, Tally& tally) {
  const FirstEntry search(placed, motion, tally);
  const std::optional<Entry>& entry = search.entry();
  const bool is_before_end = entry && (entry->time.hi < 1 || time_of(*entry, tally) < 1);
  return is_before_end ? entry : std::nullopt;
}

Impact cast(const PlacedPair& placed, const Point& motion, Tally& tally) {
  if (relation(placed, tally) == Relation::overlapping) {
    const auto start = ExactPoint::of_sum({placed.b.translation, {0, 0}});
    return {true, 0, usable_position(placed.pair, start, std::nullopt, tally), {}};
  }
  if (!(motion == Point{0, 0})) {
    if (const std::optional<Entry> entry = first_entry(placed, motion, tally)) {
      const ContactName& name = entry->name;
      return {true, time_of(*entry, tally),
              usable_position(placed.pair, entry->place(), EdgePair{name.i, name.j}, tally),
              contact_on_entry(placed, name, motion, tally)};
    }
  }
  const auto end = ExactPoint::of_sum({placed.b.translation, motion});
  return {false, 1, usable_position(placed.pair, end, std::nullopt, tally), {}};
}

}  // namespace gcv
