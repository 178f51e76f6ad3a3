// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What g++ and clang have beyond the standard: vectors of numbers, integers of 128 bits, and memory
// fetched ahead. Other compilers get arrays with the same operations and the same bits, and no such
// integers: cpp/exact takes Boost's there. GCV_STANDARD_ONLY asks for that from all compilers, for
// the tests.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#if (defined(__GNUC__) || defined(__clang__)) && !defined(GCV_STANDARD_ONLY)

namespace gcv {

using PairOfDoubles [[gnu::vector_size(16)]] = double;
using PairOfMasks [[gnu::vector_size(16)]] = std::int64_t;
using FourFloats [[gnu::vector_size(16)]] = float;
using FourMasks [[gnu::vector_size(16)]] = std::int32_t;
using FourShorts [[gnu::vector_size(8)]] = std::int16_t;
using EightShorts [[gnu::vector_size(16)]] = std::int16_t;

// The lanes of p where the mask is -1, and those of q where it is 0.
template <class Mask, class Vector>
[[gnu::always_inline]] inline Vector select(const Mask& mask, const Vector& p, const Vector& q) {
  return mask ? p : q;
}

// The lanes of p and q with these indices, those of q counted on from those of p.
template <int... lanes, class Vector>
[[gnu::always_inline]] inline Vector shuffled(const Vector& p, const Vector& q) {
  return __builtin_shufflevector(p, q, lanes...);
}

// What is there will be read soon.
inline void prefetch(const void* address) { __builtin_prefetch(address); }

}  // namespace gcv

#ifdef __SSE2__
#define GCV_SSE2 1
#endif

#ifdef __SIZEOF_INT128__
#define GCV_INT128 1
namespace gcv {
// NOLINTNEXTLINE(modernize-use-using): `using` has no place for __extension__.
__extension__ typedef __int128 Int128;
}  // namespace gcv
#endif

#else

namespace gcv {

inline void prefetch(const void* /*address*/) {}

template <class Number, std::size_t size>
struct alignas(size * sizeof(Number)) Lanes {
  using Mask = Lanes<
      std::conditional_t<sizeof(Number) == 8, std::int64_t,
                         std::conditional_t<sizeof(Number) == 4, std::int32_t, std::int16_t> >,
      size>;

  Number numbers[size];

  constexpr Number operator[](std::size_t lane) const { return numbers[lane]; }
  constexpr Number& operator[](std::size_t lane) { return numbers[lane]; }

  // Has of(lane) in each lane.
  static constexpr Lanes each(std::invocable<std::size_t> auto of) {
    Lanes lanes{};
    for (std::size_t lane = 0; lane < size; ++lane) {
      lanes[lane] = static_cast<Number>(of(lane));
    }
    return lanes;
  }

  friend Lanes operator+(const Lanes& p, const Lanes& q) {
    return each([&](std::size_t k) { return p[k] + q[k]; });
  }
  friend Lanes operator-(const Lanes& p, const Lanes& q) {
    return each([&](std::size_t k) { return p[k] - q[k]; });
  }
  friend Lanes operator*(const Lanes& p, const Lanes& q) {
    return each([&](std::size_t k) { return p[k] * q[k]; });
  }
  friend Lanes operator/(const Lanes& p, const Lanes& q) {
    return each([&](std::size_t k) { return p[k] / q[k]; });
  }
  friend Lanes operator|(const Lanes& p, const Lanes& q) {
    return each([&](std::size_t k) { return p[k] | q[k]; });
  }
  friend Lanes operator&(const Lanes& p, const Lanes& q) {
    return each([&](std::size_t k) { return p[k] & q[k]; });
  }
  friend Mask operator<(const Lanes& p, const Lanes& q) {
    return Mask::each([&](std::size_t k) { return p[k] < q[k] ? -1 : 0; });
  }
  friend Mask operator>(const Lanes& p, const Lanes& q) { return q < p; }
  friend Mask operator!=(const Lanes& p, const Lanes& q) {
    return Mask::each([&](std::size_t k) { return p[k] != q[k] ? -1 : 0; });
  }

  // With one number for all lanes.
  friend Lanes operator+(const Lanes& p, Number x) { return p + of(x); }
  friend Lanes operator-(const Lanes& p, Number x) { return p - of(x); }
  friend Lanes operator-(Number x, const Lanes& p) { return of(x) - p; }
  friend Lanes operator*(Number x, const Lanes& p) { return of(x) * p; }
  friend Lanes operator/(Number x, const Lanes& p) { return of(x) / p; }
  friend Mask operator<(const Lanes& p, Number x) { return p < of(x); }
  friend Mask operator>(const Lanes& p, Number x) { return p > of(x); }

 private:
  static Lanes of(Number x) {
    return each([&](std::size_t /*lane*/) { return x; });
  }
};

using PairOfDoubles = Lanes<double, 2>;
using PairOfMasks = Lanes<std::int64_t, 2>;
using FourFloats = Lanes<float, 4>;
using FourMasks = Lanes<std::int32_t, 4>;
using FourShorts = Lanes<std::int16_t, 4>;
using EightShorts = Lanes<std::int16_t, 8>;

template <class Number, std::size_t size>
Lanes<Number, size> select(const typename Lanes<Number, size>::Mask& mask,
                           const Lanes<Number, size>& p, const Lanes<Number, size>& q) {
  return p.each([&](std::size_t k) { return mask[k] != 0 ? p[k] : q[k]; });
}

template <int... lanes, class Number, std::size_t size>
Lanes<Number, size> shuffled(const Lanes<Number, size>& p, const Lanes<Number, size>& q) {
  constexpr std::size_t indices[] = {lanes...};
  return p.each(
      [&](std::size_t k) { return indices[k] < size ? p[indices[k]] : q[indices[k] - size]; });
}

}  // namespace gcv

#endif
