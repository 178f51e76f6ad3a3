// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solid_cones.hpp"

#include <cstddef>

#include "predicates.hpp"

namespace gcv {

namespace {

int turn(const Direction& p, const Direction& q, Tally& tally) {
  return gcv::turn(p.from, p.to, q.from, q.to, tally);
}

// Do parallel directions point the same way?
bool point_alike(const Direction& p, const Direction& q) {
  return p.from.x != p.to.x ? (p.from.x < p.to.x) == (q.from.x < q.to.x)
                            : (p.from.y < p.to.y) == (q.from.y < q.to.y);
}

// Where a direction lies, seen counter-clockwise from another one.
enum class Sector { same, left, opposite, right };

Sector sector(const Direction& from, const Direction& direction, Tally& tally) {
  const int side = turn(from, direction, tally);
  if (side != 0) {
    return side > 0 ? Sector::left : Sector::right;
  }
  return point_alike(from, direction) ? Sector::same : Sector::opposite;
}

// Turning counter-clockwise from `start`, is p met strictly before q? `start` itself is met first.
bool is_before(const Direction& start, const Direction& p, const Direction& q, Tally& tally) {
  const Sector sector_p = sector(start, p, tally);
  const Sector sector_q = sector(start, q, tally);
  if (sector_p != sector_q) {
    return sector_p < sector_q;
  }
  return (sector_p == Sector::left || sector_p == Sector::right) && turn(p, q, tally) > 0;
}

bool overlap(const DirectionRange& p, const DirectionRange& q, Tally& tally) {
  return is_before(p.from, q.from, p.to, tally) || is_before(q.from, p.from, q.to, tally);
}

bool holds(const DirectionRange& range, const Direction& direction, Tally& tally) {
  return sector(range.from, direction, tally) != Sector::same &&
         is_before(range.from, direction, range.to, tally);
}

// The directions to the left of one.
DirectionRange left_of(const Direction& direction) { return {direction, direction.reversed()}; }

// The apex moves along a side of the other cone. Does its own cone overlap the left of that side?
bool overlap_along(const DirectionRange& sides, const DirectionRange& moved,
                   const Direction& motion, Tally& tally) {
  return (sector(sides.from, motion, tally) == Sector::same &&
          overlap(left_of(sides.from), moved, tally)) ||
         (sector(sides.to, motion, tally) == Sector::same &&
          overlap(left_of(sides.to.reversed()), moved, tally));
}

// Does the ray from the apex of A cross that from the apex of B, which is moved? They cross in
// lambda p = motion + mu q. Then lambda = (motion x q) / (p x q), mu = (motion x p) / (p x q).
bool cross(const Direction& p, const Direction& q, const Direction& motion, Tally& tally) {
  const int side = turn(p, q, tally);
  return side != 0 && turn(motion, q, tally) == side && turn(motion, p, tally) == side;
}

// Either an apex comes to lie inside the other cone, or on its sides, or sides cross. Else the
// cones are apart.
bool overlap_once_moved(const DirectionRange& a, const DirectionRange& b, const Direction& motion,
                        Tally& tally) {
  const Direction back = motion.reversed();
  return holds(a, motion, tally) || holds(b, back, tally) || cross(a.from, b.from, motion, tally) ||
         cross(a.from, b.to, motion, tally) || cross(a.to, b.from, motion, tally) ||
         cross(a.to, b.to, motion, tally) || overlap_along(a, b, motion, tally) ||
         overlap_along(b, a, back, tally);
}

template <class Test>
bool any_pair(const SolidCones& a, const SolidCones& b, Test test) {
  return a.any([&](const DirectionRange& p) {
    return b.any([&](const DirectionRange& q) { return test(p, q); });
  });
}

}  // namespace

Direction direction_of_edge(const PreparedPolygon& polygon, Index edge) {
  const Boundary& boundary = polygon.boundary;
  return {boundary.vertices[edge], boundary.vertices[boundary.next(edge)]};
}

SolidCones cones_of_edge(const PreparedPolygon& polygon, Index edge) {
  return {left_of(direction_of_edge(polygon, edge)), {}};
}

SolidCones cones_of_vertex(const PreparedPolygon& polygon, Index vertex, Tally& tally) {
  const auto back_along = [&](Index edge) { return direction_of_edge(polygon, edge).reversed(); };
  const Touch* const touch = polygon.touches.at(vertex);
  if (touch == nullptr) {
    return {{direction_of_edge(polygon, vertex), back_along(polygon.boundary.previous(vertex))},
            {}};
  }
  const auto cone_from = [&](Index leaving) {
    DirectionRange cone{direction_of_edge(polygon, leaving), back_along(touch->arriving.front())};
    for (const Index arriving : touch->arriving) {
      const Direction back = back_along(arriving);
      if (is_before(cone.from, back, cone.to, tally)) {
        cone.to = back;
      }
    }
    return cone;
  };
  SolidCones cones{cone_from(touch->leaving.front()), {}};
  for (std::size_t k = 1; k < touch->leaving.size(); ++k) {
    cones.others.push_back(cone_from(touch->leaving[k]));
  }
  return cones;
}

bool overlap(const SolidCones& a, const SolidCones& b, Tally& tally) {
  return any_pair(
      a, b, [&](const DirectionRange& p, const DirectionRange& q) { return overlap(p, q, tally); });
}

bool overlap_once_moved(const SolidCones& a, const SolidCones& b, const Direction& motion,
                        Tally& tally) {
  return any_pair(a, b, [&](const DirectionRange& p, const DirectionRange& q) {
    return overlap_once_moved(p, q, motion, tally);
  });
}

}  // namespace gcv
