// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What a system's sum has lost of the exact region, and what it has that is not there.
#pragma once

#include <cstddef>
#include <vector>

#include "systems/whole.hpp"

namespace gcv::bench {

// Of the points on some horizontal lines through the inside of a simple ring, in the middle
// between two edges: one that is furthest from the ring.
invariants::Exact point_well_inside(const invariants::Ring& ring);

// Is the point in the interior of the sum?
bool is_covered(const ExactWhole& whole, const invariants::Exact& x);

// Free points of the exact region: one well inside each hole; the middle of each segment, and
// each point.
struct FreePoints {
  std::vector<invariants::Exact> in_holes;
  std::vector<invariants::Exact> of_fits;
};
FreePoints free_points(const ExactRegion& region);

struct Verdict {
  std::size_t holes_lost = 0;  // their points are covered
  std::size_t fits_lost = 0;
};
Verdict verdict_of(const ExactWhole& answer, const ExactRegion& truth);

// Points well inside the system's holes that are covered in truth.
std::vector<invariants::Exact> points_in_false_holes(const ExactWhole& answer,
                                                     const ExactRegion& truth);

}  // namespace gcv::bench
