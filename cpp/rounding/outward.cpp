// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The method. The exact vertices are rounded to the nearest doubles, which gives the ring N. The
// Minkowski sum of N and a square of half width d gives the exact ring O. O is rounded to the
// nearest doubles again.
//
// Why the result contains the exact ring. Let e1 and e2 bound how far vertices move in the two
// roundings. If vertices move by at most e, the boundary moves by at most e, and it passes every
// point that changes sides. So every exact point is within e1 of N. So it is inside O, and at least
// d - e1 away from the boundary of O. So it stays inside in the second rounding if e2 < d - e1.
//
// The error. A point of the result is within e2 of O. O is within sqrt(2) d of N. N is within e1 of
// the exact ring. The other way round: a point of N is within sqrt(2) d of O if an edge of O comes
// from it. The walk meets the edges of N in their order. Where it leaves out a part of N, that part
// lies behind a slit that has closed. Let v be the vertex of O where the part is left out. No point
// of the part is further from v than the furthest vertex of the part.
#include "outward.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "cycle.hpp"
#include "error.hpp"
#include "units.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

struct Grown {
  ExactRing ring;
  std::optional<Placement> placement;
};

Grown grow(const std::shared_ptr<const Boundary>& polygon, double d,
           const OuterFaceOf& outer_face_of, Task& task, Tally& tally) {
  const PointVector square{{-d, -d}, {d, -d}, {d, d}, {-d, d}};
  const auto growth = std::make_shared<const Boundary>(make_ring(square, "square"));
  // Not a part of the next statement. g++ 12 destroys the members of an aggregate twice if a later
  // one throws.
  std::vector<RingVertex> vertices = outer_face_of(*polygon, *growth);
  Grown grown{{{polygon, "the rounded ring"}, {growth, "the square"}, {0, 0}, std::move(vertices)},
              {}};
  try {
    Placement placement = place_nearest(grown.ring, task, tally);
    if (make_simple(grown.ring, placement, task, tally)) {
      grown.placement = std::move(placement);
    }
  } catch (const Error& error) {
    if (error.status() != Status::range) {
      throw;
    }
    throw Error(Status::range, "the ring around the outer face goes beyond the largest double");
  }
  return grown;
}

// At least the distance from the rounded O of every vertex of N that no edge of O comes from.
double lost_distance(const Grown& grown, double unit) {
  const Boundary& n = *grown.ring.a.ring;
  const PointVector& places = grown.placement->places;
  double distance = 0;
  const auto pass = [&](Index from, Index to, const Point& a, const Point& b) {
    while (from != to) {
      from = n.next(from);
      distance = std::max(distance, distance_bound(n.vertices[from], a, b, unit));
    }
  };
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::size_t next = cyclic_next(k, places.size());
    pass(grown.ring.vertices[k].arriving().i, grown.ring.vertices[k].leaving().i, places[k],
         places[k]);
    pass(grown.ring.vertices[k].leaving().i, grown.ring.vertices[next].arriving().i, places[k],
         places[next]);
  }
  return distance;
}

}  // namespace

RoundedRing round_outward(const ExactRing& ring, const OuterFaceOf& outer_face_of, Task& task,
                          Tally& tally, std::uint64_t parts) {
  RoundedRing nearest = round_to_nearest(ring, task, tally, parts);
  if (nearest.error_bound == 0) {
    return nearest;
  }
  const Point units = units_in_last_place(nearest.vertices);
  const double unit = std::max(units.x, units.y);
  const auto polygon =
      std::make_shared<const Boundary>(make_ring(nearest.vertices, "the rounded ring"));
  // d must be larger than what the first rounding cut off.
  double d = 2 * unit;
  while (d <= nearest.error_bound) {
    d *= 2;
  }
  for (int tries = 0; tries < 6; ++tries) {
    const Grown grown = grow(polygon, d, outer_face_of, task, tally);
    if (grown.placement && sum_bound(nearest.error_bound, grown.placement->error_bound) < d) {
      const double error = std::max(1.5 * d, lost_distance(grown, unit)) + nearest.error_bound +
                           grown.placement->error_bound;
      return {ring_through(grown.placement->places), next_up(error * (1 + 0x1p-50)),
              nearest.vertices_repaired + grown.placement->repaired};
    }
    d *= 2;
  }
  throw Error(Status::range, "no ring of doubles close around the outer face was found");
}

}  // namespace gcv
