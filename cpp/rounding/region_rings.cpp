// SPDX-License-Identifier: LGPL-3.0-or-later
#include "region_rings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

#include "box.hpp"
#include "cycle.hpp"
#include "error.hpp"
#include "polygon.hpp"
#include "predicates.hpp"
#include "repair.hpp"
#include "ring_conflicts.hpp"
#include "rounding.hpp"
#include "simplicity.hpp"
#include "snap_rounding.hpp"
#include "task.hpp"
#include "units.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

double extents_of(std::span<const Point> points) {
  const Box box = box_of(points);
  return length_bound(box.x1 - box.x0, box.y1 - box.y0);
}

PointVector reversed(PointVector ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

PointVector ring_of(const RegionRings& rings, const RoundingRing& ring) {
  return ring.replaced ? *ring.replaced : snap(rings.places_of(*ring.part)).vertices;
}

// Of the rings that are left.
std::vector<PointVector> rings_left(RegionRings& rings, std::vector<RoundingRing*>& left,
                                    Pace& pace) {
  std::vector<PointVector> points;
  for (RoundingRing& ring : rings.rings) {
    if (!ring.is_dropped) {
      pace.step(8 * ring.part->size);
      left.push_back(&ring);
      points.push_back(ring_of(rings, ring));
    }
  }
  return points;
}

// With its holes, if it has any.
void drop(RegionRings& rings, RoundingRing& ring) {
  ring.is_dropped = true;
  ++rings.dropped;
  const std::span<const Point> nearest = rings.nearest;
  rings.lost = std::max(rings.lost, extents_of(nearest.subspan(ring.part->first, ring.part->size)));
  if (ring.part->kind == PartKind::outer) {
    for (RoundingRing& hole : rings.rings) {
      if (!hole.is_dropped && hole.part->polygon == ring.part->polygon) {
        drop(rings, hole);
      }
    }
  }
}

bool holds(const Box& box, const Point& p) {
  return p.x >= box.x0 && p.x <= box.x1 && p.y >= box.y0 && p.y <= box.y1;
}

// Is the point inside the ring? Nothing if it lies on the ring.
std::optional<bool> is_inside(const PointVector& ring, const Point& p, Tally& tally) {
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point& from = ring[k];
    const Point& to = ring[cyclic_next(k, ring.size())];
    const int side = orientation(from, to, p, tally);
    if (side == 0 && holds(box_of(from, to), p)) {
      return std::nullopt;
    }
    if ((from.y > p.y) != (to.y > p.y)) {
      inside = inside != ((side > 0) == (to.y > p.y));
    }
  }
  return inside;
}

// Rings that do not cross can have come to lie on the wrong side of each other, where they are thin
// and close together.
class NestingCheck {
 public:
  NestingCheck(RegionRings& rings, Tally& tally) : rings_(rings), tally_(tally) {}

  // Drops what lies there.
  void run() {
    std::vector<RoundingRing*> left;
    const double moved = std::max(rings_.furthest, rings_.displaced);
    const bool are_near =
        are_rings_near(rings_left(rings_, left, pace_), 2 * sum_bound(rings_.error_bound, moved));
    for (RoundingRing* const outer : left) {
      if (are_near && outer->part->kind == PartKind::outer && !outer->is_dropped) {
        drop_misplaced_holes(*outer);
      }
    }
    if (are_near || rings_.dropped > 0) {
      drop_nested();
    }
  }

 private:
  // Polygons that have come to lie in the inside of another one, or do where a hole was dropped:
  // there an odd number of rings of others lies round them.
  void drop_nested() {
    std::vector<RoundingRing*> left;
    const std::vector<PointVector> points = rings_left(rings_, left, pace_);
    std::vector<Box> boxes;
    boxes.reserve(points.size());
    for (const PointVector& ring : points) {
      boxes.push_back(box_of(ring));
    }
    // Of a point of ring r. Nothing if it lies on another ring.
    const auto is_in_other = [&](std::size_t r, const Point& p) -> std::optional<bool> {
      bool is_odd = false;
      for (std::size_t k = 0; k < left.size(); ++k) {
        pace_.step();
        if (left[k]->is_dropped || left[k]->part->polygon == left[r]->part->polygon ||
            !holds(boxes[k], p)) {
          continue;
        }
        pace_.step(points[k].size());
        const std::optional<bool> inside = is_inside(points[k], p, tally_);
        if (!inside) {
          return std::nullopt;
        }
        is_odd = is_odd != *inside;
      }
      return is_odd;
    };
    const auto is_nested = [&](std::size_t r) {
      for (const Point& p : points[r]) {
        if (const std::optional<bool> result = is_in_other(r, p)) {
          return *result;
        }
      }
      return false;
    };
    for (std::size_t r = 0; r < left.size(); ++r) {
      RoundingRing& ring = *left[r];
      if (ring.part->kind == PartKind::outer && !ring.is_fixed && !ring.is_dropped &&
          is_nested(r)) {
        drop(rings_, ring);
      }
    }
  }

  void drop_misplaced_holes(const RoundingRing& outer) {
    std::vector<RoundingRing*> holes;
    for (RoundingRing& ring : rings_.rings) {
      if (!ring.is_dropped && ring.part->kind == PartKind::hole &&
          ring.part->polygon == outer.part->polygon) {
        holes.push_back(&ring);
      }
    }
    if (holes.empty() || is_polygon(outer, holes)) {
      return;
    }
    std::vector<RoundingRing*> good;
    for (RoundingRing* const hole : holes) {
      good.push_back(hole);
      if (!is_polygon(outer, good)) {
        good.pop_back();
        drop(rings_, *hole);
      }
    }
  }

  [[nodiscard]] bool is_polygon(const RoundingRing& outer,
                                const std::vector<RoundingRing*>& holes) const {
    std::vector<PointVector> boundaries{ring_of(rings_, outer)};
    for (const RoundingRing* const hole : holes) {
      boundaries.push_back(ring_of(rings_, *hole));
    }
    try {
      static_cast<void>(make_polygon(std::move(boundaries), "polygon"));
      return true;
    } catch (const Error& error) {
      if (error.status() == Status::not_simple || error.status() == Status::degenerate) {
        return false;
      }
      throw;
    }
  }

  RegionRings& rings_;
  Tally& tally_;
  Pace pace_;
};

class Validator {
 public:
  Validator(RegionRings& rings, Tally& tally) : rings_(rings), tally_(tally) {}

  void run() {
    for (RoundingRing& ring : rings_.rings) {
      if (!ring.is_fixed && !ring.is_dropped) {
        pace_.step(16 * ring.part->size);
        widen(ring);
      }
    }
    if (!are_apart_rings() && !separate_rings()) {
      drop_conflicting();
    }
    NestingCheck(rings_, tally_).run();
  }

 private:
  [[nodiscard]] static bool is_turned_right(const RoundingRing& ring, const PointVector& points) {
    return is_counter_clockwise(points) == (ring.part->kind == PartKind::outer);
  }

  // Do rings neither cross themselves nor each other, and turn as they are to?
  bool are_apart_rings() {
    std::vector<RoundingRing*> left;
    const std::vector<PointVector> points = rings_left(rings_, left, pace_);
    for (std::size_t k = 0; k < left.size(); ++k) {
      if (!is_turned_right(*left[k], points[k])) {
        return false;
      }
    }
    return find_ring_conflicts(points).empty();
  }

  // A ring that has become a segment, or has turned over. Moves one of its vertices by a unit in
  // the last place, so that it has an area. Drops the ring if that cannot be.
  void widen(RoundingRing& ring) {
    const RegionPart& part = *ring.part;
    SnappedRing snapped = snap(rings_.places_of(part));
    const std::size_t distinct = snapped.vertices.size();
    if (distinct >= 3 &&
        (find_conflict(snapped.vertices) || is_turned_right(ring, snapped.vertices))) {
      return;
    }
    const int wanted = part.kind == PartKind::outer ? 1 : -1;
    const std::size_t n = part.size;
    for (std::size_t k = 0; k < n && distinct >= 2; ++k) {
      const Point& before = rings_.places[part.first + cyclic_previous(k, n)];
      const Point& after = rings_.places[part.first + cyclic_next(k, n)];
      Point& place = rings_.places[part.first + k];
      const Point old = place;
      for (const Point& other : neighbours(old)) {
        place = other;
        const PointVector points = snap(rings_.places_of(part)).vertices;
        if (orientation(before, other, after, tally_) == wanted && points.size() >= 3 &&
            !find_conflict(points) && is_turned_right(ring, points)) {
          note_move(part.first + k);
          return;
        }
      }
      place = old;
    }
    drop(rings_, ring);
  }

  // The doubles next to a point.
  static std::vector<Point> neighbours(const Point& p) {
    const auto next = [](double x, int way) {
      return way == 0 ? x : std::nextafter(x, way * infinity);
    };
    std::vector<Point> points;
    for (const auto& [x, y] :
         {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
      const Point q{next(p.x, x) + 0.0, next(p.y, y) + 0.0};
      if (std::isfinite(q.x) && std::isfinite(q.y)) {
        points.push_back(q);
      }
    }
    return points;
  }

  void note_move(std::size_t k) {
    const Point& p = rings_.places[k];
    const Point& q = rings_.nearest[k];
    if (!(p == q)) {
      ++rings_.repaired;
      rings_.furthest = std::max(rings_.furthest, length_bound(p.x - q.x, p.y - q.y));
    }
  }

  bool separate_rings() {
    std::vector<RingRange> ranges;
    for (const RoundingRing& ring : rings_.rings) {
      if (ring.replaced) {
        return false;
      }
      if (!ring.is_dropped) {
        ranges.push_back(
            {ring.part->first, ring.part->size, ring.part->kind == PartKind::outer, ring.is_fixed});
      }
    }
    std::optional<PointVector> separated = separate(rings_.region, ranges, rings_.places, tally_);
    if (!separated) {
      return false;
    }
    rings_.places = std::move(*separated);
    for (const RingRange& range : ranges) {
      for (std::size_t k = range.first; !range.is_fixed && k < range.first + range.size; ++k) {
        note_move(k);
      }
    }
    return true;
  }

  // Drops the rings that are in the way of larger ones, which stay. A ring that crosses itself is
  // replaced by its largest part first.
  void drop_conflicting() {
    for (RoundingRing& ring : rings_.rings) {
      if (!ring.is_fixed && !ring.is_dropped) {
        replace_crossing(ring);
      }
    }
    std::vector<RoundingRing*> left;
    const std::vector<PointVector> points = rings_left(rings_, left, pace_);
    std::vector<double> sizes;
    std::vector<std::size_t> by_size;
    for (std::size_t r = 0; r < left.size(); ++r) {
      sizes.push_back(left[r]->is_fixed ? infinity : extents_of(points[r]));
      by_size.push_back(r);
    }
    std::stable_sort(by_size.begin(), by_size.end(),
                     [&](std::size_t r, std::size_t s) { return sizes[r] > sizes[s]; });
    std::vector<std::size_t> rank(left.size());
    for (std::size_t k = 0; k < by_size.size(); ++k) {
      rank[by_size[k]] = k;
    }
    // The rank of the smaller ring first, so that what is in the way of it is decided by then.
    std::vector<std::pair<std::size_t, std::size_t>> conflicts;
    for (const auto& [e, f] : find_ring_conflicts(points)) {
      conflicts.push_back(std::minmax({rank[e.ring], rank[f.ring]}, std::greater<>()));
    }
    std::sort(conflicts.begin(), conflicts.end());
    for (const auto& [smaller, larger] : conflicts) {
      RoundingRing& ring = *left[by_size[smaller]];
      if (!ring.is_dropped && !left[by_size[larger]]->is_dropped) {
        drop(rings_, ring);
      }
    }
  }

  void replace_crossing(RoundingRing& ring) {
    const PointVector points = snap(rings_.places_of(*ring.part)).vertices;
    if (!find_conflict(points)) {
      if (!is_turned_right(ring, points)) {
        drop(rings_, ring);
      }
      return;
    }
    const std::optional<SnapRoundedRing> snapped = snap_round(points, tally_);
    if (!snapped) {
      drop(rings_, ring);
      return;
    }
    ring.replaced = ring_through(ring.part->kind == PartKind::outer ? snapped->vertices
                                                                    : reversed(snapped->vertices));
    rings_.displaced = std::max(rings_.displaced, snapped->error_bound);
    rings_.repaired += ring.replaced->size();
  }

  RegionRings& rings_;
  Tally& tally_;
  Pace pace_;
};

}  // namespace

void make_valid(RegionRings& rings, Tally& tally) { Validator(rings, tally).run(); }

}  // namespace gcv
