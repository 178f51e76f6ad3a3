// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The core's polygons and rings for tests in fractions.
#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <string>

#include "boundary.hpp"
#include "exact_containment.hpp"
#include "exact_geometry.hpp"
#include "exact_ring.hpp"
#include "point.hpp"
#include "ring_predicates.hpp"

namespace gcv::test {

inline std::shared_ptr<const gcv::Boundary> polygon_of(const PointVector& boundary) {
  return std::make_shared<const gcv::Boundary>(make_ring(boundary, "polygon"));
}

inline invariants::Exact exact(const Point& p) {
  return {invariants::Rational(p.x), invariants::Rational(p.y)};
}

inline invariants::Ring exact(const PointVector& ring) {
  invariants::Ring result;
  for (const Point& p : ring) {
    result.push_back(exact(p));
  }
  return result;
}

inline invariants::Ring exact(const ExactRing& ring) {
  invariants::Ring result;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const std::string text = exact_vertex(ring, k);
    const std::size_t space = text.find(' ');
    result.push_back({invariants::Rational(text.substr(0, space)),
                      invariants::Rational(text.substr(space + 1))});
  }
  return result;
}

// The ring of polygon + shift.
inline ExactRing shifted_ring(const PointVector& boundary, const Point& shift) {
  const auto polygon = polygon_of(boundary);
  const auto triangle = polygon_of({{0, 0}, {1, 0}, {0, 1}});
  ExactRing ring{{polygon, "polygon"}, {triangle, "triangle"}, shift, {}};
  for (Index i = 0; i < polygon->size(); ++i) {
    ring.vertices.push_back(RingVertex::sum(i, 0, {EdgeName::translated, polygon->previous(i), 0},
                                            {EdgeName::translated, i, 0}));
  }
  return ring;
}

inline bool is_simple_and_counter_clockwise(const invariants::Ring& ring) {
  return ring.size() >= 3 && !invariants::find_meeting(ring) && invariants::twice_area(ring) > 0;
}

// Is no point of either ring further than the distance from the other ring?
inline bool are_within(const invariants::Ring& p, const invariants::Ring& q, double distance) {
  return invariants::all_edges_near(p, q, distance, p.size()) &&
         invariants::all_edges_near(q, p, distance, q.size());
}

inline bool contains(const invariants::Ring& outer, const invariants::Ring& inner) {
  return invariants::contains(outer, inner, outer.size() + inner.size());
}

// Times a power of two for each axis.
inline PointVector scaled(PointVector ring, int exponent_x, int exponent_y) {
  for (Point& p : ring) {
    p = {std::ldexp(p.x, exponent_x), std::ldexp(p.y, exponent_y)};
  }
  return ring;
}
inline PointVector scaled(const PointVector& ring, int exponent) {
  return scaled(ring, exponent, exponent);
}

}  // namespace gcv::test
