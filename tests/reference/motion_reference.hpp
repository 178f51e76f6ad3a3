// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A polygon that moves beside another one, by the definitions, in fractions: how far it gets, and
// the shortest way out. All places where something can change are tried, one after the other.
#pragma once

#include <optional>
#include <vector>

#include "contact_reference.hpp"

namespace gcv::reference {

struct Impact {
  bool hit;
  Rational time;
  // The contacts that are entered, by feature: none without a hit, and where b overlaps a at the
  // start.
  std::vector<Contact> entered;
};

// b moves from where it is along the motion.
Impact impact(const Solid& a, const Solid& b, const Exact& motion);

// The shortest vector by which b no longer overlaps a; of several, the lexicographically smallest.
Exact escape(const Solid& a, const Solid& b);

}  // namespace gcv::reference
