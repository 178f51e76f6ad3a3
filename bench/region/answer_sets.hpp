// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <vector>

#include "sets.hpp"

namespace gcv::bench {

// The pairs by which answers are judged; the real ones only where the data is. A quick run has
// fewer.
std::vector<Set> answer_sets(bool quick);

}  // namespace gcv::bench
