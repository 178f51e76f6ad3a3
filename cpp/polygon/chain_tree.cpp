// SPDX-License-Identifier: LGPL-3.0-or-later
#include "chain_tree.hpp"

namespace gcv {

ChainTree build_chain_tree(const EdgeChain& chain) {
  return build_tree(chain.size(), [&](std::uint32_t k) {
    const auto ends = chain.ends(k, 1);
    return box_of(ends.front(), ends.back());
  });
}

}  // namespace gcv
