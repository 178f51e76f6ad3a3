// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Numbers as sums of two doubles, which hold twice the digits: for what one double leaves
// open, before integers are needed. u = 2^-53 is half the distance from 1 to the next double.
#pragma once

#include <cmath>
#include <limits>

#include "point.hpp"

namespace gcv {

constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

// What rounding took from `sum`, the double nearest to x + y (TwoSum; Knuth, The Art of
// Computer Programming, volume 2, section 4.2.2): a double, exactly. NaN where the sum
// overflows, and maybe where it lies next to the end of the range.
template <class Number>  // double, or some side by side
inline Number rounding_error(Number x, Number y, Number sum) {
  const Number y_part = sum - x;
  return (x - (sum - y_part)) + (y - y_part);
}

// head + tail, which is off by at most 5u^2 size; not at all where `is_exact`.
struct DoubledNumber {
  double head;
  double tail;
  double size;  // at least (1 - 3u) |number|, and at least |tail| / 3u
  bool is_exact;

  [[nodiscard]] bool is_double() const { return is_exact && tail == 0; }
};

inline DoubledNumber doubled_sum(double x, double y) {
  const double head = x + y;
  const double tail = rounding_error(x, y, head);
  return {head, tail, std::abs(head), !std::isnan(tail)};
}

inline DoubledNumber operator+(const DoubledNumber& p, const DoubledNumber& q) {
  const double head = p.head + q.head;
  const double error = rounding_error(p.head, q.head, head);
  return {head, (error + p.tail) + q.tail, p.size + q.size, p.is_double() && q.is_double()};
}

struct DoubledVector {
  DoubledNumber x;
  DoubledNumber y;
};

// The way from one point to another.
inline DoubledVector doubled_vector(const Point& from, const Point& to) {
  return {doubled_sum(to.x, -from.x), doubled_sum(to.y, -from.y)};
}
inline DoubledVector doubled_vector(const SumPoint& from, const SumPoint& to) {
  const DoubledVector a = doubled_vector(from.a, to.a);
  const DoubledVector b = doubled_vector(from.b, to.b);
  return {a.x + b.x, a.y + b.y};
}

// Is the rounded product exact, given what it was rounded by?
inline bool is_exact_product(double x, double y, double product, double error) {
  return error == 0 && (std::abs(product) >= 0x1p-900 || x == 0 || y == 0);
}

// A cross product: within `error` of head + tail, the head being the double nearest to that sum.
// The error is infinite where it is out of range, and 0 only where the head is exact.
struct DoubledCross {
  double head;
  double tail;
  double error;
};

// v x w, v being the way between two points, and w that, or the way between two sums.
//
// With s = |vx| my + |vy| mx, m the sizes of w: what is left out of a product, tail times tail
// and the error of w, is below 9u^2 of its share of s, and the roundings of the other two terms
// with tails below 9u^2. The tails that are added up are below 10u s together, so that
// their roundings are below 40u^2 s; 128u^2 is more than all. The products are so far from
// underflow that fused multiply-add gives their errors, up to an absolute error far below.
inline DoubledCross doubled_cross(const DoubledVector& v, const DoubledVector& w) {
  const auto& [vx, vy] = v;
  const auto& [wx, wy] = w;
  const double size = vx.size * wy.size + vy.size * wx.size;
  const double left = vx.head * wy.head;
  const double right = vy.head * wx.head;
  const double difference = left - right;
  const double left_error = std::fma(vx.head, wy.head, -left);
  const double right_error = std::fma(vy.head, wx.head, -right);
  const double difference_error = rounding_error(left, -right, difference);
  const bool in_range = size >= 0x1p-900 && size <= 0x1p1000;
  if (in_range && difference_error == 0 && vx.is_double() && vy.is_double() && wx.is_double() &&
      wy.is_double() && is_exact_product(vx.head, wy.head, left, left_error) &&
      is_exact_product(vy.head, wx.head, right, right_error)) {
    return {difference, 0, 0};
  }
  const double left_tail = left_error + (vx.head * wy.tail + vx.tail * wy.head);
  const double right_tail = right_error + (vy.head * wx.tail + vy.tail * wx.head);
  const double tail = difference_error + (left_tail - right_tail);
  const double head = difference + tail;
  return {head, rounding_error(difference, tail, head),
          in_range ? 128 * unit_roundoff * unit_roundoff * size
                   : std::numeric_limits<double>::infinity()};
}

// lambda, where the line of t crosses that of s in o_s + lambda d_s, as `head` + `tail`, within
// `error`; if is_fraction, it is exactly n / d.
struct DoubledParameter {
  double head;
  double tail;
  double error;
  bool is_fraction;
  double n;
  double d;
};

// N / D with N = (o_t - o_s) x d_t and D = d_s x d_t, both with their signs changed.
//
// With |D| at least four times its error eD: the quotient of the exact numbers differs from
// that of the computed ones by at most 2 (eN + |lambda| eD) / |D|. The remainder of a division
// is a double; what is added to it, the tails of N and of lambda D, and the remainder itself are
// below 3u |N| each, their roundings and those of the second quotient below 32u^2 |lambda|.
inline DoubledParameter doubled_parameter(const SumEdge& s, const SumEdge& t) {
  const DoubledVector direction = doubled_vector(t.from, t.to);
  const DoubledCross n = doubled_cross(direction, doubled_vector(s.origin, t.origin));
  const DoubledCross d = doubled_cross(direction, doubled_vector(s.from, s.to));
  const double head = n.head / d.head;
  const double tail = ((std::fma(-head, d.head, n.head) + n.tail) - head * d.tail) / d.head;
  const double size = std::abs(head);
  const double error =
      2 * (n.error + size * d.error) / std::abs(d.head) + 32 * unit_roundoff * unit_roundoff * size;
  return {head,
          tail,
          std::abs(d.head) > 4 * d.error ? error : std::numeric_limits<double>::infinity(),
          n.error == 0 && d.error == 0 && d.head != 0,
          n.head,
          d.head};
}

}  // namespace gcv
