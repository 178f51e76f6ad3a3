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

// Two sectors at one point, whose interiors do not meet. Do they meet after the second one has
// moved along d, however little? Throws std::logic_error if they meet before.
bool meet_after(const Sector& a, const Sector& b, const Exact& d);

// The points that are common to the boundaries of two polygons that do not overlap and are a
// vertex of one. Each once.
std::vector<Exact> contact_points(const Solid& a, const Solid& b);

struct EnteredContacts {
  // The pairs of features on the borders of sectors that meet after a motion. By feature.
  std::vector<Contact> contacts;
  // For each point where rings of a polygon touch and sectors meet: the pairs with the vertices
  // there in place of the features of that polygon. Any of them names the contact. By feature.
  std::vector<std::vector<Contact>> where_rings_touch;

  [[nodiscard]] bool empty() const { return contacts.empty() && where_rings_touch.empty(); }
};

// What b enters when it moves along d, however little. a and b must not overlap. By feature.
EnteredContacts entered_contacts(const Solid& a, const Solid& b, const Exact& d);

}  // namespace gcv::reference
