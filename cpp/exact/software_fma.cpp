// SPDX-License-Identifier: LGPL-3.0-or-later
#include "software_fma.hpp"

#include "fma.hpp"

#if defined(__MINGW32__) || defined(__wasm__)

namespace gcv {

#ifdef __MINGW32__

namespace {

[[gnu::target("fma")]] double fma_by_machine(double x, double y, double z) {
  return __builtin_fma(x, y, z);
}

}  // namespace

double fma(double x, double y, double z) {
  static const bool has_instruction = __builtin_cpu_supports("fma") != 0;
  return has_instruction ? fma_by_machine(x, y, z) : software_fma(x, y, z);
}

#else

double fma(double x, double y, double z) { return software_fma(x, y, z); }

#endif

}  // namespace gcv

#endif
