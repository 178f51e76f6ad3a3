// SPDX-License-Identifier: LGPL-3.0-or-later
#include "area.hpp"

#include <cassert>

#include "exact_numbers.hpp"
#include "to_double.hpp"

namespace gcv {

// The shoelace formula in integers. With b bits in the grid each term is below 2^(2b+1). 32 bits
// more hold any sum of 2^31 terms.
double area_of(std::size_t ring_count,
               const std::function<std::span<const Point>(std::size_t)>& ring) {
  Grid grid;
  for (std::size_t k = 0; k < ring_count; ++k) {
    for (const Point& p : ring(k)) {
      grid.include(p);
    }
  }
  Tally tally;
  const int bits = 2 * grid.bits() + 33;
  return with_integers(rounding_bits(bits), tally, [&]<class Integer>() {
    const auto integers = [&](const Point& p) {
      return Vector<Integer>{grid.integer<Integer>(p.x), grid.integer<Integer>(p.y)};
    };
    Integer twice_area(0);
    for (std::size_t k = 0; k < ring_count; ++k) {
      assert(!ring(k).empty());
      Vector<Integer> previous = integers(ring(k).back());
      for (const Point& p : ring(k)) {
        const Vector<Integer> current = integers(p);
        twice_area += cross(previous, current);
        previous = current;
      }
    }
    return nearest_double(twice_area, Integer(1), 2 * grid.exponent() - 1).value;
  });
}

}  // namespace gcv
