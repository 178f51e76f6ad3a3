// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Sums of doubles, exactly.
#pragma once

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "ball.hpp"
#include "double_double.hpp"
#include "fma.hpp"
#include "point.hpp"

namespace gcv {

// The sum of at most `capacity` doubles. Its parts do not overlap, and each is smaller than the
// next. Source: Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates, section 2.4.
template <std::size_t capacity>
class Expansion {
 public:
  Expansion() = default;
  explicit Expansion(const std::array<double, capacity>& numbers) {
    for (const double number : numbers) {
      add(number);
    }
  }

  void add(double number) {
    if (number == 0) {
      return;
    }
    std::size_t kept = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      const double sum = number + parts_[k];
      const double error = rounding_error(number, parts_[k], sum);
      number = sum;
      if (error != 0) {
        parts_[kept++] = error;
      }
    }
    if (number != 0) {
      assert(kept < capacity);
      parts_[kept++] = number;
    }
    count_ = kept;
  }
  // Adds x y. Exact where x is 0, 1 or -1, or both are as has_exact_products() asks.
  void add_product(double x, double y) {
    const double product = x * y;
    add(gcv::fma(x, y, -product));
    add(product);
  }
  // The same with sums.
  template <std::size_t other>
  void add_product(double x, const Expansion<other>& y) {
    for (std::size_t k = 0; k < y.count_; ++k) {
      add_product(x, y.parts_[k]);
    }
  }
  template <std::size_t first, std::size_t second>
  void add_product(const Expansion<first>& x, const Expansion<second>& y) {
    for (std::size_t k = 0; k < x.count_; ++k) {
      add_product(x.parts_[k], y);
    }
  }
  template <std::size_t first, std::size_t second>
  void subtract_product(const Expansion<first>& x, const Expansion<second>& y) {
    for (std::size_t k = 0; k < x.count_; ++k) {
      add_product(-x.parts_[k], y);
    }
  }

  // False where a sum has overflown. Then nothing else holds.
  [[nodiscard]] bool is_finite() const {
    double sum = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      sum += parts_[k];
    }
    return std::isfinite(sum);
  }
  // Are all parts so far from underflow and overflow that products of two of these are exact?
  [[nodiscard]] bool has_exact_products() const {
    bool are_in_range = true;
    for (std::size_t k = 0; k < count_; ++k) {
      const double size = std::abs(parts_[k]);
      are_in_range = are_in_range && size >= 0x1p-400 && size <= 0x1p400;
    }
    return are_in_range;
  }

  [[nodiscard]] int sign() const { return count_ == 0 ? 0 : parts_[count_ - 1] > 0 ? 1 : -1; }

  // Its first two doubles. What they leave out is below 2u^2 of it.
  [[nodiscard]] Ball leading() const {
    std::size_t k = count_;
    // What was summed and the parts below k, up to where `rest` is left over.
    const auto next = [&](double sum, double& rest) {
      for (rest = 0; k > 0 && rest == 0;) {
        const double part = parts_[--k];
        const double larger = sum + part;
        rest = rounding_error(sum, part, larger);
        sum = larger;
      }
      return sum;
    };
    double lo = 0;
    const double hi = next(0, lo);
    double left_out = 0;
    lo = next(lo, left_out);
    return Ball::normal(hi, lo, 2 * std::abs(left_out));
  }

 private:
  template <std::size_t other>
  friend class Expansion;

  std::array<double, capacity> parts_;  // the first of them
  std::size_t count_ = 0;
};

// The vector from one point to another.
struct ExactVector {
  ExactVector(const SumPoint& from, const SumPoint& to)
      : x({to.a.x, -from.a.x, to.b.x, -from.b.x, to.c.x, -from.c.x}),
        y({to.a.y, -from.a.y, to.b.y, -from.b.y, to.c.y, -from.c.y}) {}

  // If not, nothing else holds.
  [[nodiscard]] bool is_finite() const { return x.is_finite() && y.is_finite(); }
  [[nodiscard]] bool has_exact_products() const {
    return x.has_exact_products() && y.has_exact_products();
  }

  Expansion<6> x;
  Expansion<6> y;
};

}  // namespace gcv
