// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The open sum of two solids: is a place in it?
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Rational_traits.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <optional>
#include <type_traits>
#include <vector>

#include "sum_overlaps.hpp"

namespace gcv::reference::arranged {

// ---- Places

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPoint = Kernel::Point_2;

// CGAL's fractions, whichever of the classes around GMP's it uses.
template <class Fraction>
auto* gmp(Fraction& x) {
  if constexpr (requires { x.get_mpq_t(); }) {
    return x.get_mpq_t();
  } else {
    return x.backend().data();
  }
}

inline Rational rational(const Kernel::FT& x) {
  Rational result;
  mpq_set(result.backend().data(), gmp(x.exact()));
  return result;
}

inline Kernel::FT exact_number(const Rational& x) {
  std::decay_t<decltype(Kernel::FT().exact())> result;
  mpq_set(gmp(result), x.backend().data());
  return Kernel::FT(result);
}

// A place, and about where it is.
struct About {
  double x;
  double y;
  double error;
};

inline About about(const ExactPoint& p) {
  const auto [x0, x1] = CGAL::to_interval(p.x());
  const auto [y0, y1] = CGAL::to_interval(p.y());
  return {x0 + (x1 - x0) / 2, y0 + (y1 - y0) / 2, std::max(x1 - x0, y1 - y0)};
}

// Those of a sum.
struct Summands {
  Solid a;
  Solid b;
};

// All coordinates of the solids are below 2 to this power.
inline int bits(const std::vector<Summands>& sums) {
  int most = 0;
  for (const Summands& sum : sums) {
    for (const Solid* solid : {&sum.a, &sum.b}) {
      for (const auto& p : solid->vertices) {
        most = std::max({most, bits(p.x), bits(p.y)});
      }
    }
  }
  return most;
}

// Asks whether places are in the open sum. Solids are 2^bits times as large as places are, with the
// bits of their largest coordinate. So all coordinates of places are small.
class OpenSum {
 public:
  OpenSum(const Summands& sum, int bits) : exact_(make_overlaps(sum.a, sum.b)), bits_(bits) {
    if (bits_ < 60) {
      wide_ = wide(exact_);
    }
    const auto vector = [&](const auto& p) { return Vector<double>{rounded(p.x), rounded(p.y)}; };
    for (const auto& p : exact_.crossings) {
      const auto u = vector(p.u);
      const auto v = vector(p.v);
      rounded_.push_back({vector(p.corner), u, v, cross(u, v)});
    }
  }

  // Where edges are sure to cross; else unknown.
  bool surely_covers(const About& place) {
    // All coordinates are at most 2, rounded by an ulp or two.
    const double error = 64 * place.error + 1024 * DBL_EPSILON;
    const std::size_t n = rounded_.size();
    for (std::size_t k = 0; k < n; ++k) {
      const auto& p = rounded_[(last_ + k) % n];
      const Vector<double> d{place.x - p.corner.x, place.y - p.corner.y};
      const double s = cross(d, p.v);
      const double t = cross(p.u, d);
      if (s > error && t > error && p.area - s > error && p.area - t > error) {
        last_ = (last_ + k) % n;
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool covers(const Rational& x, const Rational& y) const {
    const Integer dx = denominator(x);
    const Integer dy = denominator(y);
    const Integer w = lcm(dx, dy);
    return covers({Integer((numerator(x) << bits_) * (w / dx)),
                   Integer((numerator(y) << bits_) * (w / dy)), w});
  }

  [[nodiscard]] bool covers(const Homogeneous<Integer>& place) const {
    const int xy = std::max(bits(place.x), bits(place.y));
    const int w = bits(place.w);
    if (wide_ && std::max(xy, w) < 63 && std::max(xy, w + bits_ + 1) + bits_ + 5 < 126) {
      return wide_->covers({place.x.convert_to<std::int64_t>(), place.y.convert_to<std::int64_t>(),
                            place.w.convert_to<std::int64_t>()});
    }
    return exact_.covers(place);
  }

 private:
  Overlaps<Integer> exact_;
  std::optional<Overlaps<Wide>> wide_;
  std::vector<Overlaps<double>::Parallelogram> rounded_;
  int bits_;
  std::size_t last_ = 0;

  [[nodiscard]] double rounded(const Integer& n) const {
    const int dropped = std::max(bits(n) - 64, 0);
    return std::ldexp(Integer(n >> static_cast<unsigned>(dropped)).convert_to<double>(),
                      dropped - bits_);
  }
};

}  // namespace gcv::reference::arranged
