// SPDX-License-Identifier: LGPL-3.0-or-later
#include "area.hpp"

#include "exact_numbers.hpp"
#include "to_double.hpp"

namespace gcv {

// The shoelace formula in integers. Each term is below 2^(2b+1), with b bits in the grid;
// 32 bits more hold any sum of them.
double ring_area(std::span<const Point> ring) {
  Grid grid;
  for (const Point& p : ring) {
    grid.include(p);
  }
  Tally tally;
  const int bits = 2 * grid.bits() + 33;
  return with_integers(rounding_bits(bits), tally, [&]<class Integer>() {
    const auto integers = [&](const Point& p) {
      return Vector<Integer>{grid.integer<Integer>(p.x), grid.integer<Integer>(p.y)};
    };
    Integer twice_area(0);
    Vector<Integer> previous = integers(ring.back());
    for (const Point& p : ring) {
      const Vector<Integer> current = integers(p);
      twice_area += cross(previous, current);
      previous = current;
    }
    return nearest_double(twice_area, Integer(1), 2 * grid.exponent() - 1).value;
  });
}

}  // namespace gcv
