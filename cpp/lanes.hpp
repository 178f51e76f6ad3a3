// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Four doubles, eight floats or eight integers of 16 bits side by side, as vectors of 16 bytes,
// which all common machines have instructions for: each operation is that of separate numbers, to
// the bit.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

namespace gcv {

using PairOfDoubles [[gnu::vector_size(16)]] = double;
using PairOfMasks [[gnu::vector_size(16)]] = std::int64_t;

struct DoubleMask {
  PairOfMasks low;
  PairOfMasks high;

  friend DoubleMask operator|(const DoubleMask& p, const DoubleMask& q) {
    return {p.low | q.low, p.high | q.high};
  }
  // Bit k is set where lane k is.
  [[nodiscard]] unsigned bits() const {
    return static_cast<unsigned>((low[0] & 1) | (low[1] & 2) | (high[0] & 4) | (high[1] & 8));
  }
};

struct DoubleLanes {
  static constexpr std::uint32_t width = 4;
  static constexpr unsigned all = 15;

  PairOfDoubles low;
  PairOfDoubles high;

  static DoubleLanes load(const double* numbers) {
    DoubleLanes lanes;
    std::memcpy(&lanes, numbers, sizeof lanes);
    return lanes;
  }
  void store(double* numbers) const { std::memcpy(numbers, this, sizeof *this); }

  friend DoubleLanes operator+(const DoubleLanes& p, const DoubleLanes& q) {
    return {p.low + q.low, p.high + q.high};
  }
  friend DoubleLanes operator-(const DoubleLanes& p, const DoubleLanes& q) {
    return {p.low - q.low, p.high - q.high};
  }
  friend DoubleLanes operator+(const DoubleLanes& p, double x) { return {p.low + x, p.high + x}; }
  friend DoubleLanes operator*(const DoubleLanes& p, const DoubleLanes& q) {
    return {p.low * q.low, p.high * q.high};
  }
  friend DoubleLanes operator*(double x, const DoubleLanes& q) { return {x * q.low, x * q.high}; }
  friend DoubleMask operator<(const DoubleLanes& p, const DoubleLanes& q) {
    return {p.low < q.low, p.high < q.high};
  }
  friend DoubleMask operator>(const DoubleLanes& p, const DoubleLanes& q) {
    return {p.low > q.low, p.high > q.high};
  }
  friend DoubleMask operator<(const DoubleLanes& p, double x) { return {p.low < x, p.high < x}; }
  friend DoubleMask operator>(const DoubleLanes& p, double x) { return {p.low > x, p.high > x}; }

  friend DoubleLanes magnitude(const DoubleLanes& p) {
    return {p.low < 0 ? -p.low : p.low, p.high < 0 ? -p.high : p.high};
  }
  friend DoubleLanes smaller(const DoubleLanes& p, const DoubleLanes& q) {
    return {p.low < q.low ? p.low : q.low, p.high < q.high ? p.high : q.high};
  }
  friend DoubleLanes larger(const DoubleLanes& p, const DoubleLanes& q) {
    return {p.low > q.low ? p.low : q.low, p.high > q.high ? p.high : q.high};
  }
};

// Calls visit(lane) for every bit that is set, the lowest first.
template <class Visit>
void for_each_lane(unsigned lanes, Visit visit) {
  for (; lanes != 0; lanes &= lanes - 1) {
    visit(static_cast<std::uint32_t>(std::countr_zero(lanes)));
  }
}

using FourFloats [[gnu::vector_size(16)]] = float;
using FourMasks [[gnu::vector_size(16)]] = std::int32_t;

struct FloatMask {
  FourMasks low;
  FourMasks high;

  friend FloatMask operator|(const FloatMask& p, const FloatMask& q) {
    return {p.low | q.low, p.high | q.high};
  }
  // Bit k is set where lane k is.
  [[nodiscard]] unsigned bits() const {
    constexpr FourMasks low_bits{1, 2, 4, 8};
    constexpr FourMasks high_bits{16, 32, 64, 128};
    const FourMasks all = (low & low_bits) | (high & high_bits);
    std::uint64_t halves[2];
    std::memcpy(halves, &all, sizeof all);
    const std::uint64_t both = halves[0] | halves[1];
    return static_cast<unsigned>(both | both >> 32U);
  }
};

struct FloatLanes {
  using Number = float;
  static constexpr std::uint32_t width = 8;
  static constexpr unsigned all = 255;
  static constexpr Number lowest = -std::numeric_limits<Number>::infinity();
  static constexpr Number highest = std::numeric_limits<Number>::infinity();

  FourFloats low;
  FourFloats high;

  static FloatLanes load(const Number* numbers) {
    FloatLanes lanes;
    std::memcpy(&lanes, numbers, sizeof lanes);
    return lanes;
  }

  friend FloatMask operator<(const FloatLanes& p, Number x) { return {p.low < x, p.high < x}; }
  friend FloatMask operator>(const FloatLanes& p, Number x) { return {p.low > x, p.high > x}; }

  friend Number smallest(const FloatLanes& p) {
    const FourFloats four = p.low < p.high ? p.low : p.high;
    return std::min(std::min(four[0], four[1]), std::min(four[2], four[3]));
  }
  friend Number largest(const FloatLanes& p) {
    const FourFloats four = p.low > p.high ? p.low : p.high;
    return std::max(std::max(four[0], four[1]), std::max(four[2], four[3]));
  }
};

using FourShorts [[gnu::vector_size(8)]] = std::int16_t;
using EightShorts [[gnu::vector_size(16)]] = std::int16_t;

// Comparisons give lanes of -1 where they hold, else 0.
struct ShortLanes {
  using Number = std::int16_t;
  static constexpr std::uint32_t width = 8;
  static constexpr unsigned all = 255;
  static constexpr Number lowest = std::numeric_limits<Number>::min();
  static constexpr Number highest = std::numeric_limits<Number>::max();

  EightShorts numbers;

  static ShortLanes load(const Number* from) {
    ShortLanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
  }
  // The same number, which is in range, in all lanes.
  static ShortLanes of(int x) {
    const auto n = static_cast<Number>(x);
    return {EightShorts{n, n, n, n, n, n, n, n}};
  }

  friend ShortLanes operator-(const ShortLanes& p, const ShortLanes& q) {
    return {p.numbers - q.numbers};
  }
  // p q / 2^16, rounded down.
  friend ShortLanes high_product(const ShortLanes& p, const ShortLanes& q) {
    ShortLanes product;
    for (std::uint32_t lane = 0; lane < width; ++lane) {
      product.numbers[lane] = static_cast<Number>(p.numbers[lane] * q.numbers[lane] >> 16U);
    }
    return product;
  }
  friend ShortLanes operator|(const ShortLanes& p, const ShortLanes& q) {
    return {p.numbers | q.numbers};
  }
  friend ShortLanes operator<(const ShortLanes& p, const ShortLanes& q) {
    return {p.numbers < q.numbers};
  }
  friend ShortLanes operator>(const ShortLanes& p, const ShortLanes& q) {
    return {p.numbers > q.numbers};
  }

  friend Number smallest(const ShortLanes& p) {
    const EightShorts four = smaller(p.numbers, other_half(p.numbers));
    const EightShorts two = smaller(four, other_quarter(four));
    return std::min(two[0], two[1]);
  }
  friend Number largest(const ShortLanes& p) {
    const EightShorts four = larger(p.numbers, other_half(p.numbers));
    const EightShorts two = larger(four, other_quarter(four));
    return std::max(two[0], two[1]);
  }

  // Of what comparisons give: bit k is set where lane k is.
  [[nodiscard]] unsigned bits() const {
    using EightBytes [[gnu::vector_size(8)]] = std::int8_t;
    constexpr std::uint64_t bit_of_each =
        std::endian::native == std::endian::little ? 0x8040201008040201U : 0x0102040810204080U;
    const auto bytes = std::bit_cast<std::uint64_t>(__builtin_convertvector(numbers, EightBytes));
    return static_cast<unsigned>((bytes & bit_of_each) * 0x0101010101010101U >> 56U);
  }

 private:
  static EightShorts smaller(const EightShorts& p, const EightShorts& q) { return p < q ? p : q; }
  static EightShorts larger(const EightShorts& p, const EightShorts& q) { return p > q ? p : q; }
  static EightShorts other_half(const EightShorts& p) {
    return __builtin_shufflevector(p, p, 4, 5, 6, 7, 0, 1, 2, 3);
  }
  static EightShorts other_quarter(const EightShorts& p) {
    return __builtin_shufflevector(p, p, 2, 3, 0, 1, 6, 7, 4, 5);
  }
};

// A box in the numbers of some lanes.
template <class Lanes>
struct LaneBox {
  typename Lanes::Number x0;
  typename Lanes::Number y0;
  typename Lanes::Number x1;
  typename Lanes::Number y1;
};

// As many boxes as there are lanes, side by side.
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
  // The box of all.
  [[nodiscard]] Box hull() const {
    return {smallest(Numbers::load(x0)), smallest(Numbers::load(y0)), largest(Numbers::load(x1)),
            largest(Numbers::load(y1))};
  }
  // The lanes whose boxes overlap the given one, as bits; all, where numbers have overflowed.
  [[nodiscard]] unsigned overlapping(const Box& box) const {
    return ~((Numbers::load(x0) > box.x1) | (Numbers::load(x1) < box.x0) |
             (Numbers::load(y0) > box.y1) | (Numbers::load(y1) < box.y0))
                .bits() &
           Numbers::all;
  }
};

}  // namespace gcv
