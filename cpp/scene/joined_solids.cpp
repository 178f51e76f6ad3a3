// SPDX-License-Identifier: LGPL-3.0-or-later
#include "joined_solids.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <span>
#include <utility>

#include "curve_order.hpp"
#include "error.hpp"
#include "part_near.hpp"
#include "placed_box.hpp"

namespace gcv {

namespace {

// More vertices than that are not kept: with their trees they take some 10 MB.
constexpr Index most_kept = 1U << 16;

// Of the polygon, from that of its reflection.
Box turned_round(const Box& box) { return {-box.x1, -box.y1, -box.x0, -box.y0}; }

// How far solids that shut off the rest reach beyond a box.
double margin_of(const Box& box) {
  return ((box.x1 - box.x0) + (box.y1 - box.y0)) / 16 + 0x1p-40 * size_of(box) + 0x1p-1000;
}

Boundary ring_of(PointVector vertices) {
  for (const Point& p : vertices) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
      throw Error(
          Status::range,
          "window: it is too far from the container or the polygon, or too large, for doubles");
    }
  }
  return make_ring(std::move(vertices), "window");
}

// Everything outside of a box.
Boundary outside_of(const Box& box) {
  return ring_of({{box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}})
      .complement();
}

// Two solids, each at a corner of the window. A polygon with that box overlaps neither where it is
// at a position in the window. They reach from there beyond a box `outer`.
struct WindowSolids {
  Point low;  // their positions
  Point high;
  Boundary below;  // left of the window and below it
  Boundary above;  // right of it and above it

  WindowSolids(const Box& window, const Box& moving, const Box& outer)
      : low{window.x0, window.y0},
        high{window.x1, window.y1},
        below(ring_below(moving.x0, moving.y0, seen_from(low, outer))),
        above(ring_above(moving.x1, moving.y1, seen_from(high, outer))) {}

 private:
  static Box seen_from(const Point& corner, const Box& box) {
    return moved_outwards(box, {-corner.x, -corner.y});
  }
  // With the reflex corner (x, y).
  static Boundary ring_below(double x, double y, const Box& r) {
    return ring_of({{r.x0, r.y0}, {r.x1, r.y0}, {r.x1, y}, {x, y}, {x, r.y1}, {r.x0, r.y1}});
  }
  static Boundary ring_above(double x, double y, const Box& r) {
    return ring_of({{r.x0, y}, {x, y}, {x, r.y0}, {r.x1, r.y0}, {r.x1, r.y1}, {r.x0, r.y1}});
  }
};

// The border of a window whose solids have the vertices from `first` on.
WindowBorder border_from(Index first, const Box& window, const Boundary& reflected) {
  const auto furthest = [&](auto is_further) {
    return static_cast<Index>(first_of(reflected.vertices, is_further));
  };
  const Index highest = furthest([](const Point& p, const Point& q) { return p.y > q.y; });
  const Index rightmost = furthest([](const Point& p, const Point& q) { return p.x > q.x; });
  const Index lowest = furthest([](const Point& p, const Point& q) { return p.y < q.y; });
  const Index leftmost = furthest([](const Point& p, const Point& q) { return p.x < q.x; });
  // Edges 2 and 3 of the solid below meet in its reflex corner, edges 0 and 1 of that above.
  return {window,
          first,
          {{{EdgeName::translated, first + 2, highest},
            {EdgeName::translated, first + 3, rightmost},
            {EdgeName::translated, first + 6, lowest},
            {EdgeName::translated, first + 7, leftmost}}}};
}

class Joining {
 public:
  // What matters of it within a box, if one is given.
  void add(const Solid& solid, const std::optional<Box>& box) {
    if (box && solid.boundary.size() > few) {
      const Box seen = moved_outwards(*box, negated(solid.position));
      if (std::optional<Boundary> part = part_near(solid.boundary, seen)) {
        made_.push_back(std::move(*part));
        add(solid.id, made_.back(), solid.position);
        return;
      }
    }
    add(solid.id, solid.boundary, solid.position);
  }
  void add(Id owner, const Boundary& boundary, const Point& position) {
    parts_.push_back({boundary, position});
    owners_.insert(owners_.end(), boundary.layout.ring_count(), owner);
    size_ += boundary.size();
  }
  [[nodiscard]] Index size() const { return size_; }

  // The vertices from `first` to before `last` are those of members.
  JoinedSolids run(Index first, Index last, const std::optional<WindowBorder>& border) {
    Boundary boundary = joined(parts_);
    if (first < last) {
      boundary.crowd =
          box_of(std::span<const Point>(boundary.relatives).subspan(first, last - first));
    }
    return {std::make_shared<const Boundary>(std::move(boundary)), std::move(owners_), border};
  }

 private:
  static constexpr Index few = 64;  // vertices, of which it does not pay to leave some out

  std::deque<Boundary> made_;
  std::vector<PlacedBoundary> parts_;
  std::vector<Id> owners_;
  Index size_ = 0;
};

std::optional<Solid> container_of(const Scene& scene, const Query& query) {
  return query.admits_container() ? scene.container() : std::nullopt;
}

// Neighbours in a row, for the trees over their edges, without those that are where the same
// polygon is already.
Slots in_a_row(const Scene& scene, const Slots& slots) {
  Slots order = order_on_curve(static_cast<std::uint32_t>(slots.size()), [&](std::uint32_t k) {
    const Solid solid = scene.solid(slots[k]);
    return moved_outwards(solid.boundary.bounds, solid.position);
  });
  for (BoxForest::Slot& k : order) {
    k = slots[k];
  }
  const auto is_same = [&](BoxForest::Slot p, BoxForest::Slot q) {
    const Solid first = scene.solid(p);
    const Solid second = scene.solid(q);
    return &first.boundary == &second.boundary && first.position.x == second.position.x &&
           first.position.y == second.position.y;
  };
  order.erase(std::unique(order.begin(), order.end(), is_same), order.end());
  return order;
}

}  // namespace

Slots slots_near(const Scene& scene, const Query& query, const Box& box) {
  Slots slots;
  any_near(scene, query, box, [&](BoxForest::Slot slot) {
    slots.push_back(slot);
    return false;
  });
  std::sort(slots.begin(), slots.end());
  return slots;
}

std::shared_ptr<const JoinedSolids> join_all_solids(const Scene& scene, const Query& query,
                                                    const Boundary& reflected) {
  const bool may_be_kept = query.ignored.empty();
  std::shared_ptr<const JoinedSolids> solids =
      may_be_kept ? scene.kept_solids().find(query.layers) : nullptr;
  if (solids == nullptr) {
    solids =
        std::make_shared<const JoinedSolids>(join_solids(scene, query, reflected, std::nullopt));
    if (may_be_kept && solids->boundary->size() <= most_kept) {
      scene.kept_solids().keep(query.layers, solids);
    }
  }
  return solids;
}

JoinedSolids join_solids_near(const Scene& scene, const Query& query, const Boundary& reflected,
                              const Box& positions) {
  const Box reach = sum_outwards(positions, turned_round(reflected.bounds));
  return join_members(scene, query, slots_near(scene, query, reach), reach);
}

JoinedSolids join_members(const Scene& scene, const Query& query, const Slots& slots,
                          const std::optional<Box>& reach) {
  Joining joining;
  if (const std::optional<Solid> container = container_of(scene, query)) {
    joining.add(*container, reach);
  }
  const Index first = joining.size();
  for (const BoxForest::Slot slot : in_a_row(scene, slots)) {
    joining.add(scene.solid(slot), reach);
  }
  return joining.run(first, joining.size(), std::nullopt);
}

JoinedSolids join_solids(const Scene& scene, const Query& query, const Boundary& reflected,
                         const std::optional<Box>& window) {
  const std::optional<Solid> container = container_of(scene, query);
  if (!container && !window) {
    throw Error(
        Status::invalid_argument,
        "window: there is none, and no container for this query: the free set is unbounded");
  }
  const Box moving = turned_round(reflected.bounds);
  // What a polygon in the window can reach.
  Box reach = container ? container->boundary.bounds : empty_box;
  Box outer = reach;
  if (window) {
    reach = sum_outwards(*window, moving);
    outer = hull_of(outer, reach);
  }
  Joining joining;
  const double margin = margin_of(outer);
  const Box frame_box = widened_outwards(outer, margin);
  std::optional<Boundary> frame;
  const std::optional<Box> near = window ? std::optional(reach) : std::nullopt;
  if (container) {
    joining.add(*container, near);
  } else {
    frame.emplace(outside_of(frame_box));
    joining.add(0, *frame, {0, 0});
  }
  const Index first = joining.size();
  for (const BoxForest::Slot slot : in_a_row(scene, slots_near(scene, query, reach))) {
    joining.add(scene.solid(slot), near);
  }
  const Index last = joining.size();
  if (!window) {
    return joining.run(first, last, std::nullopt);
  }
  const WindowSolids solids(*window, moving, widened_outwards(frame_box, margin));
  const WindowBorder border = border_from(last, *window, reflected);
  joining.add(0, solids.below, solids.low);
  joining.add(0, solids.above, solids.high);
  return joining.run(first, last, border);
}

}  // namespace gcv
