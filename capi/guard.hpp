// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What stands between the C functions and the core: every entry point runs inside
// `guarded`, which lets no exception through and keeps the caller's floating-point
// environment out of the computation, and the computation out of it.
#pragma once

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstddef>

#include "error.hpp"
#include "gcv/gcv.h"

namespace gcv::capi {

// The calling thread's last message; recording one takes no memory.
const char* last_message() noexcept;
gcv_status record(const Error& error) noexcept;

// Rounding to nearest, subnormal numbers, and no trapping for as long as it lives: the
// exact predicates rest on that, and callers differ (code built with -ffast-math switches
// subnormal numbers off for the whole thread).
class DefaultFloatingPoint {
 public:
  DefaultFloatingPoint() noexcept {
    static_cast<void>(std::fegetenv(&callers_));
    static_cast<void>(std::fesetenv(FE_DFL_ENV));
  }
  ~DefaultFloatingPoint() { static_cast<void>(std::fesetenv(&callers_)); }
  DefaultFloatingPoint(const DefaultFloatingPoint&) = delete;
  DefaultFloatingPoint& operator=(const DefaultFloatingPoint&) = delete;

 private:
  std::fenv_t callers_{};
};

// The exception that is being handled, as an error.
Error current_error() noexcept;

template <class Body>
gcv_status guarded(Body body) noexcept {
  const DefaultFloatingPoint environment;
  try {
    body();
    return GCV_OK;
  } catch (...) {
    return record(current_error());
  }
}

inline void require(const void* pointer, const char* name) {
  if (pointer == nullptr) {
    throw Error(Status::null_argument, "%s is NULL", name);
  }
}

// The buffer contract of gcv.h: fills `out`, the parameter called `name`, with count
// elements by calling write(out) once it is known that they fit.
template <class Element, class Write>
void fill(std::size_t count, const char* elements, const char* name, Element* out,
          std::size_t capacity, std::size_t* required, Write write) {
  require(required, "required");
  if (out == nullptr && capacity != 0) {
    throw Error(Status::null_argument, "%s is NULL, but its capacity is %zu %s", name, capacity,
                elements);
  }
  *required = count;
  if (out == nullptr) {
    return;
  }
  if (capacity < count) {
    throw Error(Status::buffer_too_small, "%s has room for %zu %s, %zu are required", name,
                capacity, elements, count);
  }
  write(out);
}

}  // namespace gcv::capi
