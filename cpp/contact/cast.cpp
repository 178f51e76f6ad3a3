// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cast.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "box_nodes.hpp"
#include "solid_cones.hpp"

namespace gcv {

namespace {

Point negated(const Point& p) { return {-p.x, -p.y}; }

// A contact that the motion enters, and the line of translations at which its features meet. The
// path crosses it at that time.
struct Entry {
  ContactName name;
  SumEdge line;
  Interval time;
};

// The first contact that the motion enters.
class FirstEntry {
 public:
  FirstEntry(const PlacedPair& placed, const Point& motion, Tally& tally)
      : placed_(placed),
        motion_(motion),
        direction_{{0, 0}, motion},
        path_{{placed.translation, {0, 0}}, {0, 0}, motion, motion.x, motion.y},
        tally_(tally),
        a_(placed.pair.tree_a.tree),
        b_(placed.pair.tree_b.tree),
        offset_(placed.offset()),
        slack_(placed.pair.slack + 0x1p-48 * (std::abs(offset_.x) + std::abs(offset_.y) +
                                              std::abs(motion.x) + std::abs(motion.y))) {
    descend({{0, 0}, a_.box}, {{0, 0}, moved(b_.box, offset_)});
  }

  [[nodiscard]] const std::optional<Entry>& entry() const { return first_; }
  [[nodiscard]] const SumEdge& path() const { return path_; }

 private:
  struct Child {
    double time;
    std::uint32_t lane;
  };

  void descend(const BoxedNode& a, const BoxedNode& b) {
    const bool a_is_edge = a_.is_edge(a.node);
    const bool b_is_edge = b_.is_edge(b.node);
    if (a_is_edge && b_is_edge) {
      meet(a.node.index, b.node.index);
    } else if (b_is_edge || (!a_is_edge && extent(a.box) >= extent(b.box))) {
      const ChainTree::Block& block = a_.blocks[a_.block_below(a.node)];
      for_each_child_on_path(block, b.box, motion_, [&](std::uint32_t lane) {
        descend({ChainTree::child(a.node, lane), block.box(lane)}, b);
      });
    } else {
      // As seen from B, A moves backwards.
      const ChainTree::Block& block = b_.blocks[b_.block_below(b.node)];
      for_each_child_on_path(
          block, moved(a.box, negated(offset_)), negated(motion_), [&](std::uint32_t lane) {
            descend(a, {ChainTree::child(b.node, lane), moved(block.box(lane), offset_)});
          });
    }
  }

  // The children that a box meets on its way, the first one first. Those that turn out to be met
  // after a contact is entered are left out.
  template <class Visit>
  void for_each_child_on_path(const ChainTree::Block& block, const Box& box, const Point& motion,
                              Visit visit) {
    // When the box meets a child along one axis: from `first` to `last`.
    const auto times = [&](const double* low, const double* high, double box_low, double box_high,
                           double speed, SimdDouble& first, SimdDouble& last) {
      const double inverse = 1 / speed;
      const SimdDouble to_low = SimdDouble::load(low) + (-box_high - slack_);
      const SimdDouble to_high = SimdDouble::load(high) + (-box_low + slack_);
      const SimdDouble p = inverse * to_low;
      const SimdDouble q = inverse * to_high;
      first = inverse > 0 ? p : q;
      last = inverse > 0 ? q : p;
    };
    SimdDouble first_x;
    SimdDouble last_x;
    SimdDouble first_y;
    SimdDouble last_y;
    times(block.x0, block.x1, box.x0, box.x1, motion.x, first_x, last_x);
    times(block.y0, block.y1, box.y0, box.y1, motion.y, first_y, last_y);
    double first[ChainTree::width];
    double last[ChainTree::width];
    larger(first_x, first_y).store(first);
    smaller(last_x, last_y).store(last);
    Child children[ChainTree::width];
    std::uint32_t count = 0;
    for (std::uint32_t lane = 0; lane < ChainTree::width; ++lane) {
      const double reach = (1 + 0x1p-48) * last[lane] + 0x1p-48;
      if (!(first[lane] > reach) && !(last[lane] < -0x1p-48) && !(first[lane] > limit_) &&
          has_child(block, lane)) {
        std::uint32_t place = count++;
        for (; place > 0 && children[place - 1].time > first[lane]; --place) {
          children[place] = children[place - 1];
        }
        children[place] = {first[lane], lane};
      }
    }
    for (std::uint32_t k = 0; k < count && !(children[k].time > limit_); ++k) {
      visit(children[k].lane);
    }
  }

  // The paths of a vertex of B, and of one of A as seen from B, with the direction of the motion.
  [[nodiscard]] SumEdge path_of(const SumPoint& vertex) const {
    return {vertex, {0, 0}, motion_, motion_.x, motion_.y};
  }

  // The start of each of the edges and the other edge.
  void meet(Index i, Index j) {
    const SumPoint p = placed_.vertex_of_a(i);
    const SumPoint q = placed_.vertex_of_b(j);
    const SumEdge path_of_q = path_of(q);
    const int p_side = side(path_of_q, p, tally_);
    if (p_side == 0) {
      if (enters_vertices(i, j, path_of_q)) {
        add({ContactKind::vertex_vertex, i, j});
      }
      return;
    }
    // The motion enters an edge from its right to its left.
    if (p_side > 0 && side(path_of_q, placed_.vertex_of_a(placed_.a.next(i)), tally_) < 0 &&
        side(placed_.edge_of_a(i), q, tally_) <= 0 && !passes_touch_of_a(i, path_of_q)) {
      add({ContactKind::edge_vertex, i, j});
    }
    // From p, q lies on the other side of its path than p from that of q.
    const SumEdge path_of_p = path_of(p);
    if (p_side > 0 && side(path_of_p, placed_.vertex_of_b(placed_.b.next(j)), tally_) > 0 &&
        side(placed_.edge_of_b(j), p, tally_) <= 0 && !passes_touch_of_b(j, path_of_p)) {
      add({ContactKind::vertex_edge, i, j});
    }
  }

  // The vertices meet on the line of the motion. Is this ahead, and do cones overlap right after?
  bool enters_vertices(Index i, Index j, const SumEdge& path_of_q) {
    const SumEdge across = perpendicular(path_of_q, path_of_q.origin);
    return side(across, placed_.vertex_of_a(i), tally_) <= 0 &&
           overlap_once_moved(cones_of_vertex(placed_.a, placed_.pair.touches_a, i, tally_),
                              cones_of_vertex(placed_.b, placed_.pair.touches_b, j, tally_),
                              direction_, tally_);
  }
  // Does the path cross the edge where a ring touches it? Then the vertex there has all cones.
  bool passes_touch_of_a(Index i, const SumEdge& path) {
    const std::vector<Index>& touching = placed_.pair.touches_a.on(i);
    return std::any_of(touching.begin(), touching.end(),
                       [&](Index k) { return side(path, placed_.vertex_of_a(k), tally_) == 0; });
  }
  bool passes_touch_of_b(Index j, const SumEdge& path) {
    const std::vector<Index>& touching = placed_.pair.touches_b.on(j);
    return std::any_of(touching.begin(), touching.end(),
                       [&](Index k) { return side(path, placed_.vertex_of_b(k), tally_) == 0; });
  }

  // The translations at which the features meet; of two vertices, a line through the one that there
  // is, along an axis that the motion is not parallel to.
  [[nodiscard]] SumEdge line_of(const ContactName& name) const {
    const SumPoint origin{placed_.a.vertices[name.i], negated(placed_.b.vertices[name.j])};
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
    const Interval time = crossing_parameter(path_, line);
    if (time.lo > limit_ || (first_ && !is_before(name, line, time))) {
      return;
    }
    first_ = {name, line, time};
    limit_ = std::min(limit_, time.hi);
  }
  // Comes the contact before the first one known?
  bool is_before(const ContactName& name, const SumEdge& line, const Interval& time) {
    if (time.hi < first_->time.lo || time.lo > first_->time.hi) {
      return time.hi < first_->time.lo;
    }
    const int order = compare_crossings(path_, line, first_->line, tally_);
    return order < 0 || (order == 0 && order_of(placed_, name) < order_of(placed_, first_->name));
  }

  const PlacedPair& placed_;
  const Point motion_;
  const Direction direction_;
  const SumEdge path_;  // of the translation
  Tally& tally_;
  const ChainTree& a_;
  const ChainTree& b_;
  const Point offset_;
  const double slack_;
  double limit_ = 1;  // times after this do not matter
  std::optional<Entry> first_;
};

// Does the path cross the line before the end of the motion?
bool is_before_end(const SumEdge& path, const Entry& entry, Tally& tally) {
  if (entry.time.hi < 1) {
    return true;
  }
  const SumEdge end = perpendicular(path, {path.origin.a, path.to});
  return compare_crossings(path, entry.line, end, tally) < 0;
}

// The contact when it is entered: its features meet in one point.
Contact contact_on_entry(const PlacedPair& placed, const ContactName& name, const Point& motion,
                         Tally& tally) {
  Contact contact;
  std::tie(contact.kind, contact.a, contact.b) = order_of(placed, name);
  if (name.kind != ContactKind::vertex_vertex) {
    contact.normal = normal_of(placed, name, tally);
  }
  const SumEdge path{placed.vertex_of_b(name.j), {0, 0}, motion, motion.x, motion.y};
  contact.on_a = name.kind == ContactKind::edge_vertex
                     ? nearest_crossing(placed.edge_of_a(name.i), path, tally)
                     : placed.a.vertices[name.i];
  contact.on_b = contact.on_a;
  return contact;
}

}  // namespace

Impact cast(const PlacedPair& placed, const Point& motion, Tally& tally) {
  if (relation(placed, tally) == Relation::overlapping) {
    const auto start = ExactTranslation::of_sum({placed.translation, {0, 0}});
    return {true, 0, usable_position(placed.pair, start, tally), {}};
  }
  if (!(motion == Point{0, 0})) {
    const FirstEntry search(placed, motion, tally);
    if (search.entry() && is_before_end(search.path(), *search.entry(), tally)) {
      const SumEdge& path = search.path();
      const auto& [name, line, time] = *search.entry();
      const auto position = ExactTranslation::of_crossing(path, line);
      return {true, parameter_below(path, line, tally),
              usable_position(placed.pair, position, tally),
              contact_on_entry(placed, name, motion, tally)};
    }
  }
  const auto end = ExactTranslation::of_sum({placed.translation, motion});
  return {false, 1, usable_position(placed.pair, end, tally), {}};
}

}  // namespace gcv
