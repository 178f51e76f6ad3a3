// SPDX-License-Identifier: LGPL-3.0-or-later
//
// SIMD vectors of four doubles, eight floats or eight 16-bit integers. Each is built from registers
// of 16 bytes, which all common machines have. Each operation gives the same bits as the operation
// on single numbers.
#pragma once

#include "compiler.hpp"

#ifdef GCV_SSE2
#include <emmintrin.h>
#endif

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

namespace gcv {

// less() gives -1 in each lane where p < q, else 0. bits_of() has bit k set if lane k is -1. With
// SSE2 both use the instruction itself. For the plain expression g++ 12 makes up to twelve
// instructions, which is half of the time of comparing eight boxes.
#ifdef GCV_SSE2
inline PairOfMasks less(const PairOfDoubles& p, const PairOfDoubles& q) {
  return std::bit_cast<PairOfMasks>(_mm_cmplt_pd(p, q));
}
inline unsigned bits_of(const PairOfMasks& masks) {
  return static_cast<unsigned>(_mm_movemask_pd(std::bit_cast<__m128d>(masks)));
}
#else
inline PairOfMasks less(const PairOfDoubles& p, const PairOfDoubles& q) { return p < q; }
inline unsigned bits_of(const PairOfMasks& masks) {
  return static_cast<unsigned>((masks[0] & 1) | (masks[1] & 2));
}
#endif

inline PairOfDoubles magnitude(const PairOfDoubles& p) {
  constexpr PairOfMasks all_but_sign{std::numeric_limits<std::int64_t>::max(),
                                     std::numeric_limits<std::int64_t>::max()};
  return std::bit_cast<PairOfDoubles>(std::bit_cast<PairOfMasks>(p) & all_but_sign);
}

struct DoubleMask {
  PairOfMasks low;
  PairOfMasks high;

  friend DoubleMask operator|(const DoubleMask& p, const DoubleMask& q) {
    return {p.low | q.low, p.high | q.high};
  }
  // Bit k is set if lane k is.
  [[nodiscard]] unsigned bits() const { return bits_of(low) | bits_of(high) << 2U; }
};

struct SimdDouble {
  static constexpr std::uint32_t width = 4;
  static constexpr unsigned all = 15;

  PairOfDoubles low;
  PairOfDoubles high;

  // Has the same number in all lanes.
  static SimdDouble of(double x) { return {PairOfDoubles{x, x}, PairOfDoubles{x, x}}; }
  static SimdDouble load(const double* numbers) {
    SimdDouble lanes;
    std::memcpy(&lanes.low, numbers, sizeof lanes.low);
    std::memcpy(&lanes.high, numbers + 2, sizeof lanes.high);
    return lanes;
  }
  void store(double* numbers) const {
    std::memcpy(numbers, &low, sizeof low);
    std::memcpy(numbers + 2, &high, sizeof high);
  }

  friend SimdDouble operator+(const SimdDouble& p, const SimdDouble& q) {
    return {p.low + q.low, p.high + q.high};
  }
  friend SimdDouble operator-(const SimdDouble& p, const SimdDouble& q) {
    return {p.low - q.low, p.high - q.high};
  }
  friend SimdDouble operator+(const SimdDouble& p, double x) { return {p.low + x, p.high + x}; }
  friend SimdDouble operator-(double x, const SimdDouble& p) { return {x - p.low, x - p.high}; }
  friend SimdDouble operator/(double x, const SimdDouble& p) { return {x / p.low, x / p.high}; }
  friend SimdDouble operator*(const SimdDouble& p, const SimdDouble& q) {
    return {p.low * q.low, p.high * q.high};
  }
  friend SimdDouble operator/(const SimdDouble& p, const SimdDouble& q) {
    return {p.low / q.low, p.high / q.high};
  }
  friend SimdDouble operator*(double x, const SimdDouble& q) { return {x * q.low, x * q.high}; }
  friend DoubleMask operator<(const SimdDouble& p, const SimdDouble& q) {
    return {less(p.low, q.low), less(p.high, q.high)};
  }
  friend DoubleMask operator>(const SimdDouble& p, const SimdDouble& q) { return q < p; }
  friend DoubleMask operator<(const SimdDouble& p, double x) { return p < of(x); }
  friend DoubleMask operator>(const SimdDouble& p, double x) { return p > of(x); }

  friend SimdDouble magnitude(const SimdDouble& p) {
    return {gcv::magnitude(p.low), gcv::magnitude(p.high)};
  }
  friend SimdDouble smaller(const SimdDouble& p, const SimdDouble& q) {
    return {select(p.low < q.low, p.low, q.low), select(p.high < q.high, p.high, q.high)};
  }
  friend SimdDouble larger(const SimdDouble& p, const SimdDouble& q) {
    return {select(p.low > q.low, p.low, q.low), select(p.high > q.high, p.high, q.high)};
  }
};

// p where the mask is set, else q.
inline SimdDouble select(const DoubleMask& mask, const SimdDouble& p, const SimdDouble& q) {
  return {select(mask.low, p.low, q.low), select(mask.high, p.high, q.high)};
}

// Calls visit(lane) for every bit that is set, from the lowest to the highest.
template <class Visit>
[[gnu::always_inline]] inline void for_each_lane(unsigned lanes, Visit visit) {
  for (; lanes != 0; lanes &= lanes - 1) {
    visit(static_cast<std::uint32_t>(std::countr_zero(lanes)));
  }
}
// The same until a visit returns true. Did one?
template <class Lanes, class Visit>
[[gnu::always_inline]] inline bool any_lane(Lanes lanes, Visit visit) {
  for (; lanes != 0; lanes &= lanes - 1) {
    if (visit(static_cast<std::uint32_t>(std::countr_zero(lanes)))) {
      return true;
    }
  }
  return false;
}

// rounded(p, q) has the floats nearest to p[0], p[1], q[0], q[1]. from<distance>(p, q) has four
// floats in a row of the eight in p and q, from index `distance` on.
#ifdef GCV_SSE2
inline FourFloats rounded(const PairOfDoubles& p, const PairOfDoubles& q) {
  return _mm_movelh_ps(_mm_cvtpd_ps(p), _mm_cvtpd_ps(q));
}
inline unsigned bits_of(const FourMasks& masks) {
  return static_cast<unsigned>(_mm_movemask_ps(std::bit_cast<__m128>(masks)));
}
template <int distance>
FourFloats from(const FourFloats& p, const FourFloats& q) {
  if constexpr (distance == 4) {
    return q;
  } else if constexpr (distance == 2) {
    return _mm_shuffle_ps(p, q, _MM_SHUFFLE(1, 0, 3, 2));
  } else {
    const FourFloats middle = _mm_shuffle_ps(p, q, _MM_SHUFFLE(0, 0, 3, 3));
    return distance == 1 ? _mm_shuffle_ps(p, middle, _MM_SHUFFLE(2, 0, 2, 1))
                         : _mm_shuffle_ps(middle, q, _MM_SHUFFLE(2, 1, 2, 0));
  }
}
#else
inline unsigned bits_of(const FourMasks& masks) {
  return static_cast<unsigned>((masks[0] & 1) | (masks[1] & 2) | (masks[2] & 4) | (masks[3] & 8));
}
inline FourFloats rounded(const PairOfDoubles& p, const PairOfDoubles& q) {
  return FourFloats{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(q[0]),
                    static_cast<float>(q[1])};
}
template <int distance>
FourFloats from(const FourFloats& p, const FourFloats& q) {
  return shuffled<distance, distance + 1, distance + 2, distance + 3>(p, q);
}
#endif

struct FloatMask {
  FourMasks low;
  FourMasks high;

  friend FloatMask operator|(const FloatMask& p, const FloatMask& q) {
    return {p.low | q.low, p.high | q.high};
  }
  // Bit k is set if lane k is.
  [[nodiscard]] unsigned bits() const { return bits_of(low) | bits_of(high) << 4U; }
};

struct SimdFloat {
  using Number = float;
  static constexpr std::uint32_t width = 8;
  static constexpr unsigned all = 255;
  static constexpr Number lowest = -std::numeric_limits<Number>::infinity();
  static constexpr Number highest = std::numeric_limits<Number>::infinity();

  FourFloats low;
  FourFloats high;

  static SimdFloat load(const Number* numbers) {
    SimdFloat lanes;
    std::memcpy(&lanes.low, numbers, sizeof lanes.low);
    std::memcpy(&lanes.high, numbers + 4, sizeof lanes.high);
    return lanes;
  }

  void store(Number* numbers) const {
    std::memcpy(numbers, &low, sizeof low);
    std::memcpy(numbers + 4, &high, sizeof high);
  }

  // Rotates the lanes: lane k gets the number of lane k + distance, modulo 8. The distance is 1 to
  // 4.
  template <int distance>
  [[nodiscard]] SimdFloat turned() const {
    return {from<distance>(low, high), from<distance>(high, low)};
  }

  friend SimdFloat operator+(const SimdFloat& p, Number x) { return {p.low + x, p.high + x}; }
  friend SimdFloat operator-(const SimdFloat& p, Number x) { return {p.low - x, p.high - x}; }
  friend FloatMask operator<(const SimdFloat& p, Number x) { return {p.low < x, p.high < x}; }
  friend FloatMask operator>(const SimdFloat& p, Number x) { return {p.low > x, p.high > x}; }
  friend FloatMask operator>(const SimdFloat& p, const SimdFloat& q) {
    return {p.low > q.low, p.high > q.high};
  }

  friend SimdFloat smaller(const SimdFloat& p, const SimdFloat& q) {
    return {select(p.low < q.low, p.low, q.low), select(p.high < q.high, p.high, q.high)};
  }
  friend SimdFloat larger(const SimdFloat& p, const SimdFloat& q) {
    return {select(p.low > q.low, p.low, q.low), select(p.high > q.high, p.high, q.high)};
  }

  friend Number smallest(const SimdFloat& p) {
    const FourFloats four = select(p.low < p.high, p.low, p.high);
    return std::min(std::min(four[0], four[1]), std::min(four[2], four[3]));
  }
  friend Number largest(const SimdFloat& p) {
    const FourFloats four = select(p.low > p.high, p.low, p.high);
    return std::max(std::max(four[0], four[1]), std::max(four[2], four[3]));
  }
};

// p q / 2^16, rounded down.
#ifdef GCV_SSE2
inline EightShorts high_product(const EightShorts& p, const EightShorts& q) {
  return std::bit_cast<EightShorts>(
      _mm_mulhi_epi16(std::bit_cast<__m128i>(p), std::bit_cast<__m128i>(q)));
}
inline unsigned bits_of(const EightShorts& masks) {
  return static_cast<unsigned>(
      _mm_movemask_epi8(_mm_packs_epi16(std::bit_cast<__m128i>(masks), _mm_setzero_si128())));
}
#else
inline EightShorts high_product(const EightShorts& p, const EightShorts& q) {
  EightShorts product;
  for (std::uint32_t k = 0; k < 8; ++k) {
    product[k] = static_cast<std::int16_t>(p[k] * q[k] >> 16U);
  }
  return product;
}
inline unsigned bits_of(const EightShorts& masks) {
  unsigned bits = 0;
  for (std::uint32_t k = 0; k < 8; ++k) {
    bits |= static_cast<unsigned>(masks[k]) & 1U << k;
  }
  return bits;
}
#endif

struct SimdShort {
  using Number = std::int16_t;
  static constexpr std::uint32_t width = 8;
  static constexpr unsigned all = 255;
  static constexpr Number lowest = std::numeric_limits<Number>::min();
  static constexpr Number highest = std::numeric_limits<Number>::max();

  EightShorts numbers;

  static SimdShort load(const Number* from) {
    SimdShort lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
  }
  // Has the same number in all lanes. The number must be in range.
  static SimdShort of(int x) {
    const auto n = static_cast<Number>(x);
    return {EightShorts{n, n, n, n, n, n, n, n}};
  }

  friend SimdShort operator-(const SimdShort& p, const SimdShort& q) {
    return {p.numbers - q.numbers};
  }
  // p q / 2^16, rounded down.
  friend SimdShort high_product(const SimdShort& p, const SimdShort& q) {
    return {gcv::high_product(p.numbers, q.numbers)};
  }
  friend SimdShort operator|(const SimdShort& p, const SimdShort& q) {
    return {p.numbers | q.numbers};
  }
  friend SimdShort operator<(const SimdShort& p, const SimdShort& q) {
    return {p.numbers < q.numbers};
  }
  friend SimdShort operator>(const SimdShort& p, const SimdShort& q) {
    return {p.numbers > q.numbers};
  }

  friend Number smallest(const SimdShort& p) {
    const EightShorts four = smaller(p.numbers, other_half(p.numbers));
    const EightShorts two = smaller(four, other_quarter(four));
    return std::min(two[0], two[1]);
  }
  friend Number largest(const SimdShort& p) {
    const EightShorts four = larger(p.numbers, other_half(p.numbers));
    const EightShorts two = larger(four, other_quarter(four));
    return std::max(two[0], two[1]);
  }

  // Bit k is set if lane k is. For the results of comparisons only.
  [[nodiscard]] unsigned bits() const { return bits_of(numbers); }

 private:
  static EightShorts smaller(const EightShorts& p, const EightShorts& q) {
    return select(p < q, p, q);
  }
  static EightShorts larger(const EightShorts& p, const EightShorts& q) {
    return select(p > q, p, q);
  }
  static EightShorts other_half(const EightShorts& p) {
    return shuffled<4, 5, 6, 7, 0, 1, 2, 3>(p, p);
  }
  static EightShorts other_quarter(const EightShorts& p) {
    return shuffled<2, 3, 0, 1, 6, 7, 4, 5>(p, p);
  }
};

// A box in the number type of a SIMD vector.
template <class Simd>
struct SimdBox {
  typename Simd::Number x0;
  typename Simd::Number y0;
  typename Simd::Number x1;
  typename Simd::Number y1;
};

// As many boxes as a SIMD vector has lanes, stored side by side.
template <class Numbers, class Box>
struct BoxBlock {
  using Number = decltype(Box::x0);

  Number x0[Numbers::width];
  Number y0[Numbers::width];
  Number x1[Numbers::width];
  Number y1[Numbers::width];

  [[nodiscard]] Box box(std::uint32_t lane) const {
    return {x0[lane], y0[lane], x1[lane], y1[lane]};
  }
  void put(std::uint32_t lane, const Box& box) {
    x0[lane] = box.x0;
    y0[lane] = box.y0;
    x1[lane] = box.x1;
    y1[lane] = box.y1;
  }
  // The bounding box of all.
  [[nodiscard]] Box hull() const {
    return {smallest(Numbers::load(x0)), smallest(Numbers::load(y0)), largest(Numbers::load(x1)),
            largest(Numbers::load(y1))};
  }
  // The lanes whose boxes are apart from the given box. Not set where numbers have overflowed.
  [[nodiscard]] auto apart(const Box& box) const {
    return (Numbers::load(x0) > box.x1) | (Numbers::load(x1) < box.x0) |
           (Numbers::load(y0) > box.y1) | (Numbers::load(y1) < box.y0);
  }
  // The other lanes, as bits.
  [[nodiscard]] unsigned overlapping(const Box& box) const {
    return ~apart(box).bits() & Numbers::all;
  }
  // The lanes whose boxes hold the given box, as bits.
  [[nodiscard]] unsigned around(const Box& box) const {
    const auto outside = (Numbers::load(x0) > box.x0) | (Numbers::load(x1) < box.x1) |
                         (Numbers::load(y0) > box.y0) | (Numbers::load(y1) < box.y1);
    return ~outside.bits() & Numbers::all;
  }
  // Bit k is set if the box of lane k overlaps that of lane k + distance, modulo the width.
  template <int distance>
  [[nodiscard]] unsigned overlapping_at() const {
    const Numbers all_x0 = Numbers::load(x0);
    const Numbers all_y0 = Numbers::load(y0);
    const Numbers all_x1 = Numbers::load(x1);
    const Numbers all_y1 = Numbers::load(y1);
    const auto apart = (all_x0 > all_x1.template turned<distance>()) |
                       (all_x0.template turned<distance>() > all_x1) |
                       (all_y0 > all_y1.template turned<distance>()) |
                       (all_y0.template turned<distance>() > all_y1);
    return ~apart.bits() & Numbers::all;
  }
};

}  // namespace gcv
