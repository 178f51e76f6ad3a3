// SPDX-License-Identifier: LGPL-3.0-or-later
//
// In place of capsules.cpp: capsules that hold everything, so that boxes alone prune.
#include <algorithm>
#include <iterator>
#include <limits>

#include "capsules.hpp"

namespace gcv {

std::vector<CapsuleBlock> build_capsules(const ChainTree& tree, std::span<const Point>) {
  CapsuleBlock everything{};
  std::fill(std::begin(everything.radius), std::end(everything.radius),
            std::numeric_limits<double>::infinity());
  return std::vector<CapsuleBlock>(tree.blocks.size(), everything);
}

}  // namespace gcv
