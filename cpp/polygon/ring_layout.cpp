// SPDX-License-Identifier: LGPL-3.0-or-later
#include "ring_layout.hpp"

namespace gcv {

Index RingLayout::next_in_later_ring(Index i) const {
  const Index ring = ring_of(i);
  return i + 1 == end(ring) ? begin(ring) : i + 1;
}

Index RingLayout::previous_in_later_ring(Index i) const {
  const Index ring = ring_of(i);
  return (i == begin(ring) ? end(ring) : i) - 1;
}

}  // namespace gcv
