// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <vector>

#include "sets.hpp"

namespace gcv::bench {

inline constexpr double answer_limit = 20;               // seconds for one system on one pair
inline constexpr double answer_turns = 0.05;             // seconds of turns for a ratio of times
inline constexpr double most_pairs_of_vertices = 12000;  // unions of n m quadrangles are slow

// The pairs by which answers are judged; the real ones only where the data is. A quick run has
// fewer.
std::vector<Set> answer_sets(bool quick);

}  // namespace gcv::bench
