// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A polygon that moves beside another one, by the definitions, in fractions: how far it gets, and
// the shortest way out. All places where something can change are tried, one after the other.
#pragma once

#include "contact_reference.hpp"
#include "solid_sectors.hpp"

namespace gcv::reference {

struct Impact {
  bool hit;
  Rational time;
  // None without a hit, and where b overlaps a at the start.
  EnteredContacts entered;
};

// b moves from where it is along the motion.
Impact impact(const Solid& a, const Solid& b, const Exact& motion);

// The shortest vector by which b no longer overlaps a; of several, the lexicographically smallest.
Exact escape(const Solid& a, const Solid& b);

}  // namespace gcv::reference
