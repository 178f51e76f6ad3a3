// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

namespace gcv::bench {

// Prints how far ways out of overlaps are off that lead to the nearest point of the whole sums of
// other systems, and how long they take. A quick run has fewer pairs.
void print_ways_out(bool quick);

}  // namespace gcv::bench
