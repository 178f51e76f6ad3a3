// SPDX-License-Identifier: LGPL-3.0-or-later
#include "slope.hpp"

#include <cmath>

#include "double_double.hpp"
#include "exact_numbers.hpp"

namespace gcv {

namespace {

// Larger than the bound of predicates.cpp for a sum of two products of rounded differences, times
// the slope, and the roundings of that.
constexpr double error_factor = 16 * unit_roundoff;
constexpr double least_error = 0x1p-898;

template <class Integer>
Integer dot(const Vector<Integer>& v, const Vector<Integer>& w) {
  return v.x * w.x + v.y * w.y;
}

bool is_within_exactly(const Point& p0, const Point& p1, const Point& q0, const Point& q1,
                       double slope, Tally& tally) {
  const Grid grid{p0, p1, q0, q1};
  const Decomposed s = decompose(slope);
  return with_integers(2 * grid.bits() + 3 + 53 + std::abs(s.exponent), tally,
                       [&]<class Integer>() {
                         const auto v = vector_between<Integer>(grid, p0, p1);
                         const auto w = vector_between<Integer>(grid, q0, q1);
                         Integer along = dot(v, w);
                         Integer across = cross(v, w);
                         if (sign(along) <= 0) {
                           return false;
                         }
                         if (sign(across) < 0) {
                           across = -across;
                         }
                         along *= Integer(s.mantissa);
                         (s.exponent < 0 ? across : along) <<= std::abs(s.exponent);
                         return sign(Integer(along - across)) >= 0;
                       });
}

}  // namespace

bool is_within_slope(const Point& p0, const Point& p1, const Point& q0, const Point& q1,
                     double slope, Tally& tally) {
  const double vx = p1.x - p0.x;
  const double vy = p1.y - p0.y;
  const double wx = q1.x - q0.x;
  const double wy = q1.y - q0.y;
  const double along = vx * wx + vy * wy;
  const double size_along = std::abs(vx * wx) + std::abs(vy * wy);
  const double size_across = std::abs(vx * wy) + std::abs(vy * wx);
  if (along < -(error_factor * size_along + least_error)) {
    ++tally.filtered;
    return false;
  }
  const double rest = slope * along - std::abs(vx * wy - vy * wx);
  const double error =
      error_factor * (slope * size_along + size_across) + least_error + slope * least_error;
  if (along > error_factor * size_along + least_error && std::abs(rest) > error) {
    ++tally.filtered;
    return rest > 0;
  }
  return is_within_exactly(p0, p1, q0, q1, slope, tally);
}

}  // namespace gcv
