// SPDX-License-Identifier: LGPL-3.0-or-later
//
// In place of chain_index.cpp: every tree is in the order of the boundary.
#include "chain_index.hpp"

namespace gcv {

ChainIndex build_chain_index(const EdgeChain& chain) {
  ChainIndex index{{}, build_chain_tree(chain), {}};
  index.spheres = build_swept_spheres(index.tree, chain, index.order);
  return index;
}

std::optional<ChainIndex> build_index_on_curve(const ChainIndex& /*index*/,
                                               const EdgeChain& /*chain*/) {
  return std::nullopt;
}

}  // namespace gcv
