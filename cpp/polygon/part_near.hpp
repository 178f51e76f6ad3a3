// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What matters of a large boundary near a box.
#pragma once

#include <optional>

#include "boundary.hpp"

namespace gcv {

// A boundary to be joined with others, whose solid is the same within the box. Rings that do not
// meet it are left out. Where each ring bounds a solid of its own, as those of a complement do, so
// are the vertices in between of chains that lie beyond one side of the box: the edge in their
// place lies there, too, and winds round no point of the box in another way. Such edges may cross
// each other. Nothing if that is not less than half of the boundary. O(n).
std::optional<Boundary> part_near(const Boundary& boundary, const Box& box);

}  // namespace gcv
