// SPDX-License-Identifier: LGPL-3.0-or-later
#include "ring_layout.hpp"

#include <algorithm>

namespace gcv {

Index RingLayout::later_ring_of(Index i) const {
  return static_cast<Index>(std::upper_bound(ends_.begin(), ends_.end(), i) - ends_.begin());
}

Index RingLayout::next_in_later_ring(Index i) const {
  const Index ring = later_ring_of(i);
  return i + 1 == end(ring) ? begin(ring) : i + 1;
}

Index RingLayout::previous_in_later_ring(Index i) const {
  const Index ring = later_ring_of(i);
  return (i == begin(ring) ? end(ring) : i) - 1;
}

}  // namespace gcv
