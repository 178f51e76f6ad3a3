// SPDX-License-Identifier: LGPL-3.0-or-later
#include "gap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <tuple>
#include <type_traits>

#include "ball.hpp"
#include "double_double.hpp"
#include "double_double_rounding.hpp"
#include "exact_numbers.hpp"
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

bool is_in_range(const DoubleDoubleVector& v) {
  return gcv::is_in_range(v.x.hi) && gcv::is_in_range(v.y.hi);
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

// The sign of the sum of at most twelve doubles. Nothing where it overflows. The parts do not
// overlap, and each is smaller than the next. Source: Shewchuk, Adaptive Precision Floating-Point
// Arithmetic and Fast Robust Geometric Predicates, section 2.4.
std::optional<int> sign_of_sum(std::span<const double> numbers) {
  double parts[12];
  std::size_t count = 0;
  for (double number : numbers) {
    if (number == 0) {
      continue;
    }
    for (std::size_t k = 0; k < count; ++k) {
      const double sum = number + parts[k];
      parts[k] = rounding_error(number, parts[k], sum);
      number = sum;
    }
    if (!std::isfinite(number)) {
      return std::nullopt;
    }
    parts[count++] = number;
  }
  while (count > 0 && parts[count - 1] == 0) {
    --count;
  }
  return count == 0 ? 0 : parts[count - 1] > 0 ? 1 : -1;
}

// Numbers whose sum is the distance, where it is one along an axis.
std::optional<std::array<double, 6>> gap_along_axis(const Gap& gap) {
  const SumPoint& p = gap.point;
  const SumPoint& o = gap.edge.origin;
  const std::array<double, 6> x{p.a.x, -o.a.x, p.b.x, -o.b.x, p.c.x, -o.c.x};
  const std::array<double, 6> y{p.a.y, -o.a.y, p.b.y, -o.b.y, p.c.y, -o.c.y};
  const bool is_along_x = gap.is_to_line ? gap.edge.dx == 0 : sign_of_sum(y) == 0;
  const bool is_along_y = gap.is_to_line ? gap.edge.dy == 0 : sign_of_sum(x) == 0;
  if (!is_along_x && !is_along_y) {
    return std::nullopt;
  }
  std::array<double, 6> along = is_along_x ? x : y;
  if (sign_of_sum(along) == -1) {
    std::transform(along.begin(), along.end(), along.begin(), std::negate<>());
  }
  return along;
}

// The sign of p - q, if both are along an axis.
std::optional<int> compare_along_axis(const Gap& p, const Gap& q) {
  const auto along_p = gap_along_axis(p);
  const auto along_q = along_p ? gap_along_axis(q) : std::nullopt;
  if (!along_q) {
    return std::nullopt;
  }
  std::array<double, 12> difference;
  std::copy(along_p->begin(), along_p->end(), difference.begin());
  std::transform(along_q->begin(), along_q->end(), difference.begin() + 6, std::negate<>());
  return sign_of_sum(difference);
}

Ball length_of(const DoubleDoubleVector& v) {
  const Ball x = Ball::of(v.x);
  const Ball y = Ball::of(v.y);
  return square_root(x * x + y * y);
}

std::optional<RoundedNumber> rounded_size(const DoubleDouble& x) {
  const Ball ball = Ball::of(x);
  return rounded(ball.hi < 0 ? -ball : ball);
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
    if (!is_in_range(direction) || !gcv::is_in_range(height.hi)) {
      return std::nullopt;
    }
    const Ball ball = Ball::of(height) / length_of(direction);
    return rounded(ball.hi < 0 ? -ball : ball);
  }
  if (offset.x.is_exact && offset.x.hi == 0) {
    return rounded_size(offset.y);
  }
  if (offset.y.is_exact && offset.y.hi == 0) {
    return rounded_size(offset.x);
  }
  if (!is_in_range(offset)) {
    return std::nullopt;
  }
  if (const std::optional<double> length = exact_length(offset)) {
    return RoundedNumber{*length, true};
  }
  return rounded(length_of(offset));
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
  if (const std::optional<int> along_axis = compare_along_axis(p, q)) {
    ++tally.filtered;
    return *along_axis;
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
  const std::optional<RoundedNumber> in_doubles = rounded_gap(p);
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
  if (const std::optional<RoundedNumber> in_doubles = rounded_gap(gap)) {
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
  const auto is_sure = [](const Ball& ball) { return ball.error <= 0x1p-60 * std::abs(ball.hi); };
  if (is_in_range(v)) {
    const Ball length = length_of(v);
    const Ball x = Ball::of(v.x) / length;
    const Ball y = Ball::of(v.y) / length;
    if (is_sure(x) && is_sure(y)) {
      ++tally.filtered;
      return {x.hi + 0.0, y.hi + 0.0};
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
