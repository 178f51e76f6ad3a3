// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Indices of elements that follow each other in a cycle, such as the vertices of a ring.
#pragma once

#include <type_traits>

namespace gcv {

// The index after i and the one before i, in a cycle of `size` elements.
template <class Index>
constexpr Index cyclic_next(Index i, std::type_identity_t<Index> size) {
  return i + 1 == size ? 0 : i + 1;
}
template <class Index>
constexpr Index cyclic_previous(Index i, std::type_identity_t<Index> size) {
  return (i == 0 ? size : i) - 1;
}

}  // namespace gcv
