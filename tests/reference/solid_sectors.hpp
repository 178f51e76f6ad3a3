// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What two polygons that touch are like at one point, in fractions: the solid there consists of
// sectors between two rays along its edges. Where no rings touch it is one sector: that of a
// corner, or a half-plane.
#pragma once

#include <cstddef>
#include <vector>

#include "contact_reference.hpp"

namespace gcv::reference {

// A ray from a point along the boundary. If the point lies strictly inside an edge, then the ray
// belongs to that edge; else to the corner.
struct BoundaryRay {
  Exact direction;
  bool is_of_edge;
  std::size_t index;  // in Solid::edges or Solid::corners
};

// The solid from the first ray counter-clockwise to the last one.
struct Sector {
  BoundaryRay first;
  BoundaryRay last;
};

// None where x is not on the boundary.
std::vector<Sector> sectors_at(const Solid& solid, const Exact& x);

// The sectors that each ring would leave alone: the half-planes of edges and the corners. Where
// rings touch they overlap.
std::vector<Sector> sectors_of_rings_at(const Solid& solid, const Exact& x);

// The points that are common to the boundaries of two polygons that do not overlap and are a
// vertex of one. Each once.
std::vector<Exact> contact_points(const Solid& a, const Solid& b);

struct EnteredContacts {
  // The pairs of features whose half-planes and corners meet after a motion and do not meet before.
  std::vector<Contact> contacts;
  // At points where rings of a polygon touch, these pairs and those on the borders of sectors of
  // the solids that meet. Which of them is hit is a matter of taste.
  std::vector<Contact> where_rings_touch;

  [[nodiscard]] bool empty() const { return contacts.empty() && where_rings_touch.empty(); }
};

// What b enters when it moves along d, however little. a and b must not overlap. By feature.
EnteredContacts entered_contacts(const Solid& a, const Solid& b, const Exact& d);

}  // namespace gcv::reference
