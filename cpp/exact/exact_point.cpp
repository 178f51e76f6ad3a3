// SPDX-License-Identifier: LGPL-3.0-or-later
#include "exact_point.hpp"

#include <optional>
#include <type_traits>

#include "ball.hpp"
#include "double_double_rounding.hpp"
#include "exact_numbers.hpp"
#include "gap.hpp"
#include "predicates.hpp"
#include "to_double.hpp"

namespace gcv {

namespace {

void include(Grid& grid, const ExactPoint& p) {
  if (p.is_sum) {
    grid.include(p.sum);
  } else {
    grid.include(p.s);
    grid.include(p.t);
  }
}

// p + shift. The numbers of a sum are smaller than those of a crossing: crossing_bits() holds them.
template <class Integer>
HomogeneousPoint<Integer> homogeneous(const Grid& grid, const ExactPoint& p, const Point& shift) {
  if (!p.is_sum) {
    return crossing<Integer>(grid, p.s, p.t, shift);
  }
  const Vector<Integer> sum = sum_of<Integer>(grid, p.sum, shift);
  return {sum.x, sum.y, Integer(1)};
}

template <class Integer>
Integer square_of_length(const HomogeneousPoint<Integer>& p) {
  return p.x * p.x + p.y * p.y;
}

// The distance of the crossing of two edges from a point, in double-double arithmetic, where that
// is certain.
std::optional<RoundedNumber> rounded_distance(const SumEdge& s, const SumEdge& t,
                                              const Point& from) {
  const DoubleDoubleVector origin = double_double_vector(SumPoint{from, {0, 0}}, s.origin);
  const DoubleDoubleVector direction = double_double_vector(s.from, s.to);
  const DoubleDoubleParameter parameter = double_double_parameter(s, t);
  const Ball lambda = Ball::normal(parameter.hi, parameter.lo, parameter.error);
  const Ball x = Ball::of(origin.x) + lambda * Ball::of(direction.x);
  const Ball y = Ball::of(origin.y) + lambda * Ball::of(direction.y);
  for (const double size :
       {origin.x.size, origin.y.size, direction.x.size, direction.y.size, lambda.hi, x.hi, y.hi}) {
    if (!gcv::is_in_range(size)) {
      return std::nullopt;
    }
  }
  return rounded(square_root(x * x + y * y));
}

// The bits of the coordinates of crossings, and of their denominators.
constexpr int denominator_bits(int grid_bits) { return 2 * grid_bits + 3; }
constexpr int square_bits(int grid_bits) { return 2 * crossing_bits(grid_bits) + 1; }

}  // namespace

Point nearest_point(const ExactPoint& p, const Point& shift, Tally& tally) {
  return p.is_sum ? nearest_point(p.sum, tally, shift) : nearest_crossing(p.s, p.t, tally, shift);
}

int compare_x(const ExactPoint& p, const Point& shift, double x, Tally& tally) {
  if (p.is_sum) {
    return compare_sums(p.sum.a.x, p.sum.b.x, p.sum.c.x, x, -shift.x, 0, tally);
  }
  const SumEdge& s = p.s.from.x != p.s.to.x ? p.s : p.t;
  const SumEdge& t = p.s.from.x != p.s.to.x ? p.t : p.s;
  const SumEdge upright{{{x, 0}, {-shift.x, 0}}, {0, 0}, {0, 1}, 0, 1};
  const int order = compare_crossings(s, t, upright, tally);
  return s.from.x < s.to.x ? order : -order;
}
int compare_y(const ExactPoint& p, const Point& shift, double y, Tally& tally) {
  if (p.is_sum) {
    return compare_sums(p.sum.a.y, p.sum.b.y, p.sum.c.y, y, -shift.y, 0, tally);
  }
  const SumEdge& s = p.s.from.y != p.s.to.y ? p.s : p.t;
  const SumEdge& t = p.s.from.y != p.s.to.y ? p.t : p.s;
  const SumEdge level{{{0, y}, {0, -shift.y}}, {0, 0}, {1, 0}, 1, 0};
  const int order = compare_crossings(s, t, level, tally);
  return s.from.y < s.to.y ? order : -order;
}

int side(const SumEdge& s, const ExactPoint& p, Tally& tally) {
  if (p.is_sum) {
    return side(s, p.sum, tally);
  }
  if (s == p.s || s == p.t) {
    return 0;
  }
  const int left = turn(s.from, s.to, p.s.from, p.s.to, tally);
  return left == 0 ? side(s, p.s.origin, tally) : left * compare_crossings(p.s, p.t, s, tally);
}

int compare_distances(const ExactPoint& p, const ExactPoint& q, const Point& from, Tally& tally) {
  Grid grid{from};
  include(grid, p);
  include(grid, q);
  const int bits = square_bits(grid.bits()) + 2 * denominator_bits(grid.bits()) + 1;
  return with_integers(bits, tally, [&]<class Integer>() {
    const auto x = homogeneous<Integer>(grid, p, negated(from));
    const auto y = homogeneous<Integer>(grid, q, negated(from));
    return sign(Integer(square_of_length(x) * (y.w * y.w) - square_of_length(y) * (x.w * x.w)));
  });
}

int compare_along(const Point& direction, const ExactPoint& p, const ExactPoint& q, Tally& tally) {
  const Grid of_direction{direction};
  Grid grid;
  include(grid, p);
  include(grid, q);
  const int bits =
      of_direction.bits() + crossing_bits(grid.bits()) + denominator_bits(grid.bits()) + 2;
  return with_integers(bits, tally, [&]<class Integer>() {
    const auto x = homogeneous<Integer>(grid, p, {0, 0});
    const auto y = homogeneous<Integer>(grid, q, {0, 0});
    const Vector<Integer> d{of_direction.integer<Integer>(direction.x),
                            of_direction.integer<Integer>(direction.y)};
    return sign(Integer(d.x * (x.x * y.w - y.x * x.w) + d.y * (x.y * y.w - y.y * x.w)));
  });
}

int compare_lexicographically(const ExactPoint& p, const ExactPoint& q, Tally& tally) {
  Grid grid;
  include(grid, p);
  include(grid, q);
  const int bits = crossing_bits(grid.bits()) + denominator_bits(grid.bits()) + 1;
  return with_integers(bits, tally, [&]<class Integer>() {
    const auto x = homogeneous<Integer>(grid, p, {0, 0});
    const auto y = homogeneous<Integer>(grid, q, {0, 0});
    const int by_x = sign(Integer(x.x * y.w - y.x * x.w));
    return by_x != 0 ? by_x : sign(Integer(x.y * y.w - y.y * x.w));
  });
}

double nearest_distance(const ExactPoint& p, const Point& from, Tally& tally) {
  if (p.is_sum) {
    return nearest_gap({{p.sum, {}, {}, 0, 0}, {from, {0, 0}}, false}, tally);
  }
  if (const std::optional<RoundedNumber> in_doubles = rounded_distance(p.s, p.t, from)) {
    ++tally.filtered;
    return in_doubles->value;
  }
  Grid grid{from};
  include(grid, p);
  return with_integers(root_bits(square_bits(grid.bits())), tally, [&]<class Integer>() {
    const auto x = homogeneous<Integer>(grid, p, negated(from));
    if constexpr (std::is_same_v<Integer, Int128>) {
      return nearest_root(Int256(square_of_length(x)), Int256(x.w * x.w), grid.exponent()).value;
    } else {
      return nearest_root(square_of_length(x), Integer(x.w * x.w), grid.exponent()).value;
    }
  });
}

}  // namespace gcv
