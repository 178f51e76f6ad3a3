// SPDX-License-Identifier: LGPL-3.0-or-later
//
// In place of swept_spheres.cpp: line-swept spheres that hold everything, so that boxes alone
// prune.
#include <algorithm>
#include <iterator>
#include <limits>
#include <span>
#include <vector>

#include "swept_spheres.hpp"

namespace gcv {

std::vector<SweptSphereBlock> build_swept_spheres(const ChainTree& tree, const EdgeChain& /*chain*/,
                                                  std::span<const Index> /*order*/) {
  SweptSphereBlock everything{};
  std::fill(std::begin(everything.radius), std::end(everything.radius),
            std::numeric_limits<double>::infinity());
  return std::vector<SweptSphereBlock>(tree.blocks.size(), everything);
}

}  // namespace gcv
