// SPDX-License-Identifier: LGPL-3.0-or-later
#include "region_rounding.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "box.hpp"
#include "cycle.hpp"
#include "error.hpp"
#include "exact_indices.hpp"
#include "polygon.hpp"
#include "predicates.hpp"
#include "repair.hpp"
#include "ring_conflicts.hpp"
#include "ring_predicates.hpp"
#include "rounding.hpp"
#include "simplicity.hpp"
#include "snap_rounding.hpp"
#include "units.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

// A ring on its way to doubles.
struct RoundingRing {
  const RegionPart* part;
  bool is_fixed = false;
  bool is_dropped = false;
  // Its vertices, where these are no longer the places of the exact ones.
  std::optional<PointVector> replaced;
};

double extents_of(std::span<const Point> points) {
  const Box box = box_of(points);
  return length_bound(box.x1 - box.x0, box.y1 - box.y0);
}

PointVector reversed(PointVector ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

class RegionRounder {
 public:
  RegionRounder(const ExactRegion& region, Task& task, Tally& tally)
      : region_(region), task_(task), tally_(tally) {}

  RoundedRegion run(bool has_outer_face) {
    for (const RegionPart& part : region_.parts) {
      if (part.is_ring()) {
        rings_.push_back({&part, false, false, {}});
      }
    }
    place(has_outer_face);
    if (error_bound_ > 0 && !rings_.empty()) {
      make_valid();
    }
    return result();
  }

 private:
  [[nodiscard]] std::span<const Point> places(const RegionPart& part) const {
    return std::span(places_).subspan(part.first, part.size);
  }

  // The nearest doubles. An outer face is rounded by itself.
  void place(bool has_outer_face) {
    const std::size_t begin = has_outer_face ? region_.parts.front().size : 0;
    if (has_outer_face) {
      place_outer_face(begin);
    }
    ExactRing rest{region_.a, region_.b, region_.shift, {}, false, region_.against_edges};
    rest.vertices.assign(region_.vertices.begin() + static_cast<std::ptrdiff_t>(begin),
                         region_.vertices.end());
    Placement placement = place_nearest(rest, task_, tally_);
    places_.insert(places_.end(), placement.places.begin(), placement.places.end());
    nearest_.insert(nearest_.end(), placement.places.begin(), placement.places.end());
    error_bound_ = std::max(error_bound_, placement.error_bound);
  }

  void place_outer_face(std::size_t size) {
    ExactRing outer{region_.a, region_.b, region_.shift, {}, region_.chains_are_repeated,
                    region_.against_edges};
    outer.vertices.assign(region_.vertices.begin(),
                          region_.vertices.begin() + static_cast<std::ptrdiff_t>(size));
    Placement placement = place_nearest(outer, task_, tally_);
    nearest_ = placement.places;
    rings_.front().is_fixed = true;
    if (make_simple(outer, placement, task_, tally_)) {
      error_bound_ = placement.error_bound;
      repaired_ = placement.repaired;
      places_ = std::move(placement.places);
      return;
    }
    RoundedRing rounded = gcv::round_to_nearest(outer, task_, tally_);
    error_bound_ = rounded.error_bound;
    repaired_ = rounded.vertices_repaired;
    places_ = nearest_;
    rings_.front().replaced = std::move(rounded.vertices);
  }

  [[nodiscard]] PointVector ring_of(const RoundingRing& ring) const {
    return ring.replaced ? *ring.replaced : snap(places(*ring.part)).vertices;
  }
  // Of the rings that are left.
  [[nodiscard]] std::vector<PointVector> rings_left(std::vector<RoundingRing*>& left) {
    std::vector<PointVector> points;
    for (RoundingRing& ring : rings_) {
      if (!ring.is_dropped) {
        left.push_back(&ring);
        points.push_back(ring_of(ring));
      }
    }
    return points;
  }
  [[nodiscard]] static bool is_turned_right(const RoundingRing& ring, const PointVector& points) {
    return is_counter_clockwise(points) == (ring.part->kind == PartKind::outer);
  }

  void make_valid() {
    for (RoundingRing& ring : rings_) {
      if (!ring.is_fixed) {
        widen(ring);
      }
    }
    if (!are_apart_rings() && !separate_rings()) {
      drop_conflicting();
    }
    drop_misplaced();
  }

  // Do rings neither cross themselves nor each other, and turn as they are to?
  bool are_apart_rings() {
    std::vector<RoundingRing*> left;
    const std::vector<PointVector> points = rings_left(left);
    for (std::size_t k = 0; k < left.size(); ++k) {
      if (!is_turned_right(*left[k], points[k])) {
        return false;
      }
    }
    return find_ring_conflicts(points).empty();
  }

  // A ring that has become a segment, or has turned over. Moves one of its vertices by a unit in the
  // last place, so that it has an area. Drops the ring if that cannot be.
  void widen(RoundingRing& ring) {
    const RegionPart& part = *ring.part;
    SnappedRing snapped = snap(places(part));
    const std::size_t distinct = snapped.vertices.size();
    if (distinct >= 3 && (find_conflict(snapped.vertices) || is_turned_right(ring, snapped.vertices))) {
      return;
    }
    const int wanted = part.kind == PartKind::outer ? 1 : -1;
    const std::size_t n = part.size;
    for (std::size_t k = 0; k < n && distinct >= 2; ++k) {
      const Point& before = places_[part.first + cyclic_previous(k, n)];
      const Point& after = places_[part.first + cyclic_next(k, n)];
      Point& place = places_[part.first + k];
      const Point old = place;
      for (const Point& other : neighbours(old)) {
        place = other;
        const PointVector points = snap(places(part)).vertices;
        if (orientation(before, other, after, tally_) == wanted && points.size() >= 3 &&
            !find_conflict(points) && is_turned_right(ring, points)) {
          note_move(part.first + k);
          return;
        }
      }
      place = old;
    }
    drop(ring);
  }

  // The doubles next to a point.
  static std::vector<Point> neighbours(const Point& p) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto next = [](double x, int way) {
      return way == 0 ? x : std::nextafter(x, way * infinity);
    };
    std::vector<Point> points;
    for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1},
                               {-1, -1}}) {
      const Point q{next(p.x, x) + 0.0, next(p.y, y) + 0.0};
      if (std::isfinite(q.x) && std::isfinite(q.y)) {
        points.push_back(q);
      }
    }
    return points;
  }

  void note_move(std::size_t k) {
    const Point& p = places_[k];
    const Point& q = nearest_[k];
    if (!(p == q)) {
      ++repaired_;
      furthest_ = std::max(furthest_, length_bound(p.x - q.x, p.y - q.y));
    }
  }

  bool separate_rings() {
    std::vector<RingRange> ranges;
    for (const RoundingRing& ring : rings_) {
      if (ring.replaced) {
        return false;
      }
      if (!ring.is_dropped) {
        ranges.push_back({ring.part->first, ring.part->size, ring.part->kind == PartKind::outer,
                          ring.is_fixed});
      }
    }
    std::optional<PointVector> separated = separate(region_, ranges, places_, tally_);
    if (!separated) {
      return false;
    }
    places_ = std::move(*separated);
    for (const RingRange& range : ranges) {
      for (std::size_t k = range.first; !range.is_fixed && k < range.first + range.size; ++k) {
        note_move(k);
      }
    }
    return true;
  }

  void drop(RoundingRing& ring) {
    ring.is_dropped = true;
    ++dropped_;
    lost_ = std::max(lost_, extents_of(places(*ring.part)));
    if (ring.part->kind == PartKind::outer) {
      for (RoundingRing& hole : rings_) {
        if (!hole.is_dropped && hole.part->polygon == ring.part->polygon) {
          drop(hole);
        }
      }
    }
  }

  // Drops the smallest rings that are in the way, until none is. A ring that crosses itself is
  // replaced by its largest part first.
  void drop_conflicting() {
    for (RoundingRing& ring : rings_) {
      if (!ring.is_fixed && !ring.is_dropped) {
        replace_crossing(ring);
      }
    }
    while (true) {
      std::vector<RoundingRing*> left;
      const std::vector<PointVector> points = rings_left(left);
      const std::vector<RingConflict> conflicts = find_ring_conflicts(points);
      RoundingRing* smallest = nullptr;
      double least = 0;
      for (const auto& [e, f] : conflicts) {
        for (const std::size_t r : {e.ring, f.ring}) {
          const double extents = extents_of(points[r]);
          if (!left[r]->is_fixed && (smallest == nullptr || extents < least)) {
            smallest = left[r];
            least = extents;
          }
        }
      }
      if (smallest == nullptr) {
        return;
      }
      drop(*smallest);
    }
  }

  void replace_crossing(RoundingRing& ring) {
    const PointVector points = snap(places(*ring.part)).vertices;
    if (!find_conflict(points)) {
      if (!is_turned_right(ring, points)) {
        drop(ring);
      }
      return;
    }
    const std::optional<SnapRoundedRing> snapped = snap_round(points, tally_);
    if (!snapped) {
      drop(ring);
      return;
    }
    ring.replaced = ring_through(ring.part->kind == PartKind::outer
                                     ? snapped->vertices
                                     : reversed(snapped->vertices));
    displaced_ = std::max(displaced_, snapped->error_bound);
    repaired_ += ring.replaced->size();
  }

  // Rings that do not cross can have come to lie on the wrong side of each other, where they are
  // thin and close together.
  void drop_misplaced() {
    std::vector<RoundingRing*> left;
    if (!are_rings_near(rings_left(left), 2 * sum_bound(error_bound_, furthest_))) {
      return;
    }
    for (RoundingRing* const outer : left) {
      if (outer->part->kind == PartKind::outer && !outer->is_dropped) {
        drop_misplaced_holes(*outer);
      }
    }
  }

  void drop_misplaced_holes(const RoundingRing& outer) {
    std::vector<RoundingRing*> holes;
    for (RoundingRing& ring : rings_) {
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
        drop(*hole);
      }
    }
  }

  [[nodiscard]] bool is_polygon(const RoundingRing& outer, const std::vector<RoundingRing*>& holes) const {
    std::vector<PointVector> boundaries{ring_of(outer)};
    for (const RoundingRing* const hole : holes) {
      boundaries.push_back(ring_of(*hole));
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

  RoundedRegion result() {
    RoundedRegion rounded;
    Index polygon = RegionPart::no_polygon;
    for (const RoundingRing& ring : rings_) {
      if (ring.is_dropped) {
        continue;
      }
      const RegionPart& part = *ring.part;
      polygon += part.kind == PartKind::outer ? 1 : 0;
      const std::size_t first = rounded.vertices.size();
      if (ring.replaced) {
        add_replaced(ring, rounded);
      } else {
        add_places(part, &ring == &rings_.front() && ring.is_fixed, rounded);
      }
      rounded.parts.push_back({part.kind, polygon, first, rounded.vertices.size() - first});
    }
    add_fits(rounded);
    rounded.displacement = sum_bound(error_bound_, std::max(furthest_, displaced_));
    rounded.error_bound = std::max(rounded.displacement, sum_bound(error_bound_, lost_));
    rounded.vertices_repaired = repaired_;
    rounded.parts_dropped = dropped_;
    return rounded;
  }

  // Each place once, from that of the first vertex on. An outer face begins with its smallest place.
  void add_places(const RegionPart& part, bool from_smallest, RoundedRegion& rounded) const {
    const std::span<const Point> all = places(part);
    std::size_t size = all.size();
    while (size > 1 && all[size - 1] == all[0]) {
      --size;  // these belong to the first place
    }
    const std::size_t begin = rounded.vertices.size();
    for (std::size_t k = 0; k < size; ++k) {
      if (k == 0 || !(all[k] == all[k - 1])) {
        rounded.vertices.push_back(all[k]);
        rounded.exact_indices.push_back(part.first + k);
      }
    }
    if (from_smallest) {
      const std::span<const Point> ring = std::span(rounded.vertices).subspan(begin);
      const auto smallest = static_cast<std::ptrdiff_t>(begin + lexicographic_min(ring));
      const auto from = static_cast<std::ptrdiff_t>(begin);
      std::rotate(rounded.vertices.begin() + from, rounded.vertices.begin() + smallest,
                  rounded.vertices.end());
      std::rotate(rounded.exact_indices.begin() + from, rounded.exact_indices.begin() + smallest,
                  rounded.exact_indices.end());
    }
  }

  void add_replaced(const RoundingRing& ring, RoundedRegion& rounded) const {
    const RegionPart& part = *ring.part;
    const std::span<const Point> exact = std::span(nearest_).subspan(part.first, part.size);
    for (const std::size_t index : closest_edges(exact, *ring.replaced)) {
      rounded.exact_indices.push_back(part.first + index);
    }
    rounded.vertices.insert(rounded.vertices.end(), ring.replaced->begin(), ring.replaced->end());
  }

  void add_fits(RoundedRegion& rounded) const {
    std::vector<const RegionPart*> points;
    const auto add = [&](const RegionPart& part, PartKind kind, std::size_t size) {
      rounded.parts.push_back({kind, RegionPart::no_polygon, rounded.vertices.size(), size});
      for (std::size_t k = part.first; k < part.first + size; ++k) {
        rounded.vertices.push_back(places_[k]);
        rounded.exact_indices.push_back(k);
      }
    };
    for (const RegionPart& part : region_.parts) {
      if (part.kind == PartKind::segment && !(places_[part.first] == places_[part.first + 1])) {
        add(part, PartKind::segment, 2);
      } else if (!part.is_ring()) {
        points.push_back(&part);
      }
    }
    for (const RegionPart* const part : points) {
      add(*part, PartKind::point, 1);
    }
  }

  const ExactRegion& region_;
  Task& task_;
  Tally& tally_;
  std::vector<RoundingRing> rings_;
  PointVector nearest_;
  PointVector places_;
  double error_bound_ = 0;  // of the nearest doubles, and of the outer face
  double furthest_ = 0;     // that a vertex was moved
  double displaced_ = 0;    // that a ring was, by snap rounding
  double lost_ = 0;         // with what was dropped
  std::uint64_t repaired_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace

RoundedRegion round_to_nearest(const ExactRegion& region, bool has_outer_face, Task& task,
                               Tally& tally) {
  return RegionRounder(region, task, tally).run(has_outer_face);
}

}  // namespace gcv
