// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The ring N of nearest places is grown by a square of half width d, which is a Minkowski
// sum, and the result O is rounded to nearest places again. Let e1 and e2 bound how far
// the vertices moved in the two roundings. Moving the vertices of a ring by at most e
// moves its boundary by at most e, and a point that changes sides is passed by it. So
// every exact point lies within e1 of N, hence in O, and d - e1 away from the boundary of
// O at least: with e2 < d - e1 it stays inside.
//
// The error. A point of the result is within e2 of O, which is within sqrt(2) d of N,
// which is within e1 of the exact ring. The other way round, a point of N is within
// sqrt(2) d of O where an edge of O comes from it. The walk meets the edges of N in their
// order; a stretch of N that it leaves out lies behind a slit that has closed, and no
// further from the vertex of O where it was left out than its own vertices are.
#include "outward.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "error.hpp"
#include "outer_face.hpp"

namespace gcv {

namespace {

struct Grown {
  ExactRing ring;
  std::optional<Placement> placement;
};

Grown grow(const std::shared_ptr<const Polygon>& polygon, double d, Task& task, Tally& tally) {
  const PointVector square{{-d, -d}, {d, -d}, {d, d}, {-d, d}};
  const auto growth = std::make_shared<const Polygon>(make_polygon(square, "square"));
  Walk walk = walk_outer_face(*polygon, *growth, task, tally);
  Grown grown{
      {{polygon, "the rounded ring"}, {growth, "the square"}, {0, 0}, std::move(walk.vertices)},
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

// At least the distance of p from the segment ab: that to a point near its foot, whose
// coordinates are off by a few units in the last place at most. Scaled where squares would overflow
// or underflow: what the smaller coordinates lose is nothing beside a unit.
double distance_bound(Point p, Point a, Point b, double unit) {
  const double scale = unit > 0x1p400 ? 0x1p-600 : unit < 0x1p-400 ? 0x1p600 : 1;
  for (Point* const point : {&p, &a, &b}) {
    *point = {point->x * scale, point->y * scale};
  }
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double foot = ((p.x - a.x) * dx + (p.y - a.y) * dy) / square;
  const double t = foot > 0 ? std::min(foot, 1.0) : 0.0;
  return length_bound(p.x - (a.x + t * dx), p.y - (a.y + t * dy)) / scale + 8 * unit;
}

// At least the distance of a vertex of N that no edge of O comes from to O as placed.
double lost_distance(const Grown& grown, double unit) {
  const Polygon& n = *grown.ring.a.polygon;
  const PointVector& places = grown.placement->places;
  double distance = 0;
  const auto pass = [&](Index from, Index to, const Point& a, const Point& b) {
    while (from != to) {
      from = n.next(from);
      distance = std::max(distance, distance_bound(n.vertices[from], a, b, unit));
    }
  };
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::size_t next = k + 1 == places.size() ? 0 : k + 1;
    pass(grown.ring.vertices[k].arriving().i, grown.ring.vertices[k].leaving().i, places[k],
         places[k]);
    pass(grown.ring.vertices[k].leaving().i, grown.ring.vertices[next].arriving().i, places[k],
         places[next]);
  }
  return distance;
}

}  // namespace

RoundedRing round_outward(const ExactRing& ring, Task& task, Tally& tally) {
  RoundedRing nearest = round_to_nearest(ring, task, tally);
  if (nearest.error_bound == 0) {
    return nearest;
  }
  const Point units = units_in_last_place(nearest.vertices);
  const double unit = std::max(units.x, units.y);
  const auto polygon =
      std::make_shared<const Polygon>(make_polygon(nearest.vertices, "the rounded ring"));
  // What the first rounding cut off must be covered, too.
  double d = 2 * unit;
  while (d <= nearest.error_bound) {
    d *= 2;
  }
  for (int tries = 0; tries < 6; ++tries) {
    const Grown grown = grow(polygon, d, task, tally);
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
