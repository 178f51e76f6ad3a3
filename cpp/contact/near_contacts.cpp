// SPDX-License-Identifier: LGPL-3.0-or-later
#include "near_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "predicates.hpp"
#include "relative_pair.hpp"
#include "slope.hpp"
#include "solid_cones.hpp"

namespace gcv {

namespace {

class NearContacts {
 public:
  NearContacts(const PlacedPair& placed, double distance, double slope, Task& task, Tally& tally)
      : placed_(placed),
        distance_(distance),
        slope_(slope),
        task_(task),
        tally_(tally),
        relative_(placed),
        limit_(relative_.limit_of_squares(relative_.scale() * distance)) {
    relative_.descend(*this);
    task_.advance(pairs_);
  }

  template <class Visit>
  bool any_child(const ChainTree::Block& block, const Box& box, bool /*is_of_a*/, Visit visit) {
    const unsigned far = (relative_.squares_of_distances(block, box) > limit_).bits();
    for_each_lane(children_of(block) & ~far, visit);
    return false;
  }

  [[nodiscard]] bool are_beyond_reach(const ChainTree::Node& a, const ChainTree::Node& b) const {
    const double gap = relative_.gap_between(a, b);
    return gap > 0 && gap * gap > limit_;
  }

  // The start of each of the edges, the other edge, and its start.
  bool meet(Index i, Index j) {
    count_pair();
    const bool p_is_convex = placed_.a.boundary.corners[i].convex;
    const bool q_is_convex = placed_.b.boundary.corners[j].convex;
    if (!p_is_convex && !q_is_convex) {
      return false;
    }
    const RelativePair::Ends p = relative_.edge_of_a(i);
    const RelativePair::Ends q = relative_.edge_of_b(j);
    const bool q_is_near =
        q_is_convex && !(RelativePair::square_of_distance(p, q.from_x, q.from_y) > limit_);
    const bool p_is_near =
        p_is_convex && !(RelativePair::square_of_distance(q, p.from_x, p.from_y) > limit_);
    // Directions take longer. Starts that are near each other are near both edges.
    if (!q_is_near && !p_is_near) {
      return false;
    }
    const bool q_is_admitted = q_is_convex && admits(placed_.a, i, placed_.b, j);
    const bool p_is_admitted = p_is_convex && admits(placed_.b, j, placed_.a, i);
    if (q_is_admitted && q_is_near) {
      add({ContactKind::edge_vertex, i, j});
    }
    if (p_is_admitted && p_is_near) {
      add({ContactKind::vertex_edge, i, j});
    }
    if (p_is_convex && q_is_convex &&
        !(RelativePair::square(q.from_x - p.from_x, q.from_y - p.from_y) > limit_) &&
        (q_is_admitted || p_is_admitted ||
         admits(placed_.a, placed_.a.boundary.previous(i), placed_.b, j) ||
         admits(placed_.b, placed_.b.boundary.previous(j), placed_.a, i))) {
      add({ContactKind::vertex_vertex, i, j});
    }
    return false;
  }

  std::vector<Contact>& contacts() { return contacts_; }

 private:
  void count_pair() {
    pace_.step(4);
    if (++pairs_ == Task::portion) {
      task_.advance(pairs_);
      pairs_ = 0;
    }
  }

  // Does the edge admit the convex vertex?
  bool admits(const PlacedPolygon& of_edge, Index edge, const PlacedPolygon& of_vertex,
              Index vertex) {
    const Direction along = direction_of_edge(of_edge, edge);
    const Direction leaving = direction_of_edge(of_vertex, vertex);
    const Direction arriving = direction_of_edge(of_vertex, of_vertex.boundary.previous(vertex));
    if (turn(along.from, along.to, leaving.from, leaving.to, tally_) <= 0 &&
        turn(along.from, along.to, arriving.from, arriving.to, tally_) >= 0) {
      return true;
    }
    return slope_ > 0 && (is_near(leaving, along) || is_near(arriving, along));
  }
  // Is the first direction within the slope against the second one?
  bool is_near(const Direction& p, const Direction& q) {
    return is_within_slope(p.from, p.to, q.to, q.from, slope_, tally_);
  }

  void add(const ContactName& name) {
    const Gap gap = gap_of(placed_, name, tally_);
    if (compare_gap(gap, distance_, tally_) > 0) {
      return;
    }
    Contact contact = contact_of(placed_, name, gap, tally_);
    if (name.kind != ContactKind::vertex_vertex) {
      const EdgeAndVertex pair = edge_and_vertex(placed_, name);
      if (side(pair.edge, pair.vertex, tally_) > 0) {
        contact.gap = 0.0 - contact.gap;
      }
    }
    contacts_.push_back(contact);
  }

  const PlacedPair& placed_;
  const double distance_;
  const double slope_;
  Task& task_;
  Tally& tally_;
  const RelativePair relative_;
  const double limit_;
  std::uint64_t pairs_ = 0;
  Pace pace_;  // the task may not be the one that the caller can cancel
  std::vector<Contact> contacts_;
};

}  // namespace

std::vector<Contact> near_contacts(const PlacedPair& placed, double distance, double slope,
                                   Task& task, Tally& tally) {
  std::vector<Contact> contacts =
      std::move(NearContacts(placed, distance, slope, task, tally).contacts());
  Pace pace;
  const auto key = [](const Contact& c) { return std::tuple(std::abs(c.gap), c.kind, c.a, c.b); };
  std::sort(contacts.begin(), contacts.end(), [&](const Contact& p, const Contact& q) {
    pace.step();
    return key(p) < key(q);
  });
  return contacts;
}

}  // namespace gcv
