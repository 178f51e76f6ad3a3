// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Double-double arithmetic: a number is the sum hi + lo of two doubles, with twice the digits of
// one. Used when one double cannot decide, before integers. u = 2^-53 is half the distance from 1
// to the next double.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include "fma.hpp"
#include "point.hpp"

namespace gcv {

constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

// The rounding error of `sum`, the double nearest to x + y. The error is a double, exactly. NaN if
// the sum overflows, and maybe if it is next to the end of the range. Source: TwoSum in Knuth, The
// Art of Computer Programming, volume 2, section 4.2.2.
template <class Number>  // double, or a SIMD vector of doubles
inline Number rounding_error(Number x, Number y, Number sum) {
  const Number y_part = sum - x;
  return (x - (sum - y_part)) + (y - y_part);
}

// x + y + z, within a few u times itself.
inline double rounded_sum(double x, double y, double z) {
  const double first = x + y;
  const double sum = first + z;
  return sum + (rounding_error(x, y, first) + rounding_error(first, z, sum));
}

// The same of four numbers. Each is added to what the others are exactly: doubles of falling size
// that do not overlap. Source: Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast
// Robust Geometric Predicates, section 2.4.
inline double rounded_sum(double w, double x, double y, double z) {
  double parts[4] = {w, 0, 0, 0};  // from the smallest on
  std::size_t count = 1;
  for (const double number : {x, y, z}) {
    double sum = number;
    for (std::size_t k = 0; k < count; ++k) {
      const double larger = sum + parts[k];
      parts[k] = rounding_error(sum, parts[k], larger);
      sum = larger;
    }
    parts[count++] = sum;
  }
  return ((parts[0] + parts[1]) + parts[2]) + parts[3];
}

// The number hi + lo: a difference, or a sum of two or three differences. It is off by at most
// 14u^2 size. It is exact if `is_exact`.
struct DoubleDouble {
  double hi;
  double lo;
  double size;  // at least (1 - 3u) |number|, and at least |lo| / 5u
  bool is_exact;

  [[nodiscard]] bool is_double() const { return is_exact && lo == 0; }
};

inline DoubleDouble two_sum(double x, double y) {
  const double hi = x + y;
  const double lo = rounding_error(x, y, hi);
  return {hi, lo, std::abs(hi), !std::isnan(lo)};
}

inline DoubleDouble operator+(const DoubleDouble& p, const DoubleDouble& q) {
  const double hi = p.hi + q.hi;
  const double error = rounding_error(p.hi, q.hi, hi);
  return {hi, (error + p.lo) + q.lo, p.size + q.size, p.is_double() && q.is_double()};
}

struct DoubleDoubleVector {
  DoubleDouble x;
  DoubleDouble y;
};

// The vector from one point to another.
inline DoubleDoubleVector double_double_vector(const Point& from, const Point& to) {
  return {two_sum(to.x, -from.x), two_sum(to.y, -from.y)};
}
inline DoubleDoubleVector double_double_vector(const SumPoint& from, const SumPoint& to) {
  const DoubleDoubleVector a = double_double_vector(from.a, to.a);
  const DoubleDoubleVector b = double_double_vector(from.b, to.b);
  if (from.c == to.c) {
    return {a.x + b.x, a.y + b.y};
  }
  const DoubleDoubleVector c = double_double_vector(from.c, to.c);
  return {(a.x + b.x) + c.x, (a.y + b.y) + c.y};
}

// Is the rounded product exact? `error` is the rounding error that fused multiply-add gives.
inline bool is_exact_product(double x, double y, double product, double error) {
  return error == 0 && (std::abs(product) >= 0x1p-900 || x == 0 || y == 0);
}

// A cross product. It is within `error` of hi + lo. hi is the double nearest to hi + lo. The error
// is infinite if the product is out of range. It is 0 only if hi is the exact product.
struct DoubleDoubleCross {
  double hi;
  double lo;
  double error;
};

// v x w. Here v is a vector between two points, and w is one between two points or between two
// sums.
//
// Error bound. Let mx and my be the sizes of w, and s = |vx| my + |vy| mx. Each product leaves out
// lo times lo and the error of w: below 20u^2 of its share of s. The two other terms with a lo part
// have roundings below 20u^2 of the share. The lo parts that are added up are together below 10u s,
// so the roundings of the additions are below 40u^2 s. The bound 128u^2 s is more than all of
// these. The products are far from underflow. So fused multiply-add gives their errors, except for
// an absolute error far below the bound.
inline DoubleDoubleCross double_double_cross(const DoubleDoubleVector& v,
                                             const DoubleDoubleVector& w) {
  const auto& [vx, vy] = v;
  const auto& [wx, wy] = w;
  if (wx.size == 0 && wy.size == 0) {
    return {0, 0, 0};
  }
  const double size = vx.size * wy.size + vy.size * wx.size;
  const double left = vx.hi * wy.hi;
  const double right = vy.hi * wx.hi;
  const double difference = left - right;
  const double left_error = gcv::fma(vx.hi, wy.hi, -left);
  const double right_error = gcv::fma(vy.hi, wx.hi, -right);
  const double difference_error = rounding_error(left, -right, difference);
  const bool in_range = size >= 0x1p-900 && size <= 0x1p1000;
  if (in_range && difference_error == 0 && vx.is_double() && vy.is_double() && wx.is_double() &&
      wy.is_double() && is_exact_product(vx.hi, wy.hi, left, left_error) &&
      is_exact_product(vy.hi, wx.hi, right, right_error)) {
    return {difference, 0, 0};
  }
  const double left_lo = left_error + (vx.hi * wy.lo + vx.lo * wy.hi);
  const double right_lo = right_error + (vy.hi * wx.lo + vy.lo * wx.hi);
  const double lo = difference_error + (left_lo - right_lo);
  const double hi = difference + lo;
  return {hi, rounding_error(difference, lo, hi),
          in_range ? 128 * unit_roundoff * unit_roundoff * size : infinity};
}

// The parameter lambda of a crossing: the line of t crosses the line of s in o_s + lambda d_s.
// lambda is within `error` of hi + lo. If is_fraction, lambda is exactly n / d.
struct DoubleDoubleParameter {
  double hi;
  double lo;
  double error;
  bool is_fraction;
  double n;
  double d;
};

// lambda = N / D with N = (o_t - o_s) x d_t and D = d_s x d_t. Both are computed with the opposite
// sign.
//
// Error bound, for |D| at least four times its error eD. The quotient of the exact numbers differs
// from that of the computed ones by at most 2 (eN + |lambda| eD) / |D|. The remainder of the
// division is a double. The remainder, the lo part of N and that of lambda D are below 3u |N| each.
// The roundings of their sum and of the second quotient are below 32u^2 |lambda|.
inline DoubleDoubleParameter double_double_parameter(const SumEdge& s, const SumEdge& t) {
  const DoubleDoubleVector direction = double_double_vector(t.from, t.to);
  const DoubleDoubleCross n =
      double_double_cross(direction, double_double_vector(s.origin, t.origin));
  const DoubleDoubleCross d = double_double_cross(direction, double_double_vector(s.from, s.to));
  const double hi = n.hi / d.hi;
  const double lo = ((gcv::fma(-hi, d.hi, n.hi) + n.lo) - hi * d.lo) / d.hi;
  const double size = std::abs(hi);
  const double error =
      2 * (n.error + size * d.error) / std::abs(d.hi) + 32 * unit_roundoff * unit_roundoff * size;
  return {hi,
          lo,
          std::abs(d.hi) > 4 * d.error ? error : infinity,
          n.error == 0 && d.error == 0 && d.hi != 0,
          n.hi,
          d.hi};
}

}  // namespace gcv
