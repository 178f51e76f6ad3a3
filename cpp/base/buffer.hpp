// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A vector that does not write trivial elements when it is sized. Who sizes it must write them.
// This saves a pass over memory, which shows in the times of sums of small polygons.
#pragma once

#include <memory>
#include <new>
#include <vector>

namespace gcv {

template <class T>
struct UnwrittenAllocator : std::allocator<T> {
  UnwrittenAllocator() = default;
  template <class U>
  explicit(false) UnwrittenAllocator(const UnwrittenAllocator<U>& /*other*/) noexcept {}

  template <class U>
  void construct(U* element) {
    ::new (static_cast<void*>(element)) U;
  }
};

template <class T>
using Buffer = std::vector<T, UnwrittenAllocator<T>>;

}  // namespace gcv
