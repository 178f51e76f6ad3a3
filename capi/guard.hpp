// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The guard between the C functions and the core. Every function that can fail runs inside
// `guarded`. No exception gets out. The work is done in the default floating-point environment, and
// the caller's environment is restored.
#pragma once

#if defined(__x86_64__) || defined(_M_X64)
#define GCV_SSE
#include <xmmintrin.h>
#endif

#include <cfenv>

#include "error.hpp"
#include "gcv/gcv.h"

namespace gcv::capi {

// The last message of the calling thread. record() replaces it and needs no memory.
const char* last_message() noexcept;
gcv_status record(const Error& error) noexcept;

// While an object of this class lives: rounding to nearest, subnormal numbers, no trapping. The
// exact predicates need these. Callers may have others: code built with -ffast-math switches
// subnormal numbers off for the whole thread. The caller's exception flags do not change.
class DefaultFloatingPoint {
 public:
  DefaultFloatingPoint() noexcept : control_(control()) {
    is_default_ = is_default(control_);
    if (!is_default_) {
      static_cast<void>(std::fegetenv(&callers_));
      static_cast<void>(std::fesetenv(FE_DFL_ENV));
      set_control(default_control);  // the functions of mingw-w64 do not set all of it
    }
  }
  ~DefaultFloatingPoint() {
    if (!is_default_) {
      static_cast<void>(std::fesetenv(&callers_));
    }
    if (control() != control_) {
      set_control(control_);
    }
  }
  DefaultFloatingPoint(const DefaultFloatingPoint&) = delete;
  DefaultFloatingPoint& operator=(const DefaultFloatingPoint&) = delete;

 private:
#ifdef GCV_SSE
  // The control register of SSE, in which everything is computed. The C library would also save and
  // set that of the x87 unit. That takes longer than a small sum.
  static constexpr unsigned default_control = 0x1f80;
  static unsigned control() { return _mm_getcsr(); }
  static void set_control(unsigned control) { _mm_setcsr(control); }
  static bool is_default(unsigned control) {
    constexpr unsigned flags = 0x3f;
    return (control & ~flags) == default_control && std::fegetround() == FE_TONEAREST;
  }
#else
  static constexpr unsigned default_control = 0;
  static unsigned control() { return 0; }
  static void set_control(unsigned /*control*/) {}
  static bool is_default(unsigned /*control*/) { return false; }
#endif

  unsigned control_;
  bool is_default_;
  std::fenv_t callers_;
};

// For functions that only copy. To enter the default environment takes several times as long as
// they do.
struct CallersFloatingPoint {};

// Runs the body of a C function and returns its status.
template <class Environment = DefaultFloatingPoint, class Body>
gcv_status guarded(Body body) noexcept {
  [[maybe_unused]] const Environment environment{};
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

// Throws Error: invalid_argument for more elements of that size than an array can hold.
inline void require_count(std::size_t count, std::size_t size, const char* name) {
  if (count > PTRDIFF_MAX / size) {
    throw Error(Status::invalid_argument, "%s: %zu are more than an array can hold", name, count);
  }
}

}  // namespace gcv::capi
