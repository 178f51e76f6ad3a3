// SPDX-License-Identifier: LGPL-3.0-or-later
#include "affine.hpp"

#include <algorithm>

#include "double_double_rounding.hpp"
#include "exact_numbers.hpp"
#include "to_double.hpp"

namespace gcv {

namespace {

template <class Integer>
Integer times_power_of_two(Integer value, int exponent) {
  if constexpr (std::is_same_v<Integer, Int128>) {
    return value * (Int128{1} << exponent);
  } else {
    return value << exponent;
  }
}

// xx x + xy y + x0 in integers. Both products are multiples of one power of two; the sum is one of
// the finer power of theirs and that of x0.
double mapped_exactly(double xx, double xy, double x0, const Point& p) {
  const Grid factors{Point{xx, xy}};
  const Grid point{p};
  const Grid shift{Point{x0, 0}};
  const int products = factors.exponent() + point.exponent();
  const int unit = x0 == 0 ? products : std::min(products, shift.exponent());
  const int bits = 2 + std::max(products - unit + factors.bits() + point.bits(),
                                x0 == 0 ? 0 : shift.exponent() - unit + shift.bits());
  Tally tally;
  return with_integers(rounding_bits(bits), tally, [&]<class Integer>() {
    Integer sum =
        times_power_of_two(Integer(factors.integer<Integer>(xx) * point.integer<Integer>(p.x) +
                                   factors.integer<Integer>(xy) * point.integer<Integer>(p.y)),
                           products - unit);
    if (x0 != 0) {
      sum += times_power_of_two(shift.integer<Integer>(x0), shift.exponent() - unit);
    }
    return nearest_double(sum, Integer(1), unit).value;
  });
}

double mapped(double xx, double xy, double x0, const Point& p) {
  const auto rounded = rounded_affine(xx, xy, x0, p);
  return (rounded ? rounded->value : mapped_exactly(xx, xy, x0, p)) + 0.0;
}

}  // namespace

Point mapped(const AffineMap& map, const Point& p) {
  return {mapped(map.xx, map.xy, map.x0, p), mapped(map.yx, map.yy, map.y0, p)};
}

}  // namespace gcv
