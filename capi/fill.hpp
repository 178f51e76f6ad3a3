// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Writes results to the caller's memory.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>

#include "error.hpp"
#include "guard.hpp"
#include "point.hpp"

namespace gcv::capi {

// Fills the parameter `out`, whose name is `name`, with `count` elements. Follows the buffer
// contract of gcv.h. Calls write(out) only if there are elements and
// they fit.
template <class Element, class Write>
void fill(std::size_t count, const char* elements, const char* name, Element* out,
          std::size_t capacity, std::size_t* required, Write write) {
  require(required, "required");
  if (out == nullptr && capacity != 0) {
    throw Error(Status::null_argument, "%s is NULL, but its capacity is %zu %s", name, capacity,
                elements);
  }
  *required = count;
  if (out == nullptr || count == 0) {
    return;
  }
  if (capacity < count) {
    throw Error(Status::buffer_too_small, "%s has room for %zu %s, %zu are required", name,
                capacity, elements, count);
  }
  write(out);
}

inline void fill_points(const PointVector& points, double* xy, std::size_t capacity,
                        std::size_t* required) {
  fill(points.size(), "vertices", "xy", xy, capacity, required,
       [&](double* out) { std::memcpy(out, points.data(), points.size() * sizeof(Point)); });
}

inline void fill_text(const std::string& text, char* out, std::size_t capacity,
                      std::size_t* required) {
  fill(text.size() + 1, "bytes", "text", out, capacity, required,
       [&](char* to) { std::memcpy(to, text.c_str(), text.size() + 1); });
}

// Writes `value` to *out. Throws Error: range, if it is not finite.
inline void give_finite(double value, const char* what, double* out) {
  if (!std::isfinite(value)) {
    throw Error(Status::range, "%s is beyond the largest double", what);
  }
  *out = value;
}

}  // namespace gcv::capi
