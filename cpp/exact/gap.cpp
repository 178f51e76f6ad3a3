// SPDX-License-Identifier: LGPL-3.0-or-later
#include "gap.hpp"

#include <cmath>
#include <optional>
#include <tuple>
#include <type_traits>

#include "ball.hpp"
#include "double_double.hpp"
#include "double_double_rounding.hpp"
#include "exact_numbers.hpp"
#include "expansion.hpp"
#include "fma.hpp"
#include "predicates.hpp"
#include "to_double.hpp"

namespace gcv {

namespace {

// The grid of the numbers that the distance is computed from.
void include(Grid& grid, const Gap& gap) {
  grid.include(gap.edge);
  grid.include(gap.point);
}

// The square of a distance, n / w, in squares of the unit of the grid.
//
// Let b be the bits of the grid. Then a difference of two numbers is below 2^(b+1), and that of two
// sums below 2^(b+3). So w < 2^(2b+3). The cross product is below 2^(2b+5), and n < 2^(4b+10).
template <class Integer>
struct Square {
  Integer n;
  Integer w;
};

constexpr int gap_square_bits(int grid_bits) { return 4 * grid_bits + 10; }

template <class Integer>
Integer square(const Vector<Integer>& v) {
  return v.x * v.x + v.y * v.y;
}

template <class Integer>
Square<Integer> square_of(const Grid& grid, const Gap& gap) {
  const auto offset = vector_between<Integer>(grid, gap.edge.origin, gap.point);
  if (!gap.is_to_line) {
    return {square(offset), Integer(1)};
  }
  const auto direction = vector_between<Integer>(grid, gap.edge.from, gap.edge.to);
  const Integer height = cross(direction, offset);
  return {height * height, square(direction)};
}

// nearest_root() has no root of 128-bit integers.
template <class Integer>
double nearest_root_of(const Integer& n, const Integer& w, int exponent) {
  if constexpr (std::is_same_v<Integer, Int128>) {
    return nearest_root(Int256(n), Int256(w), exponent).value;
  } else {
    return nearest_root(n, w, exponent).value;
  }
}

DoubleDoubleVector offset_of(const Gap& gap) {
  return double_double_vector(gap.edge.origin, gap.point);
}

// sqrt(x^2 + y^2) where it is a double and nothing is rounded.
std::optional<double> exact_length(const DoubleDoubleVector& v) {
  if (!v.x.is_double() || !v.y.is_double()) {
    return std::nullopt;
  }
  const double x = v.x.hi * v.x.hi;
  const double y = v.y.hi * v.y.hi;
  const double sum = x + y;
  const double root = std::sqrt(sum);
  const bool is_exact = gcv::fma(v.x.hi, v.x.hi, -x) == 0 && gcv::fma(v.y.hi, v.y.hi, -y) == 0 &&
                        rounding_error(x, y, sum) == 0 && gcv::fma(root, root, -sum) == 0;
  return is_exact ? std::optional(root) : std::nullopt;
}

bool is_exactly_zero(const DoubleDouble& x) { return x.is_double() && x.hi == 0; }

// The distance, or its opposite, where it is one along an axis.
const Expansion<6>* along_axis(const Gap& gap, const ExactVector& offset) {
  const bool is_along_x = gap.is_to_line ? gap.edge.dx == 0 : offset.y.sign() == 0;
  const bool is_along_y = gap.is_to_line ? gap.edge.dy == 0 : offset.x.sign() == 0;
  return is_along_x ? &offset.x : is_along_y ? &offset.y : nullptr;
}

// The length of a vector, if its numbers are in range.
std::optional<Ball> length_of(const Ball& x, const Ball& y) {
  return is_in_range(x.hi) && is_in_range(y.hi) ? std::optional(square_root(x * x + y * y))
                                                : std::nullopt;
}
std::optional<Ball> length_of(const DoubleDoubleVector& v) {
  return length_of(Ball::of(v.x), Ball::of(v.y));
}
std::optional<Ball> length_of(const ExactVector& v) {
  return length_of(v.x.leading(), v.y.leading());
}

Ball size_of(const Ball& x) { return x.hi < 0 ? -x : x; }

std::optional<RoundedNumber> rounded_size(const DoubleDouble& x) {
  return rounded(size_of(Ball::of(x)));
}

// The distance, by exact sums: what it leaves out is small beside it, however close the point is.
// Nothing where numbers are out of range.
std::optional<Ball> leading_gap(const Gap& gap, const ExactVector& offset) {
  if (!offset.is_finite()) {
    return std::nullopt;
  }
  if (const Expansion<6>* along = along_axis(gap, offset)) {
    return size_of(along->leading());
  }
  if (!gap.is_to_line) {
    return length_of(offset);
  }
  const ExactVector direction({gap.edge.from, {0, 0}}, {gap.edge.to, {0, 0}});
  if (!offset.has_exact_products() || !direction.has_exact_products()) {
    return std::nullopt;
  }
  Expansion<48> height;  // two products of 2 by 6 parts, each of two doubles
  height.add_product(direction.x, offset.y);
  height.subtract_product(direction.y, offset.x);
  const Ball leading = height.leading();
  const std::optional<Ball> length = length_of(direction);
  return length && gcv::is_in_range(leading.hi) ? std::optional(size_of(leading) / *length)
                                                : std::nullopt;
}

// In double-double arithmetic, where that is certain.
std::optional<RoundedNumber> rounded_gap(const Gap& gap) {
  const DoubleDoubleVector offset = offset_of(gap);
  if (gap.is_to_line) {
    const DoubleDoubleVector direction = double_double_vector(gap.edge.from, gap.edge.to);
    if (direction.x.hi == 0) {
      return rounded_size(offset.x);
    }
    if (direction.y.hi == 0) {
      return rounded_size(offset.y);
    }
    const DoubleDoubleCross height = double_double_cross(direction, offset);
    const std::optional<Ball> length = length_of(direction);
    return length && is_in_range(height.hi) ? rounded(size_of(Ball::of(height)) / *length)
                                            : std::nullopt;
  }
  if (offset.x.is_exact && offset.x.hi == 0) {
    return rounded_size(offset.y);
  }
  if (offset.y.is_exact && offset.y.hi == 0) {
    return rounded_size(offset.x);
  }
  const std::optional<Ball> length = length_of(offset);
  if (!length) {
    return std::nullopt;
  }
  if (const std::optional<double> exact = exact_length(offset)) {
    return RoundedNumber{*exact, true};
  }
  return rounded(*length);
}

// The double nearest to the distance, where that is certain without integers.
std::optional<RoundedNumber> quickly_rounded_gap(const Gap& gap) {
  if (const std::optional<RoundedNumber> in_doubles = rounded_gap(gap)) {
    return in_doubles;
  }
  const std::optional<Ball> leading = leading_gap(gap, ExactVector(gap.edge.origin, gap.point));
  return leading ? rounded(*leading) : std::nullopt;
}

// The sign of p - q, where it is certain without integers.
std::optional<int> compare_leading_gaps(const Gap& p, const Gap& q) {
  const ExactVector offset_p(p.edge.origin, p.point);
  const ExactVector offset_q(q.edge.origin, q.point);
  const std::optional<Ball> left = leading_gap(p, offset_p);
  const std::optional<Ball> right = left ? leading_gap(q, offset_q) : std::nullopt;
  if (!right) {
    return std::nullopt;
  }
  const Ball difference = *left + -*right;
  if (std::abs(difference.hi) > 2 * difference.error) {
    return difference.hi > 0 ? 1 : -1;
  }
  const Expansion<6>* along_p = along_axis(p, offset_p);
  const Expansion<6>* along_q = along_axis(q, offset_q);
  if (along_p == nullptr || along_q == nullptr) {
    return std::nullopt;
  }
  Expansion<12> exact;
  exact.add_product(along_p->sign(), *along_p);
  exact.add_product(-along_q->sign(), *along_q);
  return exact.sign();
}

// The vector over its length. Nothing where that may be more than an ulp off.
std::optional<Point> unit_vector(const Ball& x, const Ball& y) {
  const std::optional<Ball> length = length_of(x, y);
  if (!length) {
    return std::nullopt;
  }
  const auto is_sure = [](const Ball& ball) { return ball.error <= 0x1p-60 * std::abs(ball.hi); };
  const Ball unit_x = x / *length;
  const Ball unit_y = y / *length;
  return is_sure(unit_x) && is_sure(unit_y) ? std::optional(Point{unit_x.hi + 0.0, unit_y.hi + 0.0})
                                            : std::nullopt;
}

// The largest double at most n / d, by the remainder of the rounded quotient, which is a double.
std::optional<double> quotient_below(double n, double d) {
  const double quotient = n / d;
  if (!gcv::is_in_range(n) || !gcv::is_in_range(d) || !gcv::is_in_range(quotient)) {
    return std::nullopt;
  }
  const double remainder = gcv::fma(-quotient, d, n);
  const bool is_above = remainder != 0 && (remainder < 0) != (d < 0);
  return is_above ? std::nextafter(quotient, -1.0) : quotient + 0.0;
}

Point turned_left(const Point& p) { return {-p.y, p.x}; }

}  // namespace

int compare_gaps(const Gap& p, const Gap& q, Tally& tally) {
  if (const std::optional<int> order = compare_leading_gaps(p, q)) {
    ++tally.filtered;
    return *order;
  }
  Grid grid;
  include(grid, p);
  include(grid, q);
  return with_integers(gap_square_bits(grid.bits()) + 2 * grid.bits() + 3, tally,
                       [&]<class Integer>() {
                         const Square<Integer> left = square_of<Integer>(grid, p);
                         const Square<Integer> right = square_of<Integer>(grid, q);
                         return sign(Integer(left.n * right.w - right.n * left.w));
                       });
}

bool is_zero(const Gap& gap, Tally& tally) {
  const SumPoint& p = gap.edge.origin;
  const SumPoint& q = gap.point;
  return gap.is_to_line ? side(gap.edge, q, tally) == 0 : are_equal(p, q, tally);
}

// Rounding is monotonic: if the rounded gap is not the distance, it decides.
int compare_gap(const Gap& p, double distance, Tally& tally) {
  if (distance == 0) {
    return is_zero(p, tally) ? 0 : 1;
  }
  const std::optional<RoundedNumber> in_doubles = quickly_rounded_gap(p);
  if (in_doubles && in_doubles->value != distance) {
    ++tally.filtered;
    return in_doubles->value < distance ? -1 : 1;
  }
  Grid grid;
  include(grid, p);
  grid.include(distance);
  return with_integers(gap_square_bits(grid.bits()) + 2, tally, [&]<class Integer>() {
    const Square<Integer> left = square_of<Integer>(grid, p);
    const auto right = grid.integer<Integer>(distance);
    return sign(Integer(left.n - right * right * left.w));
  });
}

double nearest_gap(const Gap& gap, Tally& tally) {
  if (const std::optional<RoundedNumber> in_doubles = quickly_rounded_gap(gap)) {
    ++tally.filtered;
    return in_doubles->value;
  }
  Grid grid;
  include(grid, gap);
  return with_integers(root_bits(gap_square_bits(grid.bits())), tally, [&]<class Integer>() {
    const Square<Integer> squared = square_of<Integer>(grid, gap);
    return nearest_root_of(squared.n, squared.w, grid.exponent());
  });
}

Point nearest_unit_vector(const SumPoint& from, const SumPoint& to, Tally& tally) {
  const DoubleDoubleVector v = double_double_vector(from, to);
  const bool is_along_x = is_exactly_zero(v.y);
  const DoubleDouble& other = is_along_x ? v.x : v.y;
  const double along = other.hi + other.lo;
  if ((is_along_x || is_exactly_zero(v.x)) && std::abs(along) > 0x1p-100 * other.size) {
    ++tally.filtered;
    const double unit = std::copysign(1.0, along);
    return is_along_x ? Point{unit, 0} : Point{0, unit};
  }
  if (const auto unit = unit_vector(Ball::of(v.x), Ball::of(v.y))) {
    ++tally.filtered;
    return *unit;
  }
  const ExactVector sums(from, to);
  if (sums.is_finite()) {
    if (const auto unit = unit_vector(sums.x.leading(), sums.y.leading())) {
      ++tally.filtered;
      return *unit;
    }
  }
  Grid grid;
  grid.include(from);
  grid.include(to);
  return with_integers(root_bits(2 * grid.bits() + 7), tally, [&]<class Integer>() {
    const auto exact = vector_between<Integer>(grid, from, to);
    const Integer w = square(exact);
    const auto coordinate = [&](const Integer& x) {
      const double size = nearest_root_of(Integer(x * x), w, 0);
      return sign(x) < 0 ? 0.0 - size : size;
    };
    return Point{coordinate(exact.x), coordinate(exact.y)};
  });
}

SumEdge perpendicular(const SumEdge& edge, const SumPoint& point) {
  return {point, turned_left(edge.from), turned_left(edge.to), -edge.dy, edge.dx};
}

double parameter_below(const SumEdge& s, const SumEdge& t, Tally& tally) {
  const DoubleDoubleParameter lambda = double_double_parameter(s, t);
  if (lambda.is_fraction) {
    if (const std::optional<double> below = quotient_below(lambda.n, lambda.d)) {
      ++tally.fixed_width;
      return *below;
    }
  }
  const Ball ball = Ball::normal(lambda.hi, lambda.lo, lambda.error);
  if (std::abs(ball.lo) > ball.error && rounded(ball) && ball.hi > 0x1p-200) {
    ++tally.fixed_width;
    return ball.lo < 0 ? std::nextafter(ball.hi, -1.0) : ball.hi;
  }
  Grid grid;
  grid.include(s);
  grid.include(t);
  return with_integers(rounding_bits(2 * grid.bits() + 5), tally, [&]<class Integer>() {
    const auto dt = vector_between<Integer>(grid, t.from, t.to);
    const Integer n = cross(vector_between<Integer>(grid, s.origin, t.origin), dt);
    const Integer d = cross(vector_between<Integer>(grid, s.from, s.to), dt);
    return sign(d) < 0 ? double_below(Integer(-n), Integer(-d)) : double_below(n, d);
  });
}

Point nearest_point(const SumPoint& point, Tally& tally, const Point& shift) {
  if (const auto in_doubles = rounded_sum(point, shift)) {
    ++tally.filtered;
    return {in_doubles->x.value + 0.0, in_doubles->y.value + 0.0};
  }
  Grid grid{shift};
  grid.include(point);
  return with_integers(rounding_bits(grid.bits() + 2), tally, [&]<class Integer>() {
    const auto [x, y] = sum_of<Integer>(grid, point, shift);
    const auto nearest = [&](const Integer& coordinate) {
      return nearest_double(coordinate, Integer(1), grid.exponent()).value + 0.0;
    };
    return Point{nearest(x), nearest(y)};
  });
}

Point nearest_crossing(const SumEdge& s, const SumEdge& t, Tally& tally, const Point& shift) {
  if ((s.dx == 0 && t.dy == 0) || (s.dy == 0 && t.dx == 0)) {
    const auto& [p, q] = s.dx == 0 ? std::tie(s.origin, t.origin) : std::tie(t.origin, s.origin);
    return nearest_point({{p.a.x, q.a.y}, {p.b.x, q.b.y}, {p.c.x, q.c.y}}, tally, shift);
  }
  if (const auto in_doubles = rounded_crossing(s, t, shift)) {
    ++tally.filtered;
    return {in_doubles->x.value + 0.0, in_doubles->y.value + 0.0};
  }
  Grid grid{shift};
  grid.include(s);
  grid.include(t);
  return with_integers(rounding_bits(crossing_bits(grid.bits())), tally, [&]<class Integer>() {
    const HomogeneousPoint<Integer> p = crossing<Integer>(grid, s, t, shift);
    return Point{nearest_double(p.x, p.w, grid.exponent()).value + 0.0,
                 nearest_double(p.y, p.w, grid.exponent()).value + 0.0};
  });
}

}  // namespace gcv
