// SPDX-License-Identifier: LGPL-3.0-or-later
#include "region_rounding.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "exact_indices.hpp"
#include "region_rings.hpp"
#include "rounding.hpp"
#include "units.hpp"

namespace gcv {

namespace {

// Appends the places of a ring. `first`: the number of its first vertex.
void add_places(std::span<const Point> places, std::size_t first, bool from_smallest,
                RoundedRegion& rounded) {
  const auto [distinct, indices] = distinct_places(places, first, from_smallest);
  rounded.vertices.insert(rounded.vertices.end(), distinct.begin(), distinct.end());
  rounded.exact_indices.insert(rounded.exact_indices.end(), indices.begin(), indices.end());
}

// A region that is an outer face and nothing else.
RoundedRegion round_outer_face(const ExactRegion& region, Task& task, Tally& tally) {
  Placement placement = place_nearest(region, task, tally);
  RoundedRegion rounded;
  if (make_simple(region, placement, task, tally)) {
    rounded.vertices.reserve(region.size());
    rounded.exact_indices.reserve(region.size());
    add_places(placement.places, 0, true, rounded);
    rounded.error_bound = placement.error_bound;
    rounded.vertices_repaired = placement.repaired;
  } else {
    RoundedRing ring = gcv::round_to_nearest(static_cast<const ExactRing&>(region), task, tally);
    const std::vector<std::size_t> indices = closest_edges(placement.places, ring.vertices, task);
    rounded.exact_indices.assign(indices.begin(), indices.end());
    rounded.vertices = std::move(ring.vertices);
    rounded.error_bound = ring.error_bound;
    rounded.vertices_repaired = ring.vertices_repaired;
  }
  rounded.displacement = rounded.error_bound;
  rounded.parts.push_back({PartKind::outer, 0, 0, rounded.vertices.size()});
  return rounded;
}

class RegionRounder {
 public:
  RegionRounder(const ExactRegion& region, Task& task, Tally& tally)
      : rings_{region}, task_(task), tally_(tally) {}

  RoundedRegion run(bool has_outer_face) {
    for (const RegionPart& part : rings_.region.parts) {
      if (part.is_ring()) {
        rings_.rings.push_back({&part, false, false, {}});
      }
    }
    place(has_outer_face);
    if (rings_.error_bound > 0 && !rings_.rings.empty()) {
      make_valid(rings_, tally_);
    }
    return result();
  }

 private:
  // The nearest doubles. An outer face is rounded by itself.
  void place(bool has_outer_face) {
    const std::size_t begin = has_outer_face ? rings_.region.parts.front().size : 0;
    if (has_outer_face) {
      place_outer_face(begin);
    }
    ExactRing rest{rings_.region.a,
                   rings_.region.b,
                   rings_.region.shift,
                   {},
                   false,
                   rings_.region.against_edges};
    rest.vertices.assign(rings_.region.vertices.begin() + static_cast<std::ptrdiff_t>(begin),
                         rings_.region.vertices.end());
    Placement placement = place_nearest(rest, task_, tally_);
    rings_.places.insert(rings_.places.end(), placement.places.begin(), placement.places.end());
    rings_.nearest.insert(rings_.nearest.end(), placement.places.begin(), placement.places.end());
    error_of_others_ = placement.error_bound;
    rings_.error_bound = std::max(rings_.error_bound, placement.error_bound);
  }

  void place_outer_face(std::size_t size) {
    ExactRing outer{rings_.region.a,
                    rings_.region.b,
                    rings_.region.shift,
                    {},
                    rings_.region.chains_are_repeated,
                    rings_.region.against_edges};
    outer.vertices.assign(rings_.region.vertices.begin(),
                          rings_.region.vertices.begin() + static_cast<std::ptrdiff_t>(size));
    Placement placement = place_nearest(outer, task_, tally_);
    rings_.nearest = placement.places;
    rings_.rings.front().is_fixed = true;
    if (make_simple(outer, placement, task_, tally_)) {
      rings_.error_bound = placement.error_bound;
      rings_.repaired = placement.repaired;
      rings_.places = std::move(placement.places);
      return;
    }
    RoundedRing rounded = gcv::round_to_nearest(outer, task_, tally_);
    rings_.error_bound = rounded.error_bound;
    rings_.repaired = rounded.vertices_repaired;
    rings_.places = rings_.nearest;
    rings_.rings.front().replaced = std::move(rounded.vertices);
  }

  RoundedRegion result() {
    RoundedRegion rounded;
    Index polygon = RegionPart::no_polygon;
    for (const RoundingRing& ring : rings_.rings) {
      if (ring.is_dropped) {
        continue;
      }
      const RegionPart& part = *ring.part;
      polygon += part.kind == PartKind::outer ? 1 : 0;
      const std::size_t first = rounded.vertices.size();
      if (ring.replaced) {
        add_replaced(ring, rounded);
      } else {
        add_places(rings_.places_of(part), part.first,
                   &ring == &rings_.rings.front() && ring.is_fixed, rounded);
      }
      rounded.parts.push_back({part.kind, polygon, first, rounded.vertices.size() - first});
    }
    add_fits(rounded);
    const double moved = std::max(rings_.furthest, rings_.displaced);
    rounded.displacement = sum_bound(error_of_others_, moved);
    const double lost =
        rings_.dropped > 0 ? exact_extents_bound(rings_.lost, rings_.error_bound) : 0.0;
    rounded.error_bound = std::max(sum_bound(rings_.error_bound, moved), lost);
    rounded.vertices_repaired = rings_.repaired;
    rounded.parts_dropped = rings_.dropped;
    return rounded;
  }

  void add_replaced(const RoundingRing& ring, RoundedRegion& rounded) const {
    const RegionPart& part = *ring.part;
    const std::span<const Point> exact = std::span(rings_.nearest).subspan(part.first, part.size);
    for (const std::size_t index : closest_edges(exact, *ring.replaced, task_)) {
      rounded.exact_indices.push_back(part.first + index);
    }
    rounded.vertices.insert(rounded.vertices.end(), ring.replaced->begin(), ring.replaced->end());
  }

  void add_fits(RoundedRegion& rounded) const {
    std::vector<const RegionPart*> points;
    const auto add = [&](const RegionPart& part, PartKind kind, std::size_t size) {
      rounded.parts.push_back({kind, RegionPart::no_polygon, rounded.vertices.size(), size});
      for (std::size_t k = part.first; k < part.first + size; ++k) {
        rounded.vertices.push_back(rings_.places[k]);
        rounded.exact_indices.push_back(k);
      }
    };
    for (const RegionPart& part : rings_.region.parts) {
      if (part.kind == PartKind::segment &&
          !(rings_.places[part.first] == rings_.places[part.first + 1])) {
        add(part, PartKind::segment, 2);
      } else if (!part.is_ring()) {
        points.push_back(&part);
      }
    }
    for (const RegionPart* const part : points) {
      add(*part, PartKind::point, 1);
    }
  }

  RegionRings rings_;
  double error_of_others_ = 0;  // of the nearest doubles of all rings but an outer face
  Task& task_;
  Tally& tally_;
};

}  // namespace

RoundedRegion round_to_nearest(const ExactRegion& region, bool has_outer_face, Task& task,
                               Tally& tally) {
  return has_outer_face && region.parts.size() == 1
             ? round_outer_face(region, task, tally)
             : RegionRounder(region, task, tally).run(has_outer_face);
}

}  // namespace gcv
