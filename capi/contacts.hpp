// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What questions about two polygons take and give: vectors and contacts.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "contact.hpp"
#include "error.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "point.hpp"

namespace gcv::capi {

// `count` vectors of the caller: x0 y0 x1 y1 ...
class Vectors {
 public:
  // `result`: the size of what there will be for each. Throws Error: not_finite, with the name and
  // the number of the vector; as require_count().
  Vectors(const double* xy, std::size_t count, const char* name, std::size_t result = 0) : xy_(xy) {
    require_count(count, std::max(sizeof(Point), result), name);
    for (std::size_t k = 0; k < count; ++k) {
      const Point p = (*this)[k];
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
        throw Error(Status::not_finite, "%s: number %zu is (%g, %g), not finite", name, k, p.x,
                    p.y);
      }
    }
  }
  // With 0 in place of -0.
  Point operator[](std::size_t k) const { return {xy_[2 * k] + 0.0, xy_[2 * k + 1] + 0.0}; }

 private:
  const double* xy_;
};

inline gcv_contact public_contact(const Contact& contact, std::uint64_t id_a = 0,
                                  std::uint64_t id_b = 0) {
  const auto& [kind, a, b, gap, normal, on_a, on_b] = contact;
  return {static_cast<std::int32_t>(kind),
          a,
          b,
          0,
          id_a,
          id_b,
          gap,
          {normal.x, normal.y},
          {on_a.x, on_a.y},
          {on_b.x, on_b.y}};
}

// Throws Error: not_finite, invalid_argument.
inline void require_size(double x, const char* name) {
  if (!std::isfinite(x)) {
    throw Error(Status::not_finite, "%s is %g, not finite", name, x);
  }
  if (x < 0) {
    throw Error(Status::invalid_argument, "%s is %g, it must not be negative", name, x);
  }
}

// Is a number of the contact beyond the largest double?
inline bool is_out_of_range(const Contact& contact) {
  const auto numbers = {contact.gap, contact.on_a.x, contact.on_a.y, contact.on_b.x,
                        contact.on_b.y};
  return std::any_of(numbers.begin(), numbers.end(), [](double x) { return !std::isfinite(x); });
}

}  // namespace gcv::capi
