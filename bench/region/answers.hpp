// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

namespace gcv::bench {

// Prints what other systems lose and add of holes and exact fits, and how long they take. A quick
// run has fewer pairs.
void print_answers(bool quick);

}  // namespace gcv::bench
