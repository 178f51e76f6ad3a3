// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "point.hpp"

namespace gcv {

// The sum of the areas of rings, rounded to the nearest double. The area of a ring is positive if
// the ring is counter-clockwise, else negative. Infinite if it is beyond the largest double.
// ring(k) must give ring k. At most 2^31 points in all. Needs no heap memory if numbers of 512 bits
// suffice.
double area_of(std::size_t ring_count,
               const std::function<std::span<const Point>(std::size_t)>& ring);
inline double ring_area(std::span<const Point> ring) {
  return area_of(1, [ring](std::size_t) { return ring; });
}

}  // namespace gcv
