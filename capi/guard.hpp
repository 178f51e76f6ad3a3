// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What stands between the C functions and the core: every entry point runs inside
// `guarded`, which lets no exception through and keeps the caller's floating-point
// environment out of the computation, and the computation out of it; those that copy
// what is there, inside `caught`, which lets no exception through.
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
// subnormal numbers off for the whole thread). The caller's exception flags stay as they are.
class DefaultFloatingPoint {
 public:
  DefaultFloatingPoint() noexcept : control_(control()) {
    is_default_ = is_default(control_);
    if (!is_default_) {
      static_cast<void>(std::fegetenv(&callers_));
      static_cast<void>(std::fesetenv(FE_DFL_ENV));
    }
  }
  ~DefaultFloatingPoint() {
    if (!is_default_) {
      static_cast<void>(std::fesetenv(&callers_));
    } else if (control() != control_) {
      set_control(control_);
    }
  }
  DefaultFloatingPoint(const DefaultFloatingPoint&) = delete;
  DefaultFloatingPoint& operator=(const DefaultFloatingPoint&) = delete;

 private:
#ifdef __x86_64__
  // The register of the unit that all is computed in. To save and set the other one's, whose
  // rounding mode the C library asks for, takes longer than a small sum.
  static unsigned control() { return __builtin_ia32_stmxcsr(); }
  static void set_control(unsigned control) { __builtin_ia32_ldmxcsr(control); }
  static bool is_default(unsigned control) {
    constexpr unsigned flags = 0x3f;
    constexpr unsigned no_traps = 0x1f80;
    return (control & ~flags) == no_traps && std::fegetround() == FE_TONEAREST;
  }
#else
  static unsigned control() { return 0; }
  static void set_control(unsigned /*control*/) {}
  static bool is_default(unsigned /*control*/) { return false; }
#endif

  unsigned control_;
  bool is_default_;
  std::fenv_t callers_;
};

// The exception that is being handled, as an error.
Error current_error() noexcept;

// Of a body that copies and computes nothing.
template <class Body>
gcv_status caught(Body body) noexcept {
  try {
    body();
    return GCV_OK;
  } catch (...) {
    return record(current_error());
  }
}

template <class Body>
gcv_status guarded(Body body) noexcept {
  const DefaultFloatingPoint environment;
  return caught(body);
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
