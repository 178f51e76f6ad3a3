// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Four doubles or eight floats side by side, as two vectors of 16 bytes, which all common
// machines have instructions for: each operation is that of separate numbers, to the bit.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace gcv {

using PairOfDoubles [[gnu::vector_size(16)]] = double;
using PairOfMasks [[gnu::vector_size(16)]] = std::int64_t;

struct LaneMask {
  PairOfMasks low;
  PairOfMasks high;

  friend LaneMask operator|(const LaneMask& p, const LaneMask& q) {
    return {p.low | q.low, p.high | q.high};
  }
  // Bit k is set where lane k is.
  [[nodiscard]] unsigned bits() const {
    return static_cast<unsigned>((low[0] & 1) | (low[1] & 2) | (high[0] & 4) | (high[1] & 8));
  }
};

struct Lanes {
  static constexpr std::uint32_t width = 4;
  static constexpr unsigned all = 15;

  PairOfDoubles low;
  PairOfDoubles high;

  static Lanes load(const double* numbers) {
    Lanes lanes;
    std::memcpy(&lanes, numbers, sizeof lanes);
    return lanes;
  }
  void store(double* numbers) const { std::memcpy(numbers, this, sizeof *this); }

  friend Lanes operator+(const Lanes& p, const Lanes& q) {
    return {p.low + q.low, p.high + q.high};
  }
  friend Lanes operator-(const Lanes& p, const Lanes& q) {
    return {p.low - q.low, p.high - q.high};
  }
  friend Lanes operator+(const Lanes& p, double x) { return {p.low + x, p.high + x}; }
  friend Lanes operator*(const Lanes& p, const Lanes& q) {
    return {p.low * q.low, p.high * q.high};
  }
  friend Lanes operator*(double x, const Lanes& q) { return {x * q.low, x * q.high}; }
  friend LaneMask operator<(const Lanes& p, const Lanes& q) {
    return {p.low < q.low, p.high < q.high};
  }
  friend LaneMask operator>(const Lanes& p, const Lanes& q) {
    return {p.low > q.low, p.high > q.high};
  }
  friend LaneMask operator<(const Lanes& p, double x) { return {p.low < x, p.high < x}; }
  friend LaneMask operator>(const Lanes& p, double x) { return {p.low > x, p.high > x}; }

  friend Lanes magnitude(const Lanes& p) {
    return {p.low < 0 ? -p.low : p.low, p.high < 0 ? -p.high : p.high};
  }
  friend Lanes smaller(const Lanes& p, const Lanes& q) {
    return {p.low < q.low ? p.low : q.low, p.high < q.high ? p.high : q.high};
  }
  friend Lanes larger(const Lanes& p, const Lanes& q) {
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

struct EightMask {
  FourMasks low;
  FourMasks high;

  friend EightMask operator|(const EightMask& p, const EightMask& q) {
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

struct EightLanes {
  static constexpr std::uint32_t width = 8;
  static constexpr unsigned all = 255;

  FourFloats low;
  FourFloats high;

  static EightLanes load(const float* numbers) {
    EightLanes lanes;
    std::memcpy(&lanes, numbers, sizeof lanes);
    return lanes;
  }

  friend EightLanes operator-(const EightLanes& p, const EightLanes& q) {
    return {p.low - q.low, p.high - q.high};
  }
  friend EightLanes operator*(float x, const EightLanes& q) { return {x * q.low, x * q.high}; }
  friend EightMask operator<(const EightLanes& p, float x) { return {p.low < x, p.high < x}; }
  friend EightMask operator>(const EightLanes& p, float x) { return {p.low > x, p.high > x}; }
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
  // The lanes whose boxes overlap the given one, as bits; all, where numbers have overflowed.
  [[nodiscard]] unsigned overlapping(const Box& box) const {
    return ~((Numbers::load(x0) > box.x1) | (Numbers::load(x1) < box.x0) |
             (Numbers::load(y0) > box.y1) | (Numbers::load(y1) < box.y0))
                .bits() &
           Numbers::all;
  }
};

// A power of two by which the extents become 1 at most, and above 1/4 unless they are next to
// nothing; 0 where they have overflowed.
inline double scale_to_one(double extents) {
  return std::isfinite(extents) ? std::ldexp(1.0, -std::max(std::ilogb(extents), -1000) - 1) : 0;
}

}  // namespace gcv
