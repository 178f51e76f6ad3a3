// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Four numbers side by side, as two vectors of two, which all common machines have
// instructions for: each operation is that of four separate numbers, to the bit.
#pragma once

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

}  // namespace gcv
