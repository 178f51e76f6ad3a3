// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Exact numbers in integers of four widths. Every finite double is an integer multiple of a power
// of two. So the operands of a predicate are integers on a common grid 2^exponent, and every
// predicate is the sign of a polynomial in integers. The bits of the operands decide how wide the
// integers must be: 128, 256 or 512 bits, or as many as doubles of any magnitude need. One formula
// serves all widths. None takes heap memory.
//
// Heavy headers: include this in source files only.
#pragma once

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cassert>
#include <climits>
#include <cstdint>
#include <initializer_list>

#include "big_integer.hpp"
#include "compiler.hpp"
#include "point.hpp"
#include "tally.hpp"

namespace gcv {

template <unsigned bits>
using FixedInteger = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<bits, bits, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;
#ifndef GCV_INT128
using Int128 = FixedInteger<128>;
#endif
using Int256 = FixedInteger<256>;
using Int512 = FixedInteger<512>;

inline int sign(Int128 value) { return (value > 0) - (value < 0); }
template <class Integer>
int sign(const Integer& value) {
  return value.sign();
}

// x = mantissa * 2^exponent. The mantissa is odd or 0.
struct Decomposed {
  std::int64_t mantissa;
  int exponent;
};

// The number of bits of the mantissa.
inline int bit_length(const Decomposed& d) {
  return static_cast<int>(
      std::bit_width(static_cast<std::uint64_t>(d.mantissa < 0 ? -d.mantissa : d.mantissa)));
}

inline Decomposed decompose(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto biased = static_cast<int>((bits >> 52) & 0x7ff);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const std::uint64_t magnitude = biased == 0 ? fraction : fraction | (std::uint64_t{1} << 52);
  if (magnitude == 0) {
    return {0, 0};
  }
  const int zeros = std::countr_zero(magnitude);
  const auto odd = static_cast<std::int64_t>(magnitude >> zeros);
  return {(bits >> 63) != 0 ? -odd : odd, std::max(biased, 1) - 1075 + zeros};
}

// The coarsest grid 2^exponent that holds all included numbers, and the bits of the largest of
// these: |x| < 2^(exponent + bits).
class Grid {
 public:
  Grid() = default;
  Grid(std::initializer_list<Point> points) {
    for (const Point& point : points) {
      include(point);
    }
  }

  void include(double x) {
    const Decomposed d = decompose(x);
    if (d.mantissa != 0) {
      lowest_ = std::min(lowest_, d.exponent);
      top_ = std::max(top_, d.exponent + bit_length(d));
    }
  }
  void include(const Point& p) {
    include(p.x);
    include(p.y);
  }
  void include(const SumPoint& p) {
    include(p.a);
    include(p.b);
    include(p.c);
  }
  void include(const SumEdge& edge) {
    include(edge.origin);
    include(edge.from);
    include(edge.to);
  }

  [[nodiscard]] int exponent() const { return top_ == INT_MIN ? 0 : lowest_; }
  [[nodiscard]] int bits() const { return top_ == INT_MIN ? 0 : top_ - lowest_; }

  // x as a multiple of the unit of the grid. x must be included.
  template <class Integer>
  [[nodiscard]] Integer integer(double x) const {
    const Decomposed d = decompose(x);
    assert(includes(d));
    Integer value(d.mantissa);
    if (d.mantissa != 0) {
      if constexpr (std::is_same_v<Integer, Int128>) {
        value *= Int128{1} << (d.exponent - lowest_);
      } else {
        value <<= d.exponent - lowest_;
      }
    }
    return value;
  }

 private:
  [[nodiscard]] bool includes(const Decomposed& d) const {
    return d.mantissa == 0 || (d.exponent >= lowest_ && d.exponent + bit_length(d) <= top_);
  }

  int lowest_ = INT_MAX;
  int top_ = INT_MIN;
};

template <class Integer>
struct Vector {
  Integer x;
  Integer y;
};

template <class Integer>
Vector<Integer> vector_between(const Grid& grid, const Point& from, const Point& to) {
  return {grid.integer<Integer>(to.x) - grid.integer<Integer>(from.x),
          grid.integer<Integer>(to.y) - grid.integer<Integer>(from.y)};
}

template <class Integer>
Vector<Integer> vector_between(const Grid& grid, const SumPoint& from, const SumPoint& to) {
  const auto a = vector_between<Integer>(grid, from.a, to.a);
  const auto b = vector_between<Integer>(grid, from.b, to.b);
  const auto c = vector_between<Integer>(grid, from.c, to.c);
  return {a.x + b.x + c.x, a.y + b.y + c.y};
}

// A point of the sum plus a shift, in units of the grid. Let b be the bits of the grid. Then each
// coordinate is below 2^(b+2).
template <class Integer>
Vector<Integer> sum_of(const Grid& grid, const SumPoint& p, const Point& shift) {
  const auto sum = [&](double a, double b, double c, double d) {
    return Integer(grid.integer<Integer>(a) + grid.integer<Integer>(b) + grid.integer<Integer>(c) +
                   grid.integer<Integer>(d));
  };
  return {sum(p.a.x, p.b.x, p.c.x, shift.x), sum(p.a.y, p.b.y, p.c.y, shift.y)};
}

template <class Integer>
Integer cross(const Vector<Integer>& v, const Vector<Integer>& w) {
  return v.x * w.y - v.y * w.x;
}

// Runs formula<Integer>() with the narrowest integers that hold magnitudes of so many bits.
template <class Formula>
auto with_integers(int bits, Tally& tally, Formula formula) {
  if (bits <= 512) {
    ++tally.fixed_width;
    if (bits <= 127) {
      return formula.template operator()<Int128>();
    }
    if (bits <= 256) {
      return formula.template operator()<Int256>();
    }
    return formula.template operator()<Int512>();
  }
  assert(bits <= big_integer_bits);
  ++tally.rational;
  return formula.template operator()<BigInteger>();
}

// The crossing of two superset edges, exactly: the point (x / w, y / w) * 2^exponent with w > 0.
// The numbers are integers on the grid. The edges must not be parallel.
//
//   o_s + lambda d_s  with  lambda = N / D,  N = (o_t - o_s) x d_t,  D = d_s x d_t.
//
// Let b be the bits of the grid. Then |o + r| < 2^(b+2) with the shift r, |d| < 2^(b+1),
// |o_t - o_s| < 2^(b+3), |D| < 2^(2b+3) and |N| < 2^(2b+5). So |x| < 2^(3b+7).
template <class Integer>
struct HomogeneousPoint {
  Integer x;
  Integer y;
  Integer w;
};

constexpr int crossing_bits(int grid_bits) { return 3 * grid_bits + 7; }

template <class Integer>
HomogeneousPoint<Integer> crossing(const Grid& grid, const SumEdge& s, const SumEdge& t,
                                   const Point& shift) {
  const auto ds = vector_between<Integer>(grid, s.from, s.to);
  const auto dt = vector_between<Integer>(grid, t.from, t.to);
  const auto offset = vector_between<Integer>(grid, s.origin, t.origin);
  Integer n = cross(offset, dt);
  Integer d = cross(ds, dt);
  assert(sign(d) != 0);
  if (sign(d) < 0) {
    n = -n;
    d = -d;
  }
  const Vector<Integer> origin = sum_of<Integer>(grid, s.origin, shift);
  return {origin.x * d + n * ds.x, origin.y * d + n * ds.y, d};
}

}  // namespace gcv
