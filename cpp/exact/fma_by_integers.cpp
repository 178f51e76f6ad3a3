// SPDX-License-Identifier: LGPL-3.0-or-later
#include "fma_by_integers.hpp"

#include "fma.hpp"

#ifdef __MINGW32__

namespace gcv {

namespace {

[[gnu::target("fma")]] double fma_by_machine(double x, double y, double z) {
  return __builtin_fma(x, y, z);
}

}  // namespace

double fma(double x, double y, double z) {
  static const bool has_instruction = __builtin_cpu_supports("fma") != 0;
  return has_instruction ? fma_by_machine(x, y, z) : fma_by_integers(x, y, z);
}

}  // namespace gcv

#endif
