// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where a convex polygon that moves runs into another one.
#pragma once

#include <optional>

#include "contact.hpp"
#include "convex_pair.hpp"

namespace gcv {

// Of two that do not overlap: the contact of an edge and a vertex, if there is one, that the line
// of the motion of B enters from outside. Looked for in doubles and proven exactly; nothing where
// that fails, as where the line passes by or two contacts are entered at once. O(n + m).
std::optional<ContactName> contact_entered(const PlacedPair& placed, const Point& motion,
                                           Tally& tally);

}  // namespace gcv
